//! Properties of dialects, as documents state them, that more than one part of the crate asks for.

use stickler_types::{BuiltIn, DialectName, ElementaryType};

/// Returns whether a dialect has an elementary type, which the third edition may have added.
///
/// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax (the editions of its dialects); ironplc-problem-codes: P0010;
/// matiec follows the second edition; twincat-builds: recordings/twincat.build.json (no LDATE, LTOD, LDT).
pub(crate) fn has_type(dialect: DialectName, ty: ElementaryType) -> bool {
    !ty.is_third_edition()
        || match dialect.base() {
            BuiltIn::IronplcEd2 | BuiltIn::Matiec => false,
            BuiltIn::Twincat => !ty.is_date_or_time(),
            _ => true,
        }
}

/// Returns whether the documents of a dialect know access to single bits.
///
/// Basis: ironplc-bit-access: Valid Base Types; rusty-direct-variables: Constant based Direct Access; codesys-recording: operators/bitwise.ts; measured for matiec (a syntax error), open in PLCnext, and in STruC++ for most types.
pub(crate) const fn has_bits(dialect: DialectName) -> bool {
    matches!(
        dialect.base(),
        BuiltIn::IronplcEd2
            | BuiltIn::IronplcEd3
            | BuiltIn::IronplcRusty
            | BuiltIn::Rusty
            | BuiltIn::Codesys
            | BuiltIn::Twincat
    )
}

/// Returns whether a dialect knows `.%Xn`.
///
/// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax; measured for matiec, open in PLCnext and STruC++.
pub(crate) const fn has_partial_access(dialect: DialectName) -> bool {
    matches!(dialect.base(), BuiltIn::IronplcEd3 | BuiltIn::IronplcRusty)
}
