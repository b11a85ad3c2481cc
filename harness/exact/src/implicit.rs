//! What the documents say of implicit conversion: which elementary types become others without a call.
//!
//! This is the suite's own statement of the rules, beside the widening tables of the conformance cases; a test holds the two to
//! each other, cell by cell. What a value becomes, [`implicit_result`](crate::implicit_result) says; it is what the function
//! `<FROM>_TO_<TO>` gives.

use crate::catalogue::has_third_edition;
use stickler_types::{BuiltIn, DialectName, ElementaryType, Family, MatrixWord};

/// Returns whether a value of the type `from` stands where `to` is expected, in a dialect.
///
/// Types that the dialect does not have convert to nothing, and nothing to them. What a definition states of a pair is so.
///
/// Basis: ironplc-type-conversions: Implicit Type Widening, Cross-family widening; forgeiec-conversion-functions: matiec
/// conformance; implicit-conversion-table: SEM1189 table; implicit-conversion-rules: ANY_DURATION, for TIME and LTIME, which are
/// not in the table.
#[must_use]
pub fn implicit(from: ElementaryType, to: ElementaryType, dialect: DialectName) -> MatrixWord {
    if from == to {
        return MatrixWord::Same;
    }
    if !has_third_edition(dialect) && (from.is_third_edition() || to.is_third_edition()) {
        return MatrixWord::No;
    }
    if let Some(stated) = dialect
        .definition()
        .and_then(|definition| definition.implicit(from, to))
    {
        return stated.value;
    }
    match dialect.base() {
        BuiltIn::IronplcEd2 | BuiltIn::IronplcEd3 => ironplc(from, to),
        BuiltIn::IronplcRusty if is_cross_family(from, to) => MatrixWord::Yes,
        BuiltIn::IronplcRusty => ironplc(from, to),
        BuiltIn::Matiec => MatrixWord::No,
        BuiltIn::Plcnext => plcnext(from, to),
    }
}

/// IronPLC's three categories, and what its general rule leaves open.
fn ironplc(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    if from.long_form() == Some(to) || to.long_form() == Some(from) {
        return MatrixWord::Open;
    }
    said(match (from.family(), to.family()) {
        // "The source type's full value range is exactly representable in the target type", which the matrix repeats.
        (Family::Signed | Family::Unsigned, Family::Signed | Family::Unsigned) => {
            holds_every_integer(from, to)
        }
        // "LREAL … covers all standard integer types": by the matrix, although 64 bits do not fit.
        (Family::Signed | Family::Unsigned, Family::Real) => to == ElementaryType::Lreal || from.bits() <= 16,
        (Family::BitString, Family::BitString) | (Family::Real, Family::Real) => from.bits() < to.bits(),
        _ => false,
    })
}

/// "A bit-string type can widen to an integer type of strictly greater bit width", where the flag is on.
const fn is_cross_family(from: ElementaryType, to: ElementaryType) -> bool {
    from.is_bit_string() && to.is_integer() && from.bits() < to.bits()
}

/// PLCnext's coloured table.
fn plcnext(from: ElementaryType, to: ElementaryType) -> MatrixWord {
    use ElementaryType::{Ltime, Time, Udint};
    said(match (from.family(), to.family()) {
        (Family::Signed | Family::Unsigned, Family::Signed | Family::Unsigned) => {
            holds_every_integer(from, to)
        }
        // "REAL mantissa = 23 bit, LREAL mantissa = 52 bit": so LINT and ULINT become no real.
        (Family::Signed | Family::Unsigned, Family::Real) => {
            from.bits() <= if to == ElementaryType::Real { 16 } else { 32 }
        }
        (Family::Boolean | Family::BitString, Family::BitString) | (Family::Real, Family::Real) => {
            from.bits() < to.bits()
        }
        _ => matches!((from, to), (Udint, Time) | (Time, Udint) | (Time, Ltime)),
    })
}

/// Whether one integer type holds every value of another.
fn holds_every_integer(from: ElementaryType, to: ElementaryType) -> bool {
    let (Some((least, greatest)), Some((low, high))) = (from.integer_range(), to.integer_range()) else {
        return false;
    };
    low <= least && greatest <= high
}

const fn said(converts: bool) -> MatrixWord {
    if converts { MatrixWord::Yes } else { MatrixWord::No }
}
