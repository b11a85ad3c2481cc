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
    let mut quoted = None;
    let varied: String = text
        .chars()
        .map(|letter| match quoted {
            // A quote in a character string follows a dollar, or is written by its code; the writer spells it `$'`, and the state
            // `Escaped` passes over it.
            Some(QuoteState::Escaped(quote)) => {
                quoted = Some(QuoteState::In(quote));
                letter
            }
            Some(QuoteState::In(_)) if letter == '$' => {
                quoted = quoted.map(QuoteState::escaped);
                letter
            }
            Some(QuoteState::In(quote)) => {
                if letter == quote {
                    quoted = None;
                }
                letter
            }
            None if matches!(letter, '\'' | '"') => {
                quoted = Some(QuoteState::In(letter));
                letter
            }
            None => {
                bits = bits.rotate_left(1);
                in_case(letter, bits & 1 == 1)
            }
        })
        .collect();
    (varied != text).then_some(varied)
}

/// The position of the scanner in a character string: inside it, or after a dollar sign; holds the quote that ends it.
#[derive(Clone, Copy)]
enum QuoteState {
    In(char),
    Escaped(char),
}

impl QuoteState {
    const fn escaped(self) -> QuoteState {
        match self {
            QuoteState::In(quote) | QuoteState::Escaped(quote) => QuoteState::Escaped(quote),
        }
    }
}

const fn in_case(letter: char, lower: bool) -> char {
    if lower {
        letter.to_ascii_lowercase()
    } else {
        letter.to_ascii_uppercase()
    }
}
