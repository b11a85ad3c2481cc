//! The case of letters: keywords, names, types, functions, the letters in numbers and durations.
//!
//! Basis: iec-61131-3: 6.1.2 (identifiers and keywords do not distinguish cases; literals neither, but for the characters of
//! texts).

use crate::model::Program;
use crate::random::Random;
use crate::writer::{Style, write};

/// Writes a program with each letter outside character strings in a random case; `None` if that changes nothing.
pub(super) fn random_case(program: &Program, random: &mut Random<'_, '_>) -> Option<String> {
    let text = write(program, &Style::default()).text;
    let mut bits = random.bits() | 1;
    // The quote that ends the character string, and whether a dollar precedes: a quote in a string follows one, or is written by
    // its code.
    let (mut quoted, mut escaped) = (None, false);
    let varied: String = text
        .chars()
        .map(|letter| {
            if let Some(quote) = quoted {
                quoted = quoted.filter(|_| escaped || letter != quote);
                escaped = !escaped && letter == '$';
                return letter;
            }
            quoted = matches!(letter, '\'' | '"').then_some(letter);
            if quoted.is_some() {
                return letter;
            }
            bits = bits.rotate_left(1);
            in_case(letter, bits & 1 == 1)
        })
        .collect();
    (varied != text).then_some(varied)
}

const fn in_case(letter: char, lower: bool) -> char {
    if lower {
        letter.to_ascii_lowercase()
    } else {
        letter.to_ascii_uppercase()
    }
}
