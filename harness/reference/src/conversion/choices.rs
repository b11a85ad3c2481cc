//! The choices in which conversion functions of documented systems differ. A dialect is made of one of each;
//! which rules ask for which choice is said at [`super::ConversionRule`].

use stickler_types::Definition;
use stickler_types::definition::{
    BitStringTextWord, OutOfRangeWord, RealTextWord, RoundingWord, TextReadingWord,
};

/// How a real number becomes an integer.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Rounding {
    /// The fraction is dropped.
    TowardZero,
    /// To nearest, ties to even (IEC 60559, roundTiesToEven).
    HalfToEven,
    /// To nearest, ties away from zero (IEC 60559, roundTiesToAway).
    HalfAwayFromZero,
    /// To the least integer not below the number.
    Up,
    /// To the greatest integer not above the number.
    Down,
}

/// What becomes of a real number that, once it is rounded, lies outside the integer or bit string that it is
/// converted to. A NaN gives 0 in both.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Outside {
    /// The exact integer modulo 2^n; the infinities give 0.
    Wrap,
    /// The limit of the target that is nearest, also for the infinities.
    Saturate,
}

/// How a text is read as a number.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TextReading {
    /// The whole text, but for spaces around it, is the number; anything else gives 0.
    WholeText,
    /// The longest beginning that is a number, spaces before it left out: `12abc` is 12; 0 where there is none.
    LeadingNumber,
}

/// How a real number is written.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealText {
    /// The fewest digits that read back to the same bits, as the wire protocol has them: `0.1`, `1.0E16`.
    Shortest,
    /// The exact value rounded to so many significant digits (at least one is taken), ties to even, trailing
    /// zeros dropped, with an exponent below 1E-4 and from that many digits on: C's `%.{n}g`, `0.5`, `1e+20`. A
    /// number that is not finite keeps the word that [`RealText::Shortest`] has for it, so that it reads back.
    SignificantDigits(u8),
}

/// How a bit string is written.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BitStringText {
    /// All hexadecimal digits of the type, in upper case: `16#00FF`.
    FullWidth,
    /// No leading zeros, in lower case: `16#ff`, `16#0`.
    Shortest,
}

/// One choice of each. What the five dialects choose is said at [`crate::Dialect`]'s constructors.
///
/// Basis: forgeiec-conversion-functions: Range and precision, matiec conformance;
/// ironplc-type-conversions: Explicit Conversion Functions; stickler-design: §8 (what is open).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ConversionChoices {
    /// How a real number becomes an integer or a bit string in a function that is neither TRUNC nor one of the
    /// rounding functions, each of which has a way of its own.
    pub real_to_integer: Rounding,
    /// What becomes of a real number outside the integer or bit string; also with TRUNC and ROUND. Integers that
    /// do not fit each other wrap whatever is chosen, and so do durations and dates.
    pub outside: Outside,
    /// How a text is read as an integer, a bit string or a real number. BOOL, durations and dates are always
    /// read as a whole.
    pub text_reading: TextReading,
    /// How REAL and LREAL are written.
    pub real_text: RealText,
    /// How BYTE, WORD, DWORD and LWORD are written.
    pub bit_string_text: BitStringText,
}

impl ConversionChoices {
    /// What every documented system has unless it says otherwise: truncation, wrapping, whole texts, and values
    /// written as the wire protocol has them.
    pub const COMMON: ConversionChoices = ConversionChoices {
        real_to_integer: Rounding::TowardZero,
        outside: Outside::Wrap,
        text_reading: TextReading::WholeText,
        real_text: RealText::Shortest,
        bit_string_text: BitStringText::FullWidth,
    };

    /// The same choices with another way from real numbers to integers.
    #[must_use]
    pub const fn rounding(self, real_to_integer: Rounding) -> ConversionChoices {
        ConversionChoices {
            real_to_integer,
            ..self
        }
    }

    /// The same choices, but for those that a definition makes otherwise.
    #[must_use]
    pub fn overridden(self, definition: &Definition) -> ConversionChoices {
        let Definition {
            rounding,
            out_of_range,
            text_reading,
            real_text,
            bit_string_text,
            ..
        } = definition;
        ConversionChoices {
            real_to_integer: rounding
                .as_ref()
                .map_or(self.real_to_integer, |stated| match stated.value {
                    RoundingWord::Truncate => Rounding::TowardZero,
                    RoundingWord::HalfToEven => Rounding::HalfToEven,
                    RoundingWord::HalfAwayFromZero => Rounding::HalfAwayFromZero,
                }),
            outside: out_of_range
                .as_ref()
                .map_or(self.outside, |stated| match stated.value {
                    OutOfRangeWord::Wrap => Outside::Wrap,
                    OutOfRangeWord::Saturate => Outside::Saturate,
                }),
            text_reading: text_reading
                .as_ref()
                .map_or(self.text_reading, |stated| match stated.value {
                    TextReadingWord::WholeText => TextReading::WholeText,
                    TextReadingWord::LeadingNumber => TextReading::LeadingNumber,
                }),
            real_text: real_text
                .as_ref()
                .map_or(self.real_text, |stated| match stated.value {
                    RealTextWord::Shortest => RealText::Shortest,
                    RealTextWord::SignificantDigits(digits) => RealText::SignificantDigits(digits),
                }),
            bit_string_text: bit_string_text.as_ref().map_or(self.bit_string_text, |stated| {
                match stated.value {
                    BitStringTextWord::FullWidth => BitStringText::FullWidth,
                    BitStringTextWord::Shortest => BitStringText::Shortest,
                }
            }),
        }
    }
}
