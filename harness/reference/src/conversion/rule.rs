//! The rules by which conversions change values: one small rule a pair of types, said once for the implicit rule and for
//! the catalogue of functions alike.

use super::{moment, reading, real, text, writing};
use crate::raw;
use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsInteger, BitsAsReal, ConversionChoices, ElementaryType, Family,
    MomentText, MomentUnits, OutOfRange, RealText, Rounding, TextReading,
};

/// A conversion from one elementary type to another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Conversion {
    /// The type of the operand.
    pub from: ElementaryType,
    /// The type of the result.
    pub to: ElementaryType,
    /// The change of the value.
    pub rule: ConversionRule,
}

/// The rule by which a conversion changes the value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConversionRule {
    /// The raw form stays as it is: the same type, and pairs that share a raw form (TIME and LTIME, DATE and DT, DT and TIME, which is then the time
    /// since 1970; DWORD and REAL where the bits are copied).
    Keep,
    /// Integers, bit strings, BOOL and characters: the value modulo 2^n of the target; a bit string and a
    /// character count as unsigned.
    /// Basis: rule: integer-overflow-wraps; forgeiec-conversion-functions: Range and precision.
    Wrap,
    /// A bit string and an integer with a sign, of which the target has more bits: the bits, below zeros or copies of the sign.
    /// Basis: plcnext-conversions: TO_DWORD, TO_DINT.
    CopyBits,
    /// Zero is FALSE, all else TRUE; -0.0 is zero, and a NaN is not.
    /// Basis: forgeiec-conversion-functions: The naming pattern ("0 → FALSE, anything else → TRUE").
    NonZero,
    /// The number that an integer or a bit string stands for, rounded to nearest, ties to even, once.
    /// Basis: iec-61131-3: Table 10 (IEC 60559).
    ToReal,
    /// REAL to LREAL exactly, LREAL to REAL rounded to nearest, ties to even.
    /// Basis: forgeiec-conversion-functions: Range and precision (`LREAL_TO_REAL`).
    BetweenReals,
    /// A real number, rounded to a whole one that is a real number, too.
    /// Basis: siemens-manual-2016: 294 (`ROUND_REAL`); siemens-manual-2009: 123 (NaN and the infinities stay).
    ToWhole(Rounding),
    /// Rounded to an integer, which is then brought into the target; NaN gives 0.
    /// Basis: that of the rounding and of the range; rule: not-stated for NaN.
    FromReal(Rounding, OutOfRange),
    /// A duration, date or time of day as the number of its units, the fraction dropped, modulo 2^n.
    /// Basis: forgeiec-conversion-functions: The naming pattern (TIME in ms); strucpp-tests:
    /// tests/st-validation/data_types/test_time_types.st (the others there, elsewhere they are open).
    ToUnits(MomentUnits),
    /// Counts the units as a real number, rounded once.
    ToRealUnits(MomentUnits),
    /// A number of units as a duration, date or time of day.
    /// Basis: forgeiec-conversion-functions: The naming pattern (`DINT_TO_TIME` "interprets as ms").
    FromUnits(MomentUnits),
    /// Returns a real number of units, rounded to the nearest nanosecond, ties to even.
    FromRealUnits(MomentUnits),
    /// A real number, rounded to the integer that counts a duration, date or time of day.
    /// Basis: codesys-recording: fixtures/conversions/explicit-pairs.ts.
    FromRealCount(Rounding, OutOfRange),
    /// A duration, date or time of day as another that counts its own unit.
    /// Basis: codesys-recording: fixtures/conversions/cross-family.ts, fixtures/conversions/explicit-pairs.ts.
    BetweenCounts,
    /// An LTIME as the TIME of its whole milliseconds, modulo 2^32.
    /// Basis: plcnext-conversions: TO_TIME.
    ShortTime,
    /// The day of a date and time, also before 1970; a duration and a time of day count from the beginning of 1970, which is open.
    /// Basis: forgeiec-conversion-functions: The naming pattern (`DT_TO_DATE`).
    Day,
    /// The time since midnight of a date and time, also before 1970; a duration modulo 24 hours; midnight for a date.
    /// Basis: forgeiec-conversion-functions: The naming pattern (`DT_TO_TOD`); of a duration and a date it is open.
    TimeOfDay,
    /// A character of the other width; one that CHAR does not have becomes `?`.
    /// Basis: iec-61131-3: conversion of character types (the replacement is left to the implementer).
    Character,
    /// Binary-coded decimal digits to the number they spell, modulo 2^n. A digit above 9 counts with its value.
    /// Basis: forgeiec-conversion-functions: BCD encoding; wrong digits are open.
    FromBcd,
    /// A number as decimal digits, four bits a digit, as many as the target holds: the number modulo 10^n.
    /// Basis: forgeiec-conversion-functions: BCD encoding; numbers that do not fit are open.
    ToBcd,
    /// A text read as a literal of the target.
    /// Basis: forgeiec-conversion-functions: matiec conformance (0 where the text cannot be read).
    ReadText(TextReading),
    /// A value written as text, a real number, a bit string and a duration or date as chosen.
    /// Basis: forgeiec-conversion-functions: The naming pattern; the form is open.
    WriteText(RealText, BitStringText, MomentText),
    /// STRING to WSTRING and back, character by character.
    BetweenTexts,
    /// The first character of a text; the character with code 0 where the text is empty.
    FirstCharacter,
    /// A text of one character.
    CharacterToText,
}

