//! A second implementation of the exact arithmetic, fast enough for every input of a 32-bit source.
//!
//! The functions here compute within 64 and 128 bits, with shifts, masks and tables, what [`value`](crate::value()) computes
//! with integers and fractions of any size; neither uses floating point. Tests compare the two at every boundary and on
//! samples, so that a sweep may rely on this one.
//!
//! Architecture Invariant: no code is shared with the reference, so that a mistake in one of the two shows.

mod decimal;
mod integer;
mod moment;
mod real;
#[cfg(test)]
mod tests;

use crate::{Operation, Signature};
use real::RealResult;
use stickler_types::{
    BitStringAsBool, BitsAsInteger, BitsAsReal, ConversionChoices, ElementaryType, Family, MomentUnits,
    OutOfRange, Rounding,
};

/// One conversion, applied to many raw forms at a time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bulk {
    rule: BulkRule,
    from: ElementaryType,
    to: ElementaryType,
}

/// The arithmetic rule of a conversion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum BulkRule {
    /// The number modulo 2^n.
    Modulo,
    /// The number, and `?` where CHAR does not have the character.
    Replaced,
    /// Whether the number is not zero.
    Truth,
    /// Whether a REAL is not zero.
    RealTruth,
    /// The nearest real.
    Nearest(RealResult),
    /// A REAL, unchanged.
    Same,
    /// A REAL, widened to LREAL.
    Lengthened,
    /// A REAL, rounded to an integer.
    Integral(Rounding, OutOfRange),
    /// A number of units of time, as a duration, date or time of day.
    Units(MomentUnits),
    /// A REAL number of units of time, as a duration, date or time of day.
    RealUnits(MomentUnits),
    /// The bits, unchanged.
    Copied,
    /// Binary-coded decimal digits, as the number that they spell.
    Digits,
    /// A number, as binary-coded decimal digits.
    Decimal,
}

impl Bulk {
    /// Returns the fast form of a function that has one: a function with a single operand of at most 32 bits, where neither
    /// the operand nor the result is a text. A REAL number of days or counts has none, nor have days since 1990, a rounding to a real, a TIME of 32
    /// bits and copied bits of an integer.
    pub fn new(signature: &Signature, choices: &ConversionChoices) -> Option<Bulk> {
        let [from] = signature.operands[..] else {
            return None;
        };
        let to = signature.result;
        let since_1990 = choices.moment_units == MomentUnits::DaysSince1990 && to.family() == Family::Date;
        if from.bits() > 32 || from.is_text() || to.is_text() || since_1990 {
            return None;
        }
        let copies_bits =
            (from.is_signed() && to.is_bit_string()) || (from.is_bit_string() && to.is_signed());
        if copies_bits && choices.bits_as_integer == BitsAsInteger::Copy
            || to == ElementaryType::Time && choices.moment_units == MomentUnits::ShortTime
        {
            return None;
        }
        let rule = match signature.operation {
            Operation::FromBcd => BulkRule::Digits,
            Operation::ToBcd => BulkRule::Decimal,
            Operation::Concatenate | Operation::Elementary => return None,
            operation if from.is_real() => of_real(to, operation, choices)?,
            _ => of_number(from, to, choices),
        };
        Some(Bulk { rule, from, to })
    }

    /// Writes the raw form of the result for each operand, up to the length of the shorter slice. A NaN of the result is
    /// the quiet one without a payload.
    pub fn fill(&self, operands: &[u64], results: &mut [u64]) {
        let Bulk { rule, from, to } = *self;
        match rule {
            BulkRule::Modulo => integer::modulo(operands, results, to),
            BulkRule::Replaced => integer::replaced(operands, results),
            BulkRule::Truth => integer::truth(operands, results),
            BulkRule::RealTruth => real::truth(operands, results),
            BulkRule::Nearest(result) => real::nearest(operands, results, result),
            BulkRule::Same => real::same(operands, results),
            BulkRule::Lengthened => real::lengthened(operands, results),
            BulkRule::Integral(rounding, out_of_range) => {
                real::integral(operands, results, to, rounding, out_of_range)
            }
            BulkRule::Units(units) => moment::units(operands, results, to, units),
            BulkRule::RealUnits(units) => moment::real_units(operands, results, to, units),
            BulkRule::Copied => each(operands, results, |operand| operand),
            BulkRule::Digits => decimal::number(operands, results, to),
            BulkRule::Decimal => decimal::digits(operands, results, from, to),
        }
    }
}

fn of_real(to: ElementaryType, operation: Operation, choices: &ConversionChoices) -> Option<BulkRule> {
    let units = choices.moment_units;
    Some(match to.family() {
        Family::Boolean => BulkRule::RealTruth,
        Family::Real if operation != Operation::Convert => return None,
        Family::Real if to == ElementaryType::Real => BulkRule::Same,
        Family::Real => BulkRule::Lengthened,
        Family::Duration | Family::Date | Family::TimeOfDay | Family::DateAndTime => {
            return moment::has_real_units(to, units).then_some(BulkRule::RealUnits(units));
        }
        Family::BitString if choices.bits_as_real == BitsAsReal::Copy && to.bits() == 32 => BulkRule::Copied,
        _ => {
            let choices = operation.choices(choices);
            BulkRule::Integral(choices.rounding, choices.out_of_range)
        }
    })
}

fn of_number(from: ElementaryType, to: ElementaryType, choices: &ConversionChoices) -> BulkRule {
    let is_bit_string = from.is_bit_string();
    match to.family() {
        Family::Boolean if is_bit_string && choices.bit_string_as_bool == BitStringAsBool::LowestBit => {
            BulkRule::Modulo
        }
        Family::Real
            if is_bit_string && choices.bits_as_real == BitsAsReal::Copy && from.bits() == to.bits() =>
        {
            BulkRule::Copied
        }
        Family::Boolean if from == ElementaryType::Bool => BulkRule::Modulo,
        Family::Boolean => BulkRule::Truth,
        Family::Real if to == ElementaryType::Real => BulkRule::Nearest(RealResult::Single),
        Family::Real => BulkRule::Nearest(RealResult::Double),
        Family::Duration | Family::Date | Family::TimeOfDay | Family::DateAndTime => {
            BulkRule::Units(choices.moment_units)
        }
        Family::Character if from.is_character() && to == ElementaryType::Char => BulkRule::Replaced,
        _ => BulkRule::Modulo,
    }
}

/// Applies a rule to each operand.
#[inline(always)]
fn each(operands: &[u64], results: &mut [u64], rule: impl Fn(u64) -> u64) {
    for (operand, result) in operands.iter().zip(results) {
        *result = rule(*operand);
    }
}
