//! THE rule that says whether a value converts implicitly, and with what result.

use super::{Conversion, ConversionRule};
use stickler_types::dialect::{ImplicitWarnings, OperandTypes, Widening};
use stickler_types::{Code, Dialect, ElementaryType, Family, MatrixWord};

/// Returns whether a value of one elementary type may stand where another is expected, and what becomes of it: the
/// one place that decides. Takes the two types and the dialect; gives the conversion to perform, the identity
/// for equal types, or `None` where an explicit call is needed.
pub fn implicit(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Conversion> {
    if from == to {
        return Some(Conversion::identity(from));
    }
    let widens = match dialect.cells.get(&(from, to)) {
        // Where acceptance is open, the reference accepts.
        Some(cell) => cell.value != MatrixWord::No,
        None => match dialect.widening {
            Widening::None => false,
            Widening::IronplcMatrices => {
                ironplc(from, to) || (dialect.cross_family_widening && bit_string_fits_integer(from, to))
            }
            Widening::PlcnextTable => plcnext(from, to),
            Widening::ThirdEdition => third_edition(from, to),
            Widening::Numbers => numbers(from, to),
            Widening::NumbersAndMoments => numbers(from, to) || moments(from, to),
            Widening::IntegersAndReals => from.is_number() && to.is_number(),
            Widening::NumbersUnlessNarrower => numbers_unless_narrower(from, to),
            Widening::NumbersApartFromBool => {
                from != ElementaryType::Bool && to != ElementaryType::Bool && numbers(from, to)
            }
            Widening::NumbersButNoRealAsBits => {
                to != ElementaryType::Bool && !(from.is_real() && to.is_bit_string()) && numbers(from, to)
            }
        },
    };
    if !widens {
        return None;
    }
    let rule = ConversionRule::between(from, to, &dialect.conversions)?;
    Some(Conversion { from, to, rule })
}

/// Returns what becomes of an operand beside one of another type: what [`implicit`] says, and a conversion in any case where operands meet in
/// the type with the higher rank.
pub(crate) fn of_operand(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Conversion> {
    implicit(from, to, dialect).or_else(|| {
        let ranks = rank(from).zip(rank(to));
        ranks.filter(|_| dialect.operands == OperandTypes::HigherRank)?;
        let rule = ConversionRule::between(from, to, &dialect.conversions)?;
        Some(Conversion { from, to, rule })
    })
}

/// Returns the warning with which a dialect accepts an implicit conversion; `None` where it has none, or where the types do not
/// convert. A definition decides of a pair whether it is warned of, and its base with which code.
///
/// Basis: that of each [`ImplicitWarnings`].
pub fn implicit_warning(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Code> {
    let (code, is_warned) = match dialect.implicit_warnings {
        ImplicitWarnings::None | ImplicitWarnings::LostValues => (lost_value(from, to), may_lose(from, to)),
        ImplicitWarnings::Narrowing => (Code::NarrowingConversion, narrows(from, to)),
        ImplicitWarnings::LargerTypes => (Code::ImplicitDowncast, from.bits() > to.bits()),
    };
    let is_warned = match dialect.cells.get(&(from, to)) {
        Some(cell) => cell.value == MatrixWord::Warn,
        None if dialect.implicit_warnings == ImplicitWarnings::None => false,
        None => is_warned && from != to && implicit(from, to, dialect).is_some(),
    };
    is_warned.then_some(code)
}

/// Returns the warning with which a dialect accepts an untyped literal whose number its type does not have, but whose bits; `None` where it
/// has none.
///
/// Basis: twincat-builds: recordings/twincat.build.json (`bound_…`, `cc_literal_…`).
pub(crate) fn literal_warning(number: i128, to: ElementaryType, dialect: &Dialect) -> Option<Code> {
    let is_warned = dialect.literals_by_width && dialect.implicit_warnings == ImplicitWarnings::LostValues;
    (is_warned && to.integer_range().is_some() && !to.holds(number)).then_some(if number < 0 {
        Code::SignedToUnsigned
    } else {
        Code::UnsignedToSigned
    })
}

/// Returns the code of CODESYS for a conversion that may lose the sign or digits.
const fn lost_value(from: ElementaryType, to: ElementaryType) -> Code {
    match (from.is_signed(), to.is_signed()) {
        _ if to.is_real() || from.is_real() => Code::LossOfInformation,
        (true, false) => Code::SignedToUnsigned,
        (false, true) => Code::UnsignedToSigned,
        _ => Code::LossOfInformation,
    }
}

/// Fewer bits within a category, a real to an integer, and signed to unsigned of one size or back.
fn narrows(from: ElementaryType, to: ElementaryType) -> bool {
    let changes_sign = from.is_signed() != to.is_signed() && from.bits() == to.bits();
    match (from.is_integer(), to.is_integer()) {
        (true, true) => from.bits() > to.bits() || changes_sign,
        (false, true) => from.is_real(),
        _ => {
            from.bits() > to.bits()
                && from.is_real() == to.is_real()
                && from.is_bit_string() == to.is_bit_string()
        }
    }
}

/// Returns whether a number or bit string of the one type may be none of the other.
fn may_lose(from: ElementaryType, to: ElementaryType) -> bool {
    match (from.integer_range(), to.integer_range()) {
        (Some((low, high)), None) => to.is_real() && !range_fits_real(low, high, to),
        (Some((from_low, from_high)), Some((to_low, to_high))) => from_low < to_low || from_high > to_high,
        (None, _) => from.is_real() && !real_fits_real(from, to),
    }
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
        || from.is_form_of(to)
}

/// The coloured table of PLCnext Engineer: the same rule taken literally (LINT and ULINT do not fit LREAL),
/// BOOL into the bit strings, and UDINT to TIME and back.
///
/// Basis: implicit-conversion-table (SEM1189); for TIME to LTIME, which the table leaves out,
/// implicit-conversion-rules ("`ANY_DURATION` … into other `ANY_DURATION` data types", only from the smaller).
const fn plcnext(from: ElementaryType, to: ElementaryType) -> bool {
    use ElementaryType::{Ltime, Time, Udint};
    keeps_every_value(from, to) || matches!((from, to), (Udint, Time) | (Time, Udint) | (Time, Ltime))
}

/// The paths of the third edition's Figure 12: numbers and bit strings into what holds all of them, and a duration, date or time of day into its long
/// form.
///
/// Basis: iec-61131-3: 6.6.1.6.
fn third_edition(from: ElementaryType, to: ElementaryType) -> bool {
    keeps_every_value(from, to) || from.long_form() == Some(to)
}

/// Every value of the type is one of the other, within the integers, reals and bit strings, with BOOL among the bit strings, and from an integer to a real.
const fn keeps_every_value(from: ElementaryType, to: ElementaryType) -> bool {
    integer_fits_integer(from, to)
        || integer_fits_real(from, to)
        || real_fits_real(from, to)
        || bit_string_fits_bit_string(from, to)
        || (matches!(from, ElementaryType::Bool) && to.is_bit_string())
}

/// Returns the type that two operands take of which each converts to the type of the other.
///
/// Basis: that of the dialect's [`OperandTypes`], and of the wider operand.
pub fn common_operand(left: ElementaryType, right: ElementaryType, dialect: &Dialect) -> ElementaryType {
    let is_unsigned = |ty: ElementaryType| ty.family() == Family::Unsigned;
    let takes_right = match (dialect.operands, rank(left).zip(rank(right))) {
        (OperandTypes::HigherRank, Some((of_left, of_right))) => {
            (of_right, is_unsigned(right)) > (of_left, is_unsigned(left))
        }
        (OperandTypes::Promoted, _) if left.is_whole() && right.is_whole() && left.bits() == right.bits() => {
            right.is_signed()
        }
        _ => wider_operand(left, right) == right,
    };
    if takes_right { right } else { left }
}

/// Returns the rank of a number or bit string, which [`OperandTypes::HigherRank`] compares.
const fn rank(ty: ElementaryType) -> Option<u8> {
    match (ty.family(), ty.bits()) {
        (Family::Signed | Family::Unsigned | Family::BitString, bits) => Some(match bits {
            8 => 1,
            16 => 2,
            32 => 4,
            _ => 6,
        }),
        (Family::Real, 32) => Some(3),
        (Family::Real, _) => Some(5),
        _ => None,
    }
}

/// Returns the one of two types that holds the values of the
/// other, a real before an integer, a duration before a number, a type of the third edition before its short form; or else the first.
///
/// Basis: strucpp-tests: tests/semantic/type-utils.test.ts (`getCommonType`).
fn wider_operand(left: ElementaryType, right: ElementaryType) -> ElementaryType {
    let holds = |from, to| ironplc(from, to) || bit_string_fits_integer(from, to);
    let takes_right = (right.is_duration() && !left.is_duration())
        || right.is_third_edition()
        || (right.is_real() && !left.is_real())
        || (holds(left, right) && !holds(right, left));
    if takes_right { right } else { left }
}

/// Every number, bit string and BOOL into every number and bit string, also where that narrows; a bit string into BOOL, which a condition takes; a type
/// and its long form, which is open.
///
/// Basis: strucpp-architecture: Type System ("Narrowing conversions produce warnings, not errors"); rusty-tests:
/// src/validation/tests/assignment_validation_tests.rs; strucpp-tests:
/// tests/semantic/type-validation.test.ts (conditions).
fn numbers(from: ElementaryType, to: ElementaryType) -> bool {
    let is_number = |ty: ElementaryType| ty.is_number() || ty.is_bit_string();
    let has_number = is_number(from) || from == ElementaryType::Bool;
    let is_truth_value = from.is_bit_string() && to == ElementaryType::Bool;
    (has_number && is_number(to)) || is_truth_value || from.is_form_of(to)
}

/// Every integer and bit string into those with as many bits or more, and every number and bit string into REAL and LREAL; what concerns a type that was not
/// measured is open.
///
/// Basis: codesys-implicit.
fn numbers_unless_narrower(from: ElementaryType, to: ElementaryType) -> bool {
    use ElementaryType::{Bool, Time};
    let fits = from.is_whole() && to.is_whole() && from.bits() <= to.bits();
    let is_open = from.is_form_of(to) && from != Time && to != Time;
    fits || (from != Bool && numbers(from, to) && to.is_real()) || is_open
}

/// Every duration, date and time of day into every other and into every number and bit string, and these into it.
///
/// Basis: rusty-tests: src/validation/tests/assignment_validation_tests.rs; rusty-datatypes: Date and Time ("already treats … as 64
/// bit numbers").
fn moments(from: ElementaryType, to: ElementaryType) -> bool {
    let is_number = |ty: ElementaryType| ty.is_number() || ty.is_bit_string();
    (from.is_moment() && (is_number(to) || to.is_moment())) || (is_number(from) && to.is_moment())
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
    match from.integer_range() {
        Some((low, high)) => from.is_integer() && range_fits_real(low, high, to),
        None => false,
    }
}

/// Every number from `low` to `high` is exact in the real type.
const fn range_fits_real(low: i128, high: i128, to: ElementaryType) -> bool {
    let limit: i128 = match to {
        ElementaryType::Real => 1 << f32::MANTISSA_DIGITS,
        ElementaryType::Lreal => 1 << f64::MANTISSA_DIGITS,
        _ => return false,
    };
    -limit <= low && high <= limit
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

#[cfg(test)]
mod tests;
