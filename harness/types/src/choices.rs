//! The points in which documented systems differ, and the options of each: which types convert implicitly, and what a conversion
//! function does with the values that it cannot keep as they are.
//!
//! This module names the options; the file of a dialect says which of them it chooses. What an option means is implemented twice,
//! on purpose: by the reference implementation, and by `stickler-exact`, which the reference is tested against.

use crate::choice::{Choice, choices, choices_of_words, take};
use crate::words::words;
use std::borrow::Cow;
use toml::de::DeValue;

words! {
    /// The answer of a matrix, a document or a definition for one pair of types: the type of the value, and that of the
    /// target.
    MatrixWord {
        /// Accepted. In a matrix of implicit conversion: a value of the one type may be used wherever the other is
        /// expected, and is converted as by the function `<FROM>_TO_<TO>`.
        Yes = "yes",
        /// The two types are the same; treated like `yes`.
        Same = "=",
        /// Accepted with a warning, and otherwise like `yes`.
        Warn = "warn",
        /// Rejected.
        No = "no",
        /// No document decides; the result is recorded without an expectation.
        Open = "open",
    }
}

words! {
    /// The rounding of a real number to an integer.
    Rounding {
        /// The fraction is dropped (IEC 60559, roundTowardZero).
        Truncate = "truncate",
        /// To the nearest integer; from the middle between two to the even one (IEC 60559, roundTiesToEven).
        HalfToEven = "half-to-even",
        /// To the nearest integer; from the middle between two to the one with the greater magnitude (IEC 60559,
        /// roundTiesToAway).
        HalfAwayFromZero = "half-away-from-zero",
        /// To the least integer not below the number.
        Up = "up",
        /// To the greatest integer not above the number.
        Down = "down",
        /// To the integer next to the number with no smaller magnitude.
        AwayFromZero = "away-from-zero",
    }
}

impl Rounding {
    /// The roundings that a dialect may choose for `<REAL>_TO_<INTEGER>`; the others belong to CEIL and FLOOR.
    pub const OF_CONVERSIONS: [Rounding; 3] = [
        Rounding::Truncate,
        Rounding::HalfToEven,
        Rounding::HalfAwayFromZero,
    ];
}

words! {
    /// The result for a real number that, once rounded, lies outside the integer or bit string that it is converted to.
    ///
    /// The choice applies to functions from a real to an integer or bit string, and to nothing else: conversions among
    /// integers, of texts, and of durations and dates always wrap.
    OutOfRange {
        /// The exact integer modulo 2^n of the target; NaN and the infinities give 0.
        Wrap = "wrap",
        /// The nearest limit of the target, for the infinities too; NaN gives 0.
        Saturate = "saturate",
        /// The low bits of a 64-bit integer, which is -2^63 where the integer is none of 64 bits, and for NaN and the
        /// infinities. A target of 64 bits also takes the bits of an integer of 64 bits without a sign. A negative number first becomes at least -2^31 where the target has at most 32 bits: x86-64 converts it
        /// to 32 bits.
        Indefinite64 = "indefinite-64",
        /// The low bits of a 32-bit integer, which is -2^31 where the integer is none of 32 bits, and for NaN and the
        /// infinities.
        Indefinite32 = "indefinite-32",
    }
}

words! {
    /// The part of a text that must be a number, where an integer, a bit string or a real is read from it.
    ///
    /// Durations and dates are always read from the whole text, and BOOL but for one choice.
    TextReading {
        /// The whole text, except blanks at either end; otherwise the result is 0.
        WholeText = "whole-text",
        /// The whole text, and an integer must be in the range of its type; otherwise the result is 0.
        WholeTextInRange = "whole-text-in-range",
        /// The longest number at the beginning of the text, after any blanks: `12abc` gives 12; 0 if there is none.
        LeadingNumber = "leading-number",
        /// The longest number in decimal digits at the beginning, after any blanks and tabs; a real may begin or end with its
        /// point. BOOL is TRUE where the text begins with `TRUE` in upper case.
        LeadingDigits = "leading-digits",
        /// The whole text but blanks, tabs and the ends of lines and pages (the characters 9 to 13) at either end; a duration needs its prefix.
        WholeLiteral = "whole-literal",
        /// The whole text but underscores, wherever they are, and blanks at either end and behind the sign. A text that is no number of the type
        /// gives none: where a call of the function is all that is assigned, the variable keeps its value.
        LooseDigits = "loose-digits",
        /// The longest decimal number at the beginning, without an exponent, after any blanks; commas before its point do not count. An integer
        /// takes what is before the point, and is 0 where its type does not hold that.
        LeadingFixedPoint = "leading-fixed-point",
    }
}

