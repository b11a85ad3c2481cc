//! Computes the result of a call by given choices: one rule for each pair of families of types.

use crate::elementary::elementary_result;
use crate::real::{self, Real, Whole};
use crate::signature::{Operation, Signature, has_meaning};
use crate::{bcd, character, integer, moment, text};
use stickler_types::{
    BitStringAsBool, BitsAsInteger, BitsAsReal, ConversionChoices, ElementaryType, Family, MomentUnits,
    OutOfRange, Rounding, Value,
};

/// Returns the result of a call of a conversion function, computed exactly by the given choices.
///
/// Takes a signature of [`crate::signatures`] and one operand for each of its types, in their canonical raw form; gives a value
/// of its result type. For operands of other types, or another number of them, there is no such call: the result is then the
/// default of the result type, 0 or the empty text.
///
/// Basis: rule: integer-overflow-wraps; forgeiec-conversion-functions: The naming pattern, Range and precision.
pub fn value(signature: &Signature, operands: &[Value], choices: &ConversionChoices) -> Value {
    let result = match operands {
        _ if !signature.takes(operands) => None,
        [Value::Plain { ty, raw }] => plain(signature, *raw, *ty, choices),
        [Value::Text { units, .. }] => text(signature, units, choices),
        [Value::Plain { raw: date, .. }, Value::Plain { raw: time, .. }] => {
            Some(Value::plain(signature.result, moment::concatenated(*date, *time)))
        }
        _ => None,
    };
    result.unwrap_or_else(|| default(signature.result))
}

/// Returns 0 or the empty text.
const fn default(ty: ElementaryType) -> Value {
    if ty.is_text() {
        Value::text(ty, Vec::new())
    } else {
        Value::plain(ty, 0)
    }
}

/// Converts one operand that is not a text.
fn plain(
    signature: &Signature,
    raw: u64,
    from: ElementaryType,
    choices: &ConversionChoices,
) -> Option<Value> {
    let to = signature.result;
    let result = match signature.operation {
        Operation::Convert if to.is_text() => return Some(Value::text(to, written(raw, from, to, choices))),
        Operation::FromBcd => integer::wrapped(bcd::number(raw, from), to),
        Operation::ToBcd => bcd::encoded(raw, from, to),
        Operation::Concatenate => return None,
        Operation::Elementary => return elementary_result(signature, &Value::plain(from, raw)),
        Operation::Truncate | Operation::Round | Operation::Ceiling | Operation::Floor if to.is_real() => {
            real::whole(raw, from, to, signature.operation.choices(choices).rounding)
        }
        operation => convert(raw, from, to, &operation.choices(choices))?,
    };
    Some(Value::plain(to, result))
}

/// Returns the text of a value that is not a text.
fn written(raw: u64, from: ElementaryType, to: ElementaryType, choices: &ConversionChoices) -> Vec<u16> {
    if from.is_character() {
        vec![character::unit(character::of_raw(raw), to)]
    } else {
        text::write(raw, from, choices).bytes().map(u16::from).collect()
    }
}

/// Converts an operand that is a text.
fn text(signature: &Signature, units: &[u16], choices: &ConversionChoices) -> Option<Value> {
    let to = signature.result;
    (signature.operation == Operation::Convert).then(|| match to.family() {
        Family::Text => Value::text(to, character::text(units, to)),
        Family::Character => Value::plain(to, character::first(units, to)),
        _ => Value::plain(to, text::read(units, to, choices)),
    })
}

