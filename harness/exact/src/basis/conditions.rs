//! The conditions of the rows of `basis.toml`, which the operand of a call meets or not.

use super::{UnaryCall, texts};
use crate::real::{self, Real, Whole};
use crate::{bcd, integer, moment};
use stickler_types::{ElementaryType, Family, MomentUnits, Rounding, Value, words};

words! {
    /// A condition on the operand and the types of a call, under which a row of the table states its result.
    Condition {
        /// The types differ.
        AnotherType = "another type",
        /// The types have as many bits.
        SameWidth = "same width",
        /// The target holds the number.
        Held = "held",
        /// The integer is negative and the target has more bits.
        SignExtended = "sign extended",
        /// The integer is not negative, or the target has no more bits than it.
        NoSignExtended = "no sign extended",
        /// The real is a number.
        Finite = "finite",
        /// The real is a NaN or an infinity.
        NotFinite = "not finite",
        /// The real, or what its bits are as one, is a number or an infinity.
        NoNaN = "no NaN",
        /// The real is a number or a NaN.
        NotInfinite = "not infinite",
        /// The real has no sign.
        NotNegative = "not negative",
        /// The real is zero, or lies within 2^-126 and 2^127.
        NearOne = "near 1",
        /// The target holds the real without its fraction.
        TruncatedInside = "truncated inside",
        /// The target holds the integer that is nearest to the real, of two the even one.
        NearestInside = "nearest inside",
        /// The target would hold that integer if it were an integer with a sign.
        NearestSigned = "nearest inside with a sign",
        /// A date and time whose day a date holds.
        HasDay = "has a day",
        /// A date and time that every system holds.
        InEveryRange = "in every range",
        /// The duration is a whole number of milliseconds, and the number holds them, exactly or as the nearest real.
        Milliseconds = "milliseconds",
        /// The duration is a whole number of milliseconds that 32 bits with a sign hold.
        ShortMilliseconds = "milliseconds of 32 bits",
        /// The time of day is a whole number of milliseconds that the target holds.
        MillisecondsOfDay = "milliseconds of a day",
        /// Every digit of the bit string is a decimal one.
        DecimalDigits = "decimal digits",
        /// The number is not negative and has no more digits than the bit string.
        AsManyDigits = "as many digits",
        /// The text certainly spells a number of the type.
        PlainNumber = "plain number",
        /// The text certainly spells none.
        NoNumber = "no number",
    }
}

impl UnaryCall<'_> {
    /// Returns whether an operand meets a condition; a text meets only those of texts.
    pub(super) fn meets(self, condition: Condition, operand: &Value) -> bool {
        let raw = match operand {
            Value::Plain { raw, .. } => *raw,
            Value::Text { units, .. } => match condition {
                Condition::PlainNumber => return texts::is_plain_number(units, self.to),
                Condition::NoNumber => return texts::is_no_number(units, self.to),
                _ => return false,
            },
            _ => return false,
        };
        let of_real = if self.from.is_real() { self.from } else { self.to };
        let real = || real::decode(raw, of_real);
        let number = || integer::number(raw, self.from);
        let extends_sign = || number() < 0 && self.to.bits() > self.from.bits();
        match condition {
            Condition::AnotherType => self.from != self.to,
            Condition::SameWidth => self.from.bits() == self.to.bits(),
            Condition::Held => self.to.holds(number()),
            Condition::SignExtended => extends_sign(),
            Condition::NoSignExtended => !extends_sign(),
            Condition::Finite => matches!(real(), Real::Finite(_)),
            Condition::NotFinite => !matches!(real(), Real::Finite(_)),
            Condition::NoNaN => real() != Real::NotANumber,
            Condition::NotInfinite => !matches!(real(), Real::Infinite { .. }),
            Condition::NotNegative => !matches!(real(), Real::Finite(number) if number.negative),
            Condition::NearOne => {
                !matches!(real(), Real::Finite(number) if number.significand > 0 && !(-178..=74).contains(&number.exponent))
            }
            Condition::TruncatedInside => self.holds_rounded(raw, Rounding::Truncate),
            Condition::NearestInside => self.holds_rounded(raw, Rounding::HalfToEven),
            Condition::NearestSigned => matches!(
                self.whole(raw, Rounding::HalfToEven),
                Some(Whole::Number(number)) if integer::of_bits(number, self.to.bits(), ElementaryType::Lint) == number
            ),
            Condition::HasDay => moment::has_day(raw),
            Condition::InEveryRange => moment::is_in_every_range(raw),
            Condition::Milliseconds => self.whole_milliseconds(raw).is_some(),
            Condition::ShortMilliseconds => self
                .whole_milliseconds(raw)
                .is_some_and(|milliseconds| i32::try_from(milliseconds).is_ok()),
            Condition::MillisecondsOfDay => {
                let units = MomentUnits::DaysAndMilliseconds;
                moment::has_whole_units(raw, self.from, units)
                    && self.to.holds(moment::units(raw, self.from, units))
            }
            Condition::DecimalDigits => bcd::is_decimal(raw, self.from),
            Condition::AsManyDigits => (0..=bcd::greatest(self.to)).contains(&number()),
            Condition::PlainNumber | Condition::NoNumber => false,
        }
    }

    /// Returns the milliseconds that TIME and a number have in common, if both hold them.
    fn whole_milliseconds(self, raw: u64) -> Option<i128> {
        // The unit of a duration is the same, whatever counts a date.
        let calendar = MomentUnits::Seconds;
        match (self.from.family(), self.to.family()) {
            (
                Family::Duration,
                Family::Signed | Family::Unsigned | Family::Real | Family::BitString | Family::Boolean,
            ) => {
                let units = moment::units(raw, self.from, calendar);
                let holds = self.to.is_real() || self.to == ElementaryType::Bool || self.to.holds(units);
                (holds && moment::has_whole_units(raw, self.from, calendar)).then_some(units)
            }
            (Family::Signed | Family::Unsigned | Family::BitString | Family::Boolean, Family::Duration) => {
                let number = integer::number(raw, self.from);
                moment::fits(moment::of_units(number, self.to, calendar)).then_some(number)
            }
            (Family::Real, Family::Duration)
                if moment::is_whole_moment(raw, self.from, self.to, calendar) =>
            {
                let duration = moment::from_real_units(raw, self.from, self.to, calendar);
                Some(moment::units(duration, self.to, calendar))
            }
            _ => None,
        }
    }

    /// Returns whether the target holds the rounded operand.
    fn holds_rounded(self, raw: u64, rounding: Rounding) -> bool {
        matches!(self.whole(raw, rounding), Some(Whole::Number(number)) if self.to.holds(number))
    }

    /// Returns the operand, rounded to an integer; `None` for a NaN and the infinities.
    fn whole(self, raw: u64, rounding: Rounding) -> Option<Whole> {
        match real::decode(raw, self.from) {
            Real::Finite(number) => Some(real::to_whole(number, rounding)),
            _ => None,
        }
    }
}
