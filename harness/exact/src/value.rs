//! What a call gives by given choices: the rule for each pair of families.

use crate::choices::{Choices, Outside, RealToInteger};
use crate::integer;
use crate::real::{self, Real, Rounding, Whole};
use crate::signature::{Operation, Signature};
use stickler_types::{ElementaryType, Family, Value};

/// What a call of a conversion function gives, computed exactly by the choices that the caller spells out.
///
/// Takes a signature of [`crate::signatures`] and one operand for each of its types, in their canonical raw form; gives a value
/// of its result type. For operands of other types, or another number of them, there is no such call: the result is then the
/// default of the result type, 0 or the empty text.
///
/// Basis: stickler-design: §8 (arithmetic rules); forgeiec-conversion-functions: The naming pattern, Range and precision.
#[must_use]
pub fn value(signature: &Signature, operands: &[Value], choices: &Choices) -> Value {
    let result = match (&signature.operands[..], operands) {
        _ if !signature.takes(operands) => None,
        (&[from], [Value::Plain { raw, .. }]) => plain(signature, *raw, from, choices),
        _ => None,
    };
    result.unwrap_or_else(|| Value::plain(signature.result, 0))
}

/// What becomes of one operand that is no text.
fn plain(signature: &Signature, raw: u64, from: ElementaryType, choices: &Choices) -> Option<Value> {
    let to = signature.result;
    let rounding = match signature.operation {
        Operation::Convert => choices.real_to_integer.into(),
        Operation::Truncate => Rounding::TowardZero,
        Operation::Round => Rounding::HalfToEven,
        Operation::Ceiling => Rounding::Up,
        Operation::Floor => Rounding::Down,
        Operation::FromBcd | Operation::ToBcd | Operation::Concatenate => return None,
    };
    convert(raw, from, to, rounding, choices.outside).map(|raw| Value::plain(to, raw))
}

/// The conversion of one type to another, neither of them a text.
fn convert(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    rounding: Rounding,
    outside: Outside,
) -> Option<u64> {
    use Family::{BitString, Boolean, Real, Signed, Unsigned};
    Some(match (from.family(), to.family()) {
        (Boolean | Signed | Unsigned | BitString, Boolean) => u64::from(integer::number(raw, from) != 0),
        (Real, Boolean) => u64::from(real::is_nonzero(raw, from)),
        (Boolean | Signed | Unsigned | BitString, Signed | Unsigned | BitString) => {
            integer::wrapped(integer::number(raw, from), to)
        }
        (Boolean | Signed | Unsigned | BitString, Real) => real::from_integer(integer::number(raw, from), to),
        (Real, Real) => real::between(raw, from, to),
        (Real, Signed | Unsigned | BitString) => from_real(raw, from, to, rounding, outside),
        _ => return None,
    })
}

/// A real number as an integer or bit string.
///
/// Basis: forgeiec-conversion-functions: Range and precision ("fractional digits dropped … wraps"); stickler-design: §8 (the
/// exact integer modulo 2^n, NaN and the infinities give 0).
fn from_real(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    rounding: Rounding,
    outside: Outside,
) -> u64 {
    let whole = match real::decode(raw, from) {
        Real::NotANumber => return 0,
        Real::Infinite { negative } => Whole::Huge { negative },
        Real::Finite {
            negative,
            significand,
            exponent,
        } => real::to_whole(negative, significand, exponent, rounding),
    };
    match (whole, outside) {
        (Whole::Number(number), Outside::Wrap) => integer::wrapped(number, to),
        (Whole::Number(number), Outside::Saturate) => integer::saturated(number, to),
        // What is huge is a multiple of 2^64, and so 0 in every type; an infinity is 0 by decree.
        (Whole::Huge { .. }, Outside::Wrap) => 0,
        (Whole::Huge { negative }, Outside::Saturate) => {
            integer::saturated(if negative { i128::MIN } else { i128::MAX }, to)
        }
    }
}

impl From<RealToInteger> for Rounding {
    fn from(choice: RealToInteger) -> Rounding {
        match choice {
            RealToInteger::Truncate => Rounding::TowardZero,
            RealToInteger::HalfToEven => Rounding::HalfToEven,
            RealToInteger::HalfAwayFromZero => Rounding::HalfAway,
        }
    }
}