impl ConversionRule {
    /// The meaning of a conversion from one type to another under the choices of a dialect; `None` where the
    /// pair has none, whatever is chosen.
    pub const fn between(
        from: ElementaryType,
        to: ElementaryType,
        choices: &ConversionChoices,
    ) -> Option<ConversionRule> {
        use Family::{
            BitString, Boolean, Character, Date, DateAndTime, Duration, Real, Signed, Text, TimeOfDay,
            Unsigned,
        };
        let counts = matches!(choices.moment_units, MomentUnits::Counts);
        let units = match (from.family(), to.family()) {
            (Date | DateAndTime, _) | (_, Date | DateAndTime) => choices.moment_units,
            _ if counts => choices.moment_units,
            (Boolean | Signed | Unsigned | BitString | Duration, _)
                if matches!(
                    (to, choices.moment_units),
                    (ElementaryType::Time, MomentUnits::ShortTime)
                ) =>
            {
                MomentUnits::ShortTime
            }
            // The others have one unit in all other dialects, and so one rule.
            _ => MomentUnits::Seconds,
        };
        Some(match (from.family(), to.family()) {
            (Signed, BitString) | (BitString, Signed)
                if matches!(choices.bits_as_integer, BitsAsInteger::Copy) && from.bits() < to.bits() =>
            {
                ConversionRule::CopyBits
            }
            (Boolean | Signed | Unsigned | BitString, Signed | Unsigned | BitString)
            | (Boolean, Boolean)
            | (Character, Signed | Unsigned | BitString)
            | (Signed | Unsigned | BitString, Character) => ConversionRule::Wrap,
            (BitString, Boolean) if matches!(choices.bit_string_as_bool, BitStringAsBool::LowestBit) => {
                ConversionRule::Wrap
            }
            (BitString, Real) | (Real, BitString)
                if matches!(choices.bits_as_real, BitsAsReal::Copy) && from.bits() == to.bits() =>
            {
                ConversionRule::Keep
            }
            (Signed | Unsigned | BitString | Real | Duration | Date | TimeOfDay | DateAndTime, Boolean) => {
                ConversionRule::NonZero
            }
            (Boolean | Signed | Unsigned | BitString, Real) => ConversionRule::ToReal,
            (Real, Real) => ConversionRule::BetweenReals,
            (Real, Signed | Unsigned | BitString) => {
                ConversionRule::FromReal(choices.rounding, choices.out_of_range)
            }
            (Duration | Date | TimeOfDay | DateAndTime, Duration | Date | TimeOfDay | DateAndTime)
                if counts && from as usize != to as usize =>
            {
                ConversionRule::BetweenCounts
            }
            (Duration, Duration)
                if matches!(units, MomentUnits::ShortTime) && !matches!(from, ElementaryType::Time) =>
            {
                ConversionRule::ShortTime
            }
            (Date, Date)
            | (TimeOfDay, TimeOfDay)
            | (Duration | Date | TimeOfDay | DateAndTime, Duration | DateAndTime) => ConversionRule::Keep,
            (Duration | Date | TimeOfDay | DateAndTime, Signed | Unsigned | BitString) => {
                ConversionRule::ToUnits(units)
            }
            (Duration | Date | TimeOfDay | DateAndTime, Real) => ConversionRule::ToRealUnits(units),
            (Boolean | Signed | Unsigned | BitString, Duration | Date | TimeOfDay | DateAndTime) => {
                ConversionRule::FromUnits(units)
            }
            (Real, Duration | Date | TimeOfDay | DateAndTime) if counts => {
                ConversionRule::FromRealCount(choices.rounding, choices.out_of_range)
            }
            (Real, Duration | Date | TimeOfDay | DateAndTime) => ConversionRule::FromRealUnits(units),
            (Duration | TimeOfDay | DateAndTime, Date) => ConversionRule::Day,
            (Duration | Date | DateAndTime, TimeOfDay) => ConversionRule::TimeOfDay,
            (Character, Character) => ConversionRule::Character,
            (Character, Text) => ConversionRule::CharacterToText,
            (Text, Character) => ConversionRule::FirstCharacter,
            (Text, Text) => ConversionRule::BetweenTexts,
            (Text, _) => ConversionRule::ReadText(choices.text_reading),
            (_, Text) => {
                ConversionRule::WriteText(choices.real_text, choices.bit_string_text, choices.moment_text)
            }
            (Character, Boolean | Real | Duration | Date | TimeOfDay | DateAndTime)
            | (Boolean | Real | Duration | Date | TimeOfDay | DateAndTime, Character) => return None,
        })
    }
}