/// Converts between types that are not texts; returns `None` if the pair has no conversion.
fn convert(raw: u64, from: ElementaryType, to: ElementaryType, choices: &ConversionChoices) -> Option<u64> {
    use Family::{
        BitString, Boolean, Character, Date, DateAndTime, Duration, Real, Signed, TimeOfDay, Unsigned,
    };
    let units = choices.moment_units;
    if !has_meaning(from, to) {
        return None;
    }
    let number = || integer::number(raw, from);
    let counts = units == MomentUnits::Counts;
    let is_copy = choices.bits_as_real == BitsAsReal::Copy && from.bits() == to.bits();
    Some(match (from.family(), to.family()) {
        (Character, Character) => character::unit(character::of_raw(raw), to).into(),
        (Real, Boolean) => u64::from(real::is_nonzero(raw, from)),
        (BitString, Boolean) if choices.bit_string_as_bool == BitStringAsBool::LowestBit => raw & 1,
        (_, Boolean) => u64::from(number() != 0),
        (BitString, Real) | (Real, BitString) if is_copy => raw,
        (Signed, BitString) | (BitString, Signed)
            if choices.bits_as_integer == BitsAsInteger::Copy && from.bits() < to.bits() =>
        {
            integer::wrapped(integer::of_bits(number(), from.bits(), to), to)
        }
        (Boolean | Signed | Unsigned | BitString | Character, Signed | Unsigned | BitString | Character) => {
            integer::wrapped(number(), to)
        }
        (Boolean | Signed | Unsigned | BitString, Real) => real::from_integer(number(), to),
        (Real, Real) => real::between(raw, from, to),
        (Real, Signed | Unsigned | BitString) => {
            from_real(raw, from, to, choices.rounding, choices.out_of_range)
        }
        (Boolean | Signed | Unsigned | BitString, Duration | Date | TimeOfDay | DateAndTime) => {
            moment::from_units(number(), to, units)
        }
        (Real, Duration | Date | TimeOfDay | DateAndTime) if counts => {
            let counter = moment::counter(to);
            let count = from_real(raw, from, counter, choices.rounding, choices.out_of_range);
            moment::from_units(integer::number(count, counter), to, units)
        }
        (Real, Duration | Date | TimeOfDay | DateAndTime) => moment::from_real_units(raw, from, to, units),
        (Duration | Date | TimeOfDay | DateAndTime, Signed | Unsigned | BitString) => {
            integer::wrapped(moment::units(raw, from, units), to)
        }
        (Duration | Date | TimeOfDay | DateAndTime, Real) => moment::real_units(raw, from, to, units),
        (Duration | Date | TimeOfDay | DateAndTime, Duration | Date | TimeOfDay | DateAndTime)
            if counts && from != to =>
        {
            moment::between_counts(raw, from, to)
        }
        (Duration, Duration)
            if units == MomentUnits::ShortTime && from != to && to == ElementaryType::Time =>
        {
            moment::from_units(moment::units(raw, from, units), to, units)
        }
        (Duration | Date | TimeOfDay | DateAndTime, Duration | Date | TimeOfDay | DateAndTime) => {
            moment::between(raw, to)
        }
        _ => return None,
    })
}

/// Converts a real number to an integer or bit string.
///
/// Basis: forgeiec-conversion-functions: Range and precision ("fractional digits dropped … wraps"); rule: not-stated (NaN and
/// the infinities give 0).
fn from_real(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    rounding: Rounding,
    out_of_range: OutOfRange,
) -> u64 {
    let whole = match real::decode(raw, from) {
        Real::NotANumber => return not_a_number(to, out_of_range),
        Real::Infinite { negative } => Whole::Huge { negative },
        Real::Finite(number) => real::to_whole(number, rounding),
    };
    match (whole, out_of_range) {
        (Whole::Number(number), OutOfRange::Wrap) => integer::wrapped(number, to),
        (Whole::Number(number), OutOfRange::Saturate) => integer::saturated(number, to),
        // What is huge is a multiple of 2^64, and so 0 in every type; an infinity is 0 by decree.
        (Whole::Huge { .. }, OutOfRange::Wrap) => 0,
        (Whole::Huge { negative }, OutOfRange::Saturate) => {
            integer::saturated(if negative { i128::MIN } else { i128::MAX }, to)
        }
        (whole, OutOfRange::Indefinite64) => integer::wrapped(of_64_bits(whole, to), to),
        (Whole::Number(number), OutOfRange::Indefinite32) if ElementaryType::Dint.holds(number) => {
            integer::wrapped(number, to)
        }
        (_, OutOfRange::Indefinite32) => not_a_number(to, out_of_range),
    }
}

/// Returns the result for a NaN: 0, or the number that a processor gives for want of another.
fn not_a_number(to: ElementaryType, out_of_range: OutOfRange) -> u64 {
    match out_of_range {
        OutOfRange::Wrap | OutOfRange::Saturate => 0,
        OutOfRange::Indefinite64 => integer::wrapped(-(1 << 63), to),
        OutOfRange::Indefinite32 => integer::wrapped(-(1 << 31), to),
    }
}

/// Returns the number if 64 bits hold it, otherwise -2^63. A target of 64 bits also takes numbers below 2^64. For a target of at most
/// 32 bits a negative number must fit 32 bits, otherwise it is -2^31.
fn of_64_bits(whole: Whole, to: ElementaryType) -> i128 {
    let is_negative = match whole {
        Whole::Number(number) => number < 0,
        Whole::Huge { negative } => negative,
    };
    let holder = if is_negative && to.bits() <= 32 {
        ElementaryType::Dint
    } else {
        ElementaryType::Lint
    };
    match whole {
        Whole::Number(number) if holder.holds(number) => number,
        Whole::Number(number) if to.bits() == 64 && ElementaryType::Ulint.holds(number) => number,
        _ => -(1 << (holder.bits() - 1)),
    }
}