words! {
    /// The form in which a bit string is written as text.
    BitStringText {
        /// All digits of the type in upper case: `16#00FF`.
        FullWidth = "full-width",
        /// No leading zeros, and lower case: `16#ff`, `16#0`.
        Shortest = "shortest",
        /// The number in decimal digits: `255`.
        Decimal = "decimal",
    }
}

words! {
    /// The meaning of the bits of a DWORD as a REAL, and of an LWORD as an LREAL, in either direction.
    ///
    /// A bit string and a real of different widths always exchange the number.
    BitsAsReal {
        /// The number that the bit string spells: `DWORD_TO_REAL(16#2)` is 2.0.
        Number = "number",
        /// The real whose bits, in the format of IEC 60559, are those of the bit string: `DWORD_TO_REAL(16#40000000)` is 2.0.
        Copy = "copy",
    }
}

words! {
    /// The bits that a bit string, or an integer with a sign, gets from an integer or bit string with fewer bits.
    ///
    /// An integer without a sign has the same bits either way.
    BitsAsInteger {
        /// The number: a bit string has none below 0, and a number below 0 fills a bit string with ones. `SINT_TO_WORD(-1)` is 16#FFFF,
        /// `BYTE_TO_INT(16#FF)` is 255.
        Number = "number",
        /// The bits of the operand: a bit string is filled with zeros, an integer with copies of the highest bit. `SINT_TO_WORD(-1)` is 16#00FF,
        /// `BYTE_TO_INT(16#FF)` is -1.
        Copy = "copy",
    }
}

words! {
    /// The bits of a BYTE, WORD, DWORD or LWORD that decide whether it converts to TRUE.
    BitStringAsBool {
        /// All of them: only zero is FALSE.
        AnyBit = "any-bit",
        /// The least significant one: an even number is FALSE.
        LowestBit = "lowest-bit",
    }
}

words! {
    /// The unit in which a number counts a duration, a time of day, and the time since 1970-01-01 of a date.
    MomentUnits {
        /// Milliseconds, and seconds for a date and for a date with a time.
        Seconds = "seconds",
        /// Milliseconds, and days for a date.
        DaysAndMilliseconds = "days-and-milliseconds",
        /// As `days-and-milliseconds`, but the days of a date are counted from 1990-01-01.
        DaysSince1990 = "days-since-1990",
        /// Each type is an integer that counts its own unit, modulo 2^n: TIME and TOD 32 bits of milliseconds, DATE and DT 32 bits
        /// of seconds, LTIME and LTOD 64 bits of nanoseconds without a sign, LDATE and LDT with one. A real number
        /// becomes such an integer as it becomes any other, and each type converts to each; only TOD gives LTIME its count,
        /// not its time.
        Counts = "counts",
        /// As `seconds`, but TIME is an integer of 32 bits with a sign that counts milliseconds: an integer or a duration becomes one modulo 2^32.
        ShortTime = "short-time",
    }
}

/// The digits in which a real number is written as text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealText {
    /// `shortest`: the canonical spelling, which has the fewest digits that read back to the same bits and always a point: `0.1`,
    /// `1.0E16`.
    Shortest,
    /// The exact value rounded to this number of significant digits, ties to even, as C's `printf` writes it with `%.{n}g`:
    /// without trailing zeros, and with an exponent below 1E-4 and from 10^n on (`0.5`, `1e+20`). 0 counts as 1. A number
    /// that is not finite keeps the word that [`RealText::Shortest`] has for it, so that it reads back.
    SignificantDigits(u8),
    /// `by-width`: seven significant digits of a REAL, or eight where its binary exponent, times 10 / 33 and rounded down, is below the decimal one, with an
    /// exponent of two digits below 1E-4 and from 1E8 on (`0.1`, `1E08`); fifteen of an LREAL, with an exponent below 1 and from 1E14 on
    /// (`1.0e-1`, `1.5`). The number is scaled in its own arithmetic, and a half is rounded away from zero. `#NaN`, `#Inf`, `-#Inf`.
    ByWidth,
}

