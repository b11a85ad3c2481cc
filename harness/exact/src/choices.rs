//! The points in which systems convert differently, and what each dialect chooses.

use stickler_types::definition::{
    BitStringTextWord, OutOfRangeWord, RealTextWord, RoundingWord, TextReadingWord,
};
use stickler_types::{BuiltIn, Definition, DialectName};

/// Everything that a conversion depends on besides its types and its operand.
///
/// [`Choices::of`] gives those of a dialect. Others describe dialects yet to come, and serve to recognise the rules that a
/// foreign compiler follows.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Choices {
    /// How a conversion function that is neither TRUNC nor ROUND or its kin makes an integer of a real number.
    pub real_to_integer: RealToInteger,
    /// What a real number becomes whose integer the target does not hold.
    pub outside: Outside,
    /// How much of a text must be a number.
    pub text_reading: TextReading,
    /// Which digits a real number has as text.
    pub real_text: RealText,
    /// How a bit string is written as text.
    pub bit_string_text: BitStringText,
}

/// How a real number becomes an integer.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealToInteger {
    /// The fraction is dropped.
    Truncate,
    /// To the nearest integer; from the middle between two to the even one (IEC 60559, roundTiesToEven).
    HalfToEven,
    /// To the nearest integer; from the middle between two to the one with the greater magnitude (roundTiesToAway).
    HalfAwayFromZero,
}

/// What a real number becomes in an integer or bit string that does not hold its integer.
///
/// It matters for every function from a real to an integer or bit string, TRUNC and ROUND among them, and for nothing else:
/// integers among each other, texts, durations and dates always wrap.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Outside {
    /// The integer modulo 2^n of the target; NaN and the infinities give 0.
    Wrap,
    /// The nearest limit of the target, for the infinities too; NaN gives 0.
    Saturate,
}

/// How much of a text must be a number, where an integer, a bit string or a real is read from it.
///
/// BOOL, durations and dates are always read from the whole text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TextReading {
    /// All of it, blanks at either end aside; otherwise the result is 0.
    WholeText,
    /// The longest part at its beginning, blanks in front aside, that is a number: `12abc` gives 12; 0 where there is none.
    LeadingNumber,
}

/// Which digits a real number has as text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealText {
    /// The canonical spelling: the fewest digits that read back to the same bits, always with a point.
    Shortest,
    /// That many significant digits, as C's `printf` writes them with `%.{n}g`; 0 counts as 1.
    SignificantDigits(u8),
}

/// How a bit string is written as text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BitStringText {
    /// All digits of the type in upper case: `16#00FF`.
    FullWidth,
    /// No zeros in front, and lower case: `16#ff`.
    Shortest,
}

impl Choices {
    /// What a dialect chooses.
    ///
    /// Basis: ironplc-type-conversions: Explicit Conversion Functions and forgeiec-conversion-functions: Range and precision
    /// (truncation); stickler-design: §8 for all that is open. The texts of `matiec` are measured (10 digits, `16#ff`).
    #[must_use]
    pub fn of(dialect: DialectName) -> Choices {
        let base = Choices::of_base(dialect.base());
        match dialect.definition() {
            None => base,
            Some(definition) => base.overridden(definition),
        }
    }

    const fn of_base(base: BuiltIn) -> Choices {
        let ironplc = Choices {
            real_to_integer: RealToInteger::Truncate,
            outside: Outside::Wrap,
            text_reading: TextReading::WholeText,
            real_text: RealText::Shortest,
            bit_string_text: BitStringText::FullWidth,
        };
        match base {
            BuiltIn::IronplcEd2 | BuiltIn::IronplcEd3 | BuiltIn::IronplcRusty => ironplc,
            BuiltIn::Matiec => Choices {
                real_text: RealText::SignificantDigits(10),
                bit_string_text: BitStringText::Shortest,
                ..ironplc
            },
            BuiltIn::Plcnext => Choices {
                real_to_integer: RealToInteger::HalfToEven,
                ..ironplc
            },
        }
    }

    /// These, with what a definition states in place of what they say.
    fn overridden(mut self, definition: &Definition) -> Choices {
        if let Some(stated) = &definition.rounding {
            self.real_to_integer = match stated.value {
                RoundingWord::Truncate => RealToInteger::Truncate,
                RoundingWord::HalfToEven => RealToInteger::HalfToEven,
                RoundingWord::HalfAwayFromZero => RealToInteger::HalfAwayFromZero,
            };
        }
        if let Some(stated) = &definition.out_of_range {
            self.outside = match stated.value {
                OutOfRangeWord::Wrap => Outside::Wrap,
                OutOfRangeWord::Saturate => Outside::Saturate,
            };
        }
        if let Some(stated) = &definition.text_reading {
            self.text_reading = match stated.value {
                TextReadingWord::WholeText => TextReading::WholeText,
                TextReadingWord::LeadingNumber => TextReading::LeadingNumber,
            };
        }
        if let Some(stated) = &definition.real_text {
            self.real_text = match stated.value {
                RealTextWord::Shortest => RealText::Shortest,
                RealTextWord::SignificantDigits(digits) => RealText::SignificantDigits(digits),
            };
        }
        if let Some(stated) = &definition.bit_string_text {
            self.bit_string_text = match stated.value {
                BitStringTextWord::FullWidth => BitStringText::FullWidth,
                BitStringTextWord::Shortest => BitStringText::Shortest,
            };
        }
        self
    }
}
