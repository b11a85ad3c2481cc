//! Properties of dialects, as documents state them, that more than one part of the crate asks for.

use stickler_types::{Dialect, DialectName, ElementaryType};

/// Returns whether a dialect has an elementary type, which the third edition may have added.
pub(crate) fn has_type(dialect: DialectName, ty: ElementaryType) -> bool {
    Dialect::of(dialect).has(ty)
}

/// Returns whether the documents of a dialect know access to single bits.
pub(crate) fn has_bits(dialect: DialectName) -> bool {
    dialect.rules().documents.bits
}

/// Returns whether the documents of a dialect know `.%Xn`.
pub(crate) fn has_partial_access(dialect: DialectName) -> bool {
    dialect.rules().documents.partial_access
}
