//! The forms of literals that should not be read, by which their defects are told apart.

use crate::words::{is_number, kind, type_of_word};
use std::collections::BTreeSet;
use stickler_types::ElementaryType;

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
    // Whatever it is a digit of, one with an underscore behind the last is read by mistake in one way. The unit of a duration may stand
    // behind it.
    let is_digit = |byte: u8| byte.is_ascii_hexdigit() || matches!(byte, b'_' | b'.' | b'#');
    let ends = form.ends_with('_') && form.trim_start_matches(['-', '+']).bytes().all(is_digit);
    let value = form.rsplit('#').next().unwrap_or_default();
    let is_before_unit = |rest: &str| rest.bytes().all(|byte| byte.is_ascii_alphabetic());
    if ends || value.strip_prefix("0_").is_some_and(is_before_unit) {
        return Some("0_".to_owned());
    }
    let is_name = upper.starts_with(|first: char| first.is_ascii_alphabetic()) && prefixed.is_none();
    let moment = ty.and_then(|ty| form_of_moment(ty, form.split_once('#')?.1));
    let form = moment.unwrap_or(form);
    let is_plain = matches!(form.as_str(), "0" | "-0" | "0.0" | "-0.0");
    (!is_name && !is_plain && form.contains(['0', '#'])).then_some(form)
}

/// Returns the form of a duration or a time of day, without what does not matter of it: which units it has and in which order, how its
/// prefix is written, and the date before the time of day; `None` for other types.
fn form_of_moment(ty: ElementaryType, value: &str) -> Option<String> {
    match kind(ty)? {
        // A compiler reads the units by one rule, and the digits before them by another.
        "duration" if value.contains('_') => Some("T#0_0u".to_owned()),
        "duration" if value.bytes().filter(u8::is_ascii_alphabetic).count() > 1 => Some("T#0u0u".to_owned()),
        "duration" => Some(format!("T#{value}")),
        "date or time" if value.contains(':') => {
            let time = value.strip_prefix("0-0-0-").unwrap_or(value);
            Some(format!("TOD#{time}"))
        }
        _ => None,
    }
}
