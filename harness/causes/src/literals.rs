//! The forms of literals, and the types that tokens name.

use crate::shape::{number, text};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::BTreeSet;
use stickler_types::{ElementaryType, Family};

/// The form of a literal of the durations, dates and times of day that the third edition brought.
pub(crate) const LONG: &str = "long duration, date or time#";

/// Returns the type that a token names, as a word or as the prefix of a literal.
pub(crate) fn type_of_token(token: &ProgramToken<'_>) -> Option<ElementaryType> {
    let upper = token.text.to_ascii_uppercase();
    match token.kind {
        ProgramTokenKind::Word => ElementaryType::from_name(&upper),
        ProgramTokenKind::Typed => ElementaryType::from_literal_prefix(upper.split_once('#')?.0),
        _ => None,
    }
}

/// Returns the types that a program names and between which values are converted.
pub(crate) fn valued_types(tokens: &[ProgramToken<'_>]) -> BTreeSet<ElementaryType> {
    let types = tokens.iter().filter_map(type_of_token);
    types.filter(|ty| kind(*ty).is_some()).collect()
}

/// Returns the kind of values between which conversions are one piece of work in a compiler; `None` for BOOL, which is the
/// type of comparisons too.
pub(crate) const fn kind(ty: ElementaryType) -> Option<&'static str> {
    Some(match ty.family() {
        Family::Boolean => return None,
        Family::Signed | Family::Unsigned | Family::BitString => "integer",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date | Family::TimeOfDay | Family::DateAndTime => "date or time",
        Family::Text | Family::Character => "text",
    })
}

/// Returns the form of a word with digits, without the prefix of a numeric type, where it is no plain number: `0e0` of `12e5`.
pub(crate) fn form_of_number(word: &str) -> Option<String> {
    let upper = word.to_ascii_uppercase();
    let number = upper.split_once('#').filter(|(prefix, _)| {
        let ty = ElementaryType::from_literal_prefix(prefix);
        ty.is_some_and(|ty| kind(ty).is_some_and(|kind| matches!(kind, "integer" | "real")))
    });
    let number = number.map_or(upper.as_str(), |(_, number)| number);
    let mut form = String::new();
    for character in number.chars() {
        let shown = if character.is_ascii_digit() {
            '0'
        } else {
            character
        };
        if shown != '0' || !form.ends_with('0') {
            form.push(shown);
        }
    }
    // Whatever it is a digit of, one with an underscore behind the last is read by mistake in one way.
    let of_digits = |form: &str| {
        form.trim_start_matches(['-', '+'])
            .bytes()
            .all(|byte| byte.is_ascii_hexdigit() || matches!(byte, b'_' | b'.' | b'#'))
    };
    // The unit of a duration may stand behind it.
    let value = form.rsplit('#').next().unwrap_or_default();
    let is_before_unit = |rest: &str| rest.bytes().all(|byte| byte.is_ascii_alphabetic());
    if form.ends_with('_') && of_digits(&form) || value.strip_prefix("0_").is_some_and(is_before_unit) {
        return Some("0_".to_owned());
    }
    let is_name = upper.starts_with(|first: char| first.is_ascii_alphabetic()) && !upper.contains('#');
    let form = upper
        .split_once('#')
        .and_then(|(prefix, _)| form_of_moment(ElementaryType::from_literal_prefix(prefix)?, &form))
        .unwrap_or(form);
    (!is_name && !matches!(form.as_str(), "0" | "-0" | "0.0" | "-0.0") && form.contains(['0', '#']))
        .then_some(form)
}

/// Returns the form of a duration or a time of day, without what does not matter of it: which units it has, how its prefix is
/// written, and the date before the time of day; `None` for other types.
fn form_of_moment(ty: ElementaryType, form: &str) -> Option<String> {
    let (_, value) = form.split_once('#')?;
    match ty.family() {
        Family::Duration => {
            let mut units = String::from("T#");
            for character in value.chars() {
                match character.is_ascii_alphabetic() {
                    true if units.ends_with('u') => {}
                    true => units.push('u'),
                    false => units.push(character),
                }
            }
            Some(units)
        }
        Family::DateAndTime => Some(format!("TOD#{}", value.strip_prefix("0-0-0-")?)),
        Family::TimeOfDay => Some(format!("TOD#{value}")),
        _ => None,
    }
}

/// Returns the number of the line of a program with a number that a message names; one of one digit stands in too many messages.
pub(crate) fn line_with_number(program: &str, message: &str) -> Option<u32> {
    let all = tokens(program);
    let mut words = message.split(|character: char| !character.is_ascii_digit());
    words.find_map(|number| {
        let is_number = |token: &&ProgramToken<'_>| number.len() > 1 && token.text == number;
        Some(all.iter().find(is_number)?.line)
    })
}

/// Returns the form of a literal that a compiler may not know; plain numbers and truth values are none.
pub(crate) fn special_literal(token: &ProgramToken<'_>) -> Option<String> {
    let upper = token.text.to_ascii_uppercase();
    match token.kind {
        ProgramTokenKind::Number => {
            Some(number(&upper)).filter(|form| !matches!(form.as_str(), "integer" | "real"))
        }
        ProgramTokenKind::Text => Some(text(token.text)).filter(|form| form != "'text'"),
        ProgramTokenKind::Typed => {
            let (prefix, value) = upper.split_once('#')?;
            let is_number = type_of_token(token)
                .is_some_and(|ty| kind(ty).is_some_and(|kind| matches!(kind, "integer" | "real")));
            let form = number(value.trim_start_matches('-'));
            match is_number {
                true => Some(form).filter(|form| form == "real-beyond-REAL"),
                // Dates and times of day are read by one piece of work.
                false => match type_of_token(token) {
                    // The numbers 0 and 1 are another form than the names of the truth values.
                    Some(ElementaryType::Bool) if form == "integer" && value.starts_with(['0', '1']) => {
                        Some("BOOL#digits".to_owned())
                    }
                    Some(ty) if ty.is_third_edition() && kind(ty) != Some("text") => Some(LONG.to_owned()),
                    Some(ty) if kind(ty) == Some("date or time") => Some("date or time#".to_owned()),
                    Some(ty) => Some(format!("{}#", ty.name())),
                    None => Some(format!("{prefix}#")),
                },
            }
        }
        _ => None,
    }
}
