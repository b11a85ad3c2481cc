//! The points in which documented systems differ, and the options of each: which types convert implicitly, and what a conversion
//! function does with the values that it cannot keep as they are.
//!
//! This module names the options. Which of them a dialect chooses is stated twice, on purpose: by the reference implementation,
//! and by `stickler-exact`, which the reference is tested against.

use crate::Definition;
use crate::words::words;

words! {
    /// What a matrix, a document or a definition says of one pair of types: of the value, and of the target.
    MatrixWord {
        /// Accepted. In a matrix of implicit conversion: a value of the one type stands wherever the other is expected, and becomes
        /// what the conversion function `<FROM>_TO_<TO>` gives.
        Yes = "yes",
        /// The two types are the same; treated like `yes`.
        Same = "=",
        /// Rejected.
        No = "no",
        /// No document says; what happens is recorded.
        Open = "open",
    }
}

words! {
    /// How a real number becomes an integer.
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
    /// What a real number becomes that, once it is rounded, lies outside the integer or bit string that it is converted to.
    ///
    /// It matters for every function from a real to an integer or bit string, TRUNC and ROUND among them, and for nothing else:
    /// integers among each other, texts, durations and dates always wrap.
    OutOfRange {
        /// The exact integer modulo 2^n of the target; NaN and the infinities give 0.
        Wrap = "wrap",
        /// The nearest limit of the target, for the infinities too; NaN gives 0.
        Saturate = "saturate",
    }
}

words! {
    /// How much of a text must be a number, where an integer, a bit string or a real is read from it.
    ///
    /// BOOL, durations and dates are always read from the whole text.
    TextReading {
        /// All of it, blanks at either end aside; otherwise the result is 0.
        WholeText = "whole-text",
        /// The longest part at its beginning, blanks in front aside, that is a number: `12abc` gives 12; 0 where there is none.
        LeadingNumber = "leading-number",
    }
}

words! {
    /// How a bit string is written as text.
    BitStringText {
        /// All digits of the type in upper case: `16#00FF`.
        FullWidth = "full-width",
        /// No zeros in front, and lower case: `16#ff`, `16#0`.
        Shortest = "shortest",
    }
}

/// Which digits a real number has as text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealText {
    /// `shortest`: the canonical spelling, which has the fewest digits that read back to the same bits and always a point: `0.1`,
    /// `1.0E16`.
    Shortest,
    /// The exact value rounded to that many significant digits, ties to even, as C's `printf` writes it with `%.{n}g`: trailing
    /// zeros dropped, with an exponent below 1E-4 and from that many digits on (`0.5`, `1e+20`). 0 counts as 1. A number that is
    /// not finite keeps the word that [`RealText::Shortest`] has for it, so that it reads back.
    SignificantDigits(u8),
}

/// Everything that a conversion depends on besides its types and its operand: one option of each choice.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ConversionChoices {
    /// How a conversion function that is neither TRUNC nor ROUND or its kin makes an integer of a real number.
    pub rounding: Rounding,
    /// What a real number becomes whose integer the target does not hold.
    pub out_of_range: OutOfRange,
    /// How much of a text must be a number.
    pub text_reading: TextReading,
    /// Which digits REAL and LREAL have as text.
    pub real_text: RealText,
    /// How BYTE, WORD, DWORD and LWORD are written as text.
    pub bit_string_text: BitStringText,
}

impl ConversionChoices {
    /// Returns these choices with another rounding.
    #[must_use]
    pub const fn with_rounding(self, rounding: Rounding) -> ConversionChoices {
        ConversionChoices { rounding, ..self }
    }

    /// Returns these choices with those that a definition states in their place.
    #[must_use]
    pub fn overridden(self, definition: &Definition) -> ConversionChoices {
        fn stated<T: Copy>(stated: &Option<crate::Stated<T>>, otherwise: T) -> T {
            stated.as_ref().map_or(otherwise, |stated| stated.value)
        }
        ConversionChoices {
            rounding: stated(&definition.rounding, self.rounding),
            out_of_range: stated(&definition.out_of_range, self.out_of_range),
            text_reading: stated(&definition.text_reading, self.text_reading),
            real_text: stated(&definition.real_text, self.real_text),
            bit_string_text: stated(&definition.bit_string_text, self.bit_string_text),
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
            assert_eq!(Rounding::from_word(rounding.as_str()), Some(*rounding));
        }
    }
}
