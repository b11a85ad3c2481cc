//! The forms and the sizes of literals that should not be read, by which their defects are told apart.

use crate::words::{is_number, kind, type_of_word};
use std::collections::BTreeSet;
use stickler_types::ElementaryType;

/// The sizes of integers that compilers do not read, in their order.
pub(crate) const SIZES: [&str; 3] = [
    "integer of more than 31 bits",
    "integer of more than 63 bits",
    "integer of more than 64 bits",
];

/// Returns the forms of the literals of a line, where these are no plain numbers.
pub(crate) fn forms_of_literals(line: &str) -> BTreeSet<String> {
    let line = line.replace(":=", " ");
    line.split(ends).filter_map(form_of_number).collect()
}

/// Returns the words of a text in which a digit or the sign of a prefix stands, such as literals that should not be read.
pub(crate) fn words_with_digits(text: &str) -> BTreeSet<&str> {
    let has_digit = |word: &&str| word.contains(|sign: char| sign.is_ascii_digit() || sign == '#');
    text.split(ends).filter(has_digit).collect()
}

/// Returns whether a word ends before a character.
fn ends(sign: char) -> bool {
    sign.is_whitespace() || matches!(sign, ';' | '(' | ')' | ',' | '[' | ']')
}

/// Returns the form of a word with digits, without the prefix of a numeric type, where it is no plain number: `0e0` of `12e5`.
fn form_of_number(word: &str) -> Option<String> {
    let upper = word.to_ascii_uppercase();
    let prefixed = upper.split_once('#');
    let ty = type_of_word(&upper).filter(|_| prefixed.is_some());
    let number = prefixed.filter(|_| ty.is_some_and(is_number));
    let mut form = String::new();
    for character in number.map_or(upper.as_str(), |(_, number)| number).chars() {
        let shown = if character.is_ascii_digit() {
            '0'
        } else {
            character
        };
        if shown != '0' || !form.ends_with('0') {
            form.push(shown);
        }
    }
    let is_name = upper.starts_with(|first: char| first.is_ascii_alphabetic()) && prefixed.is_none();
    // Whatever it is a digit of, an underscore that separates no digits is read by mistake in one way.
    if !is_name && has_misplaced_underscore(&upper) {
        return Some("_".to_owned());
    }
    let moment = ty.and_then(|ty| form_of_moment(ty, form.split_once('#')?.1));
    let form = moment.unwrap_or(form);
    let is_plain = matches!(form.as_str(), "0" | "-0" | "0.0" | "-0.0");
    (!is_name && !is_plain && form.contains(['0', '#'])).then_some(form)
}

/// Returns whether an underscore of a literal stands elsewhere than between two digits, or between a unit of a duration and a digit.
pub(crate) fn has_misplaced_underscore(upper: &str) -> bool {
    let (prefix, value) = upper.rsplit_once('#').unwrap_or(("", upper));
    let is_hexadecimal = prefix.rsplit('#').next() == Some("16");
    let is_digit = |byte: u8| byte.is_ascii_digit() || is_hexadecimal && byte.is_ascii_hexdigit();
    let bytes = value.as_bytes();
    let separates = |at: usize| {
        let before = at.checked_sub(1).and_then(|before| bytes.get(before));
        let behind = bytes.get(at + 1);
        before.is_some_and(u8::is_ascii_alphanumeric) && behind.is_some_and(|byte| is_digit(*byte))
    };
    (0..bytes.len()).any(|at| bytes[at] == b'_' && !separates(at))
}

/// Returns the form of a duration or a time of day, without what does not matter of it: which units it has and in which order, how its
/// prefix is written, and the date before the time of day; `None` for other types.
fn form_of_moment(ty: ElementaryType, value: &str) -> Option<String> {
    match kind(ty)? {
        "duration" if value.bytes().filter(u8::is_ascii_alphabetic).count() > 1 => Some("T#0u0u".to_owned()),
        "duration" => Some(format!("T#{value}")),
        "date or time" if value.contains(':') => {
            let time = value.strip_prefix("0-0-0-").unwrap_or(value);
            Some(format!("TOD#{time}"))
        }
        _ => None,
    }
}

/// Returns how large an integer literal is that an `i32`, an `i64` or a `u64` does not hold, with which compilers read them; `None` of a
/// smaller one and of another literal.
pub(crate) fn size_of_integer(literal: &str) -> Option<&'static str> {
    let (digits, base) = integer(literal);
    if digits.is_empty() || !digits.chars().all(|digit| digit.is_digit(base)) {
        return None;
    }
    let bits =
        u128::from_str_radix(&digits, base).map_or(u128::BITS, |number| u128::BITS - number.leading_zeros());
    match bits {
        ..=31 => None,
        32..=63 => Some(SIZES[0]),
        64 => Some(SIZES[1]),
        _ => Some(SIZES[2]),
    }
}

/// Returns whether a literal is an integer with a type that does not hold it.
pub(crate) fn is_beyond_type(literal: &str) -> bool {
    let own = type_of_word(literal).filter(|_| literal.contains('#'));
    let own = own.zip(number_of_literal(literal));
    own.is_some_and(|(own, number)| own.integer_range().is_some() && !own.holds(number))
}

/// Returns the number that an integer literal is, in any base; `None` of another literal, and of one that 128 bits do not hold.
pub(crate) fn number_of_literal(literal: &str) -> Option<i128> {
    let (digits, base) = integer(literal);
    let number = i128::from_str_radix(&digits, base).ok()?;
    Some(if literal.contains('-') { -number } else { number })
}

/// Returns the digits of an integer literal without its sign, and their base.
fn integer(literal: &str) -> (String, u32) {
    let (prefix, digits) = literal.rsplit_once('#').unwrap_or(("", literal));
    let base = prefix.rsplit('#').next().and_then(|base| base.parse().ok());
    let digits = digits.trim_start_matches(['-', '+', ' ']).replace('_', "");
    (
        digits,
        base.filter(|base| matches!(base, 2 | 8 | 16)).unwrap_or(10),
    )
}