/// A body for each rule between values that are no texts, in which the rule of the conversion is a constant.
macro_rules! one_loop_for_each_rule {
    ($self:ident, $conversion:ident => $body:expr) => {
        one_loop_for_each_rule!($self, $conversion => $body;
            Keep, Wrap, NonZero, ToReal, BetweenReals,
            FromReal(Rounding::Truncate, OutOfRange::Wrap),
            FromReal(Rounding::HalfToEven, OutOfRange::Wrap),
            FromReal(Rounding::HalfAwayFromZero, OutOfRange::Wrap),
            FromReal(Rounding::Up, OutOfRange::Wrap),
            FromReal(Rounding::Down, OutOfRange::Wrap),
            FromReal(Rounding::Truncate, OutOfRange::Saturate),
            FromReal(Rounding::HalfToEven, OutOfRange::Saturate),
            FromReal(Rounding::HalfAwayFromZero, OutOfRange::Saturate),
            FromReal(Rounding::Up, OutOfRange::Saturate),
            FromReal(Rounding::Down, OutOfRange::Saturate),
            FromReal(Rounding::HalfAwayFromZero, OutOfRange::Indefinite64),
            FromReal(Rounding::Truncate, OutOfRange::Indefinite32),
            ToUnits(MomentUnits::Seconds),
            ToUnits(MomentUnits::DaysAndMilliseconds),
            FromUnits(MomentUnits::Seconds),
            FromUnits(MomentUnits::DaysAndMilliseconds),
            FromRealUnits(MomentUnits::Seconds),
            FromRealUnits(MomentUnits::DaysAndMilliseconds),
            FromBcd, ToBcd)
    };
    ($self:ident, $conversion:ident => $body:expr; $($name:ident $(($($choice:path),*))?),*) => {
        match $self.rule {
            $(ConversionRule::$name $(($($choice),*))? => {
                let rule = ConversionRule::$name $(($($choice),*))?;
                let $conversion = Conversion { rule, ..$self };
                $body
            })*
            _ => {
                let $conversion = $self;
                $body
            }
        }
    };
}

impl Conversion {
    /// The conversion that changes nothing.
    pub const fn identity(ty: ElementaryType) -> Conversion {
        Conversion {
            from: ty,
            to: ty,
            rule: ConversionRule::Keep,
        }
    }

    /// The raw form of the result for the raw form of the operand, where neither is a text. A rule that needs
    /// a text gives 0; the checker never asks for that.
    pub fn apply(self, value: u64) -> u64 {
        self.apply_here(value)
    }

