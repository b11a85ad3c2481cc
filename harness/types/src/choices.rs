//! The choices on which a conversion depends, and the answers for pairs of types that convert implicitly or do not.
//!
//! The file of a dialect says which [option](crate::Rounding) of each it chooses. What an option means is implemented twice, on purpose: by the
//! reference implementation, and by `stickler-exact`, which the reference is tested against.

use crate::choice::{Choice, choices, take};
use crate::options::{
    BitStringAsBool, BitStringText, BitsAsInteger, BitsAsReal, MomentText, MomentUnits, OutOfRange, Rounding,
    TextReading,
};
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
    pub const fn with_rounding(self, rounding: Rounding) -> ConversionChoices {
        ConversionChoices { rounding, ..self }
    }

    /// Returns a copy with the rounding and the range of TRUNC.
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
