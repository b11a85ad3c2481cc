//! THE rule that says whether a value converts implicitly, and with what result.

use super::{Conversion, ConversionRule};
use crate::dialect::{Dialect, Widening};
use stickler_types::ElementaryType;

/// Whether a value of one elementary type may stand where another is expected, and what becomes of it: the
/// one place that decides. Takes the two types and the dialect; gives the conversion to perform, the identity
/// for equal types, or `None` where an explicit call is needed.
#[must_use]
pub fn implicit(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Conversion> {
    if from == to {
        return Some(Conversion::identity(from));
    }
    let widens = match dialect.widening {
        Widening::None => false,
        Widening::Ironplc => {
            ironplc(from, to) || (dialect.cross_family_widening && bit_string_fits_integer(from, to))
        }
        Widening::Plcnext => plcnext(from, to),
    };
    if !widens {
        return None;
    }
    let rule = ConversionRule::between(from, to, dialect.real_to_integer.into())?;
    Some(Conversion { from, to, rule })
}

/// The general rule of IronPLC, "the source type's full value range is exactly representable in the target
/// type", in the three families that it names.
///
/// Basis: ironplc-type-conversions: Implicit Type Widening. LINT and ULINT to LREAL are implicit by the
/// matrix of *Integer to real widening*, though 64 bits do not fit 53. REAL to LREAL follows from the general
/// rule alone. A type and its long form hold the same values here; whether they convert is open, and accepted.
fn ironplc(from: ElementaryType, to: ElementaryType) -> bool {
    integer_fits_integer(from, to)
        || (from.is_integer() && matches!(to, ElementaryType::Lreal))
        || integer_fits_real(from, to)
        || real_fits_real(from, to)
        || bit_string_fits_bit_string(from, to)
        || short_or_long_form(from, to)
}

/// The coloured table of PLCnext Engineer: the same rule taken literally (LINT and ULINT do not fit LREAL),
/// BOOL into the bit strings, and UDINT to TIME and back.
///
/// Basis: implicit-conversion-table (SEM1189); for TIME to LTIME, which the table leaves out,
/// implicit-conversion-rules ("`ANY_DURATION` … into other `ANY_DURATION` data types", only from the smaller).
const fn plcnext(from: ElementaryType, to: ElementaryType) -> bool {
    use ElementaryType::{Bool, Ltime, Time, Udint};
    integer_fits_integer(from, to)
        || integer_fits_real(from, to)
        || real_fits_real(from, to)
        || bit_string_fits_bit_string(from, to)
        || (matches!(from, Bool) && to.is_bit_string())
        || matches!((from, to), (Udint, Time) | (Time, Udint) | (Time, Ltime))
}

/// Every value of the one integer type is a value of the other.
const fn integer_fits_integer(from: ElementaryType, to: ElementaryType) -> bool {
    if !from.is_integer() || !to.is_integer() {
        return false;
    }
    match (from.integer_range(), to.integer_range()) {
        (Some((from_low, from_high)), Some((to_low, to_high))) => to_low <= from_low && from_high <= to_high,
        _ => false,
    }
}

/// Every value of the integer type is exact in the real type: it lies within plus or minus 2^p, p being the
/// significand's bits with the hidden one.
const fn integer_fits_real(from: ElementaryType, to: ElementaryType) -> bool {
    let limit: i128 = match to {
        ElementaryType::Real => 1 << f32::MANTISSA_DIGITS,
        ElementaryType::Lreal => 1 << f64::MANTISSA_DIGITS,
        _ => return false,
    };
    match from.integer_range() {
        Some((low, high)) => from.is_integer() && -limit <= low && high <= limit,
        None => false,
    }
}

/// REAL into LREAL.
const fn real_fits_real(from: ElementaryType, to: ElementaryType) -> bool {
    matches!((from, to), (ElementaryType::Real, ElementaryType::Lreal))
}

/// A bit string, BOOL excluded, into a wider one.
const fn bit_string_fits_bit_string(from: ElementaryType, to: ElementaryType) -> bool {
    from.is_bit_string() && to.is_bit_string() && from.bits() < to.bits()
}

/// A bit string into a strictly wider integer.
/// Basis: ironplc-type-conversions: Cross-family widening.
const fn bit_string_fits_integer(from: ElementaryType, to: ElementaryType) -> bool {
    from.is_bit_string() && to.is_integer() && from.bits() < to.bits()
}

/// TIME and LTIME, DATE and LDATE, TOD and LTOD, DT and LDT, either way.
fn short_or_long_form(from: ElementaryType, to: ElementaryType) -> bool {
    from.long_form() == Some(to) || to.long_form() == Some(from)
}