    /// Small where the rule is known, and large where it is not: so it is inlined, but in few places.
    #[inline(always)]
    fn apply_here(self, value: u64) -> u64 {
        match self.rule {
            ConversionRule::Keep => value,
            ConversionRule::Wrap => raw::narrow(value, self.to),
            ConversionRule::CopyBits => {
                // The mask keeps the shift in range for a text, which has no bits.
                let unused = 64_u32.wrapping_sub(self.from.bits()) & 63;
                match (value << unused, self.to.is_signed()) {
                    (bits, true) => (bits.cast_signed() >> unused).cast_unsigned(),
                    (bits, false) => bits >> unused,
                }
            }
            ConversionRule::NonZero => u64::from(real::is_nonzero(value, self.from)),
            ConversionRule::ToReal => real::from_integer(value, self.from, self.to),
            ConversionRule::BetweenReals => real::between(value, self.from, self.to),
            ConversionRule::ToWhole(rounding) => {
                real::encode(real::to_whole(real::decode(value, self.from), rounding), self.to)
            }
            ConversionRule::FromReal(rounding, out_of_range) => {
                let value = real::decode(value, self.from);
                from_real(value, self.to, rounding, out_of_range)
            }
            ConversionRule::ToUnits(units) => raw::narrow(moment::to_units(value, self.from, units), self.to),
            ConversionRule::ToRealUnits(units) => moment::to_real_units(value, self.from, self.to, units),
            ConversionRule::FromUnits(units) => moment::from_units(value, self.to, units),
            ConversionRule::FromRealUnits(units) => moment::from_real_units(value, self.from, self.to, units),
            ConversionRule::FromRealCount(rounding, out_of_range) => {
                let value = real::decode(value, self.from);
                let count = from_real(value, moment::counter(self.to), rounding, out_of_range);
                moment::from_units(count, self.to, MomentUnits::Counts)
            }
            ConversionRule::BetweenCounts => moment::between_counts(value, self.from, self.to),
            ConversionRule::ShortTime => {
                let milliseconds = moment::to_units(value, self.from, MomentUnits::ShortTime);
                moment::from_units(milliseconds, self.to, MomentUnits::ShortTime)
            }
            ConversionRule::Day => moment::day(value),
            ConversionRule::TimeOfDay => moment::time_of_day(value),
            ConversionRule::Character => text::character(value, self.to),
            ConversionRule::FromBcd => super::bcd::number(value, self.from, self.to),
            ConversionRule::ToBcd => super::bcd::encode(value, self.from, self.to),
            ConversionRule::ReadText(_)
            | ConversionRule::WriteText(..)
            | ConversionRule::BetweenTexts
            | ConversionRule::FirstCharacter
            | ConversionRule::CharacterToText => 0,
        }
    }

    /// Converts the raw forms of one slice, none of them a text, into another, each as [`Self::apply`] does; the shorter of the two decides how
    /// many. The rule is chosen once, outside the loop, which is what makes sweeps over all values of a type quick.
    pub fn apply_to_slice(self, operands: &[u64], results: &mut [u64]) {
        one_loop_for_each_rule!(self, conversion => {
            for (operand, result) in operands.iter().zip(results) {
                *result = conversion.apply_here(*operand);
            }
        });
    }

    /// The raw form of the result for a text operand, in code units; `None` where the text is no number of the type and the reading is one by
    /// which such a text gives none.
    pub fn spelled(self, units: &[u16]) -> Option<u64> {
        match self.rule {
            ConversionRule::ReadText(reading) => reading::spelled(units, self.to, reading),
            _ => Some(self.apply_from_text(units)),
        }
    }

    /// The raw form of the result for a text operand, in code units.
    pub fn apply_from_text(self, units: &[u16]) -> u64 {
        match self.rule {
            ConversionRule::FirstCharacter => {
                text::character(units.first().copied().unwrap_or(0).into(), self.to)
            }
            ConversionRule::ReadText(reading) => reading::spelled(units, self.to, reading).unwrap_or(0),
            _ => 0,
        }
    }

    /// The text, in code units, for the raw form of the operand.
    pub fn apply_to_text(self, value: u64) -> Vec<u16> {
        match self.rule {
            // A character's raw form has 16 bits at most.
            ConversionRule::CharacterToText => vec![text::character(value, self.to) as u16],
            ConversionRule::WriteText(reals, bits, moments) => {
                let text = writing::write(value, self.from, reals, bits, moments);
                text.bytes().map(u16::from).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The text for a text operand.
    pub fn text_to_text(self, units: &[u16]) -> Vec<u16> {
        text::between(units, self.to)
    }
}

/// The raw form of a real number as an integer or bit string. Inlined, so that little is left of it where the rule is known.
#[inline(always)]
fn from_real(value: f64, to: ElementaryType, rounding: Rounding, out_of_range: OutOfRange) -> u64 {
    match out_of_range {
        OutOfRange::Wrap => raw::narrow(real::to_integer(value, rounding), to),
        OutOfRange::Saturate => real::to_nearest_of(value, rounding, to),
        OutOfRange::Indefinite64 => raw::narrow(real::to_integer_of_64_bits(value, rounding, to), to),
        OutOfRange::Indefinite32 => raw::narrow(real::to_integer_of_32_bits(value, rounding), to),
    }
}