words! {
    /// The form in which a duration, date or time of day is written as text.
    MomentText {
        /// The canonical literal with its shortest prefix: `T#1500ms`, `LDATE#2024-02-29`, `TOD#07:05:03.25`.
        Literal = "literal",
        /// A duration in its units, and a fraction in all three digits of a short type or nine of a long one: `T#1s500ms`,
        /// `LD#2024-02-29`, `TOD#07:05:03.250`.
        Components = "components",
    }
}

choices_of_words! {
    Rounding: &Rounding::OF_CONVERSIONS,
    OutOfRange,
    TextReading,
    BitStringText,
    MomentText,
    BitsAsReal,
    BitsAsInteger,
    BitStringAsBool,
    MomentUnits,
}

impl Choice for RealText {
    fn state(&mut self, _: &str, value: &DeValue<'_>) -> Result<(), String> {
        /// The permitted numbers of significant digits; a real number of 64 bits never needs more than 17.
        const DIGITS: std::ops::RangeInclusive<u8> = 1..=40;
        let digits = value
            .as_integer()
            .and_then(|number| u8::from_str_radix(number.as_str(), number.radix()).ok())
            .filter(|digits| DIGITS.contains(digits));
        *self = match (value.as_str(), digits) {
            (Some("shortest"), _) => RealText::Shortest,
            (Some("by-width"), _) => RealText::ByWidth,
            (None, Some(digits)) => RealText::SignificantDigits(digits),
            _ => {
                return Err(format!(
                    "is \"shortest\", \"by-width\", or a number of significant digits from {} to {}",
                    DIGITS.start(),
                    DIGITS.end()
                ));
            }
        };
        Ok(())
    }

    fn written(&self, _: &str) -> Cow<'static, str> {
        match self {
            RealText::Shortest => "shortest".into(),
            RealText::ByWidth => "by-width".into(),
            RealText::SignificantDigits(digits) => digits.to_string().into(),
        }
    }

    fn take(&mut self, number: usize) -> bool {
        let digits = [1, 6, 17].map(RealText::SignificantDigits);
        let all = [&[RealText::Shortest, RealText::ByWidth], &digits[..]].concat();
        take(self, &all, number)
    }
}

/// Declares the choices of `choices.toml`, which the build script puts into its call.
macro_rules! conversion_choices {
    ($($choices:tt)*) => {
        choices! {
            /// The choices of a dialect on which a conversion depends besides its types and its operand. By default real numbers become the
            /// nearest integer, numbers outside wrap, texts are read whole, and values are written as the wire protocol has them.
            ///
            /// Basis: iec-60559: Operations (rounding to nearest); forgeiec-conversion-functions: Range and precision, matiec conformance;
            /// ironplc-type-conversions: Explicit Conversion Functions; rule: not-stated for what is open.
            #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
            ConversionChoices { $($choices)* }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/conversion_choices.rs"));

impl ConversionChoices {
    /// Returns the keys of the choices, such as `conversions.rounding`.
    #[must_use]
    pub const fn keys() -> &'static [&'static str] {
        ConversionChoices::KEYS
    }

    /// Returns the choices with each other option for this key in turn.
    pub fn others(self, key: &str) -> impl Iterator<Item = ConversionChoices> {
        let with = move |number| {
            let mut other = self;
            other.own_choice_mut(key)?.take(number).then_some(other)
        };
        (0..).map_while(with).filter(move |other| *other != self)
    }

    /// Returns a copy with another rounding.
    #[must_use]
    pub const fn with_rounding(self, rounding: Rounding) -> ConversionChoices {
        ConversionChoices { rounding, ..self }
    }

    /// Returns a copy with the rounding and the range of TRUNC.
    #[must_use]
    pub const fn of_truncation(self) -> ConversionChoices {
        ConversionChoices {
            rounding: Rounding::Truncate,
            out_of_range: self.truncation_out_of_range,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_read_back_in_its_own_case_only() {
        assert_eq!(MatrixWord::from_word("yes"), Some(MatrixWord::Yes));
        assert_eq!(MatrixWord::from_word("Yes"), None);
        for rounding in Rounding::ALL {
            assert_eq!(Rounding::from_word(rounding.as_str()), Some(rounding));
        }
    }
}
