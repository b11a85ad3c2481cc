//! What the documents say that a dialect has, where more than one part of the crate asks.

use stickler_types::{BuiltIn, DialectName};

/// Whether a dialect has the elementary types of the third edition.
///
/// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax (the editions of its dialects); ironplc-problem-codes: P0010;
/// stickler-design: §8.
pub(crate) const fn has_third_edition(dialect: DialectName) -> bool {
    !matches!(dialect.base(), BuiltIn::IronplcEd2 | BuiltIn::Matiec)
}

/// Whether a dialect's documents know access to single bits.
///
/// Basis: ironplc-bit-access: Valid Base Types; stickler-design: §8 (syntax error in matiec, open in PLCnext).
pub(crate) const fn has_bits(dialect: DialectName) -> bool {
    matches!(
        dialect.base(),
        BuiltIn::IronplcEd2 | BuiltIn::IronplcEd3 | BuiltIn::IronplcRusty
    )
}

/// Whether a dialect knows `.%Xn`.
///
/// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax; stickler-design: §8.
pub(crate) const fn has_partial_access(dialect: DialectName) -> bool {
    matches!(dialect.base(), BuiltIn::IronplcEd3 | BuiltIn::IronplcRusty)
}
