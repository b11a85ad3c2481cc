//! Tables of a TOML document whose keys and values have positions.

use crate::near::advice;
use serde::de::{DeserializeOwned, IntoDeserializer};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A mistake, with its position in the text in bytes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigurationMistake {
    /// The position in the text, in bytes.
    pub span: Range<usize>,
    /// A description of the mistake and of what to do.
    pub message: String,
}

/// What is read of a file, or the first mistake in it.
pub type Read<T> = Result<T, ConfigurationMistake>;

impl ConfigurationMistake {
    /// Returns a mistake at a position.
    pub fn at(span: Range<usize>, message: impl Into<String>) -> ConfigurationMistake {
        ConfigurationMistake {
            span,
            message: message.into(),
        }
    }

    /// Returns the mistake of an unknown key of a table; `whose` describes the table.
    pub fn unknown_key(span: Range<usize>, key: &str, whose: &str, known: &[&str]) -> ConfigurationMistake {
        let message = format!("unknown key `{key}` {whose}; {}", advice(key, known));
        ConfigurationMistake::at(span, message)
    }
}

/// Returns a value as a table.
///
/// # Errors
/// A mistake, if the value is not a table.
pub fn table<'v, 'i>(name: &str, value: &'v Spanned<DeValue<'i>>) -> Read<&'v DeTable<'i>> {
    let table = value.get_ref().as_table();
    table.ok_or_else(|| other_type(name, value, "a table"))
}

/// Returns the mistake of a value that must be something else.
fn other_type(key: &str, value: &Spanned<DeValue<'_>>, must_be: &str) -> ConfigurationMistake {
    let found = value.get_ref().type_str();
    let message = format!("`{key}` must be {must_be}, and this is of type {found}");
    ConfigurationMistake::at(value.span(), message)
}

/// Returns a value as a text.
///
/// # Errors
/// A mistake, if the value is not a text.
pub fn text<'v>(key: &str, value: &'v Spanned<DeValue<'_>>) -> Read<&'v str> {
    let text = value.get_ref().as_str();
    text.ok_or_else(|| other_type(key, value, "a text in quotes"))
}

/// Deserializes a table as `T`; `whose` describes the table in messages, and `further` are keys that it may also have, for
/// suggestions.
///
/// # Errors
/// The first mistake that the deserialization of `T` finds.
pub fn read<T: DeserializeOwned>(
    table: &DeTable<'_>,
    span: Range<usize>,
    whose: &str,
    further: &[&str],
) -> Read<T> {
    let spanned = Spanned::new(span.clone(), table.clone());
    T::deserialize(spanned.into_deserializer()).map_err(|error| mistake(&error, span, whose, further))
}

/// Converts the error of a deserializer to a mistake at its position, with its lines joined; an unknown key gets a
/// suggestion.
pub fn mistake(
    error: &toml::de::Error,
    otherwise: Range<usize>,
    whose: &str,
    further: &[&str],
) -> ConfigurationMistake {
    let span = error.span().unwrap_or(otherwise);
    let message = error.message().trim_end().replace('\n', "; ");
    match unknown_field(&message) {
        Some((key, mut known)) => {
            known.extend(further);
            ConfigurationMistake::unknown_key(span, key, whose, &known)
        }
        None => ConfigurationMistake::at(span, message),
    }
}

/// Returns the unknown key that a message of serde reports, and the keys that it lists as known.
///
/// Basis: serde: `de::Error::unknown_field`.
fn unknown_field(message: &str) -> Option<(&str, Vec<&str>)> {
    let (key, known) = message
        .strip_prefix("unknown field `")?
        .split_once("`, expected ")?;
    // Every second piece stands between backquotes.
    Some((key, known.split('`').skip(1).step_by(2).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct KnownKeys {
        #[expect(dead_code, reason = "only its name is looked at")]
        check: Option<String>,
        #[expect(dead_code, reason = "only its name is looked at")]
        run: Option<String>,
    }

    fn mistake_in(text: &str) -> (String, String) {
        let document = DeTable::parse(text).unwrap();
        let mistake = read::<KnownKeys>(document.get_ref(), 0..text.len(), "of it", &[]).unwrap_err();
        (text[mistake.span].to_owned(), mistake.message)
    }

    #[test]
    fn an_unknown_key_is_told_where_it_stands_with_the_one_that_was_meant() {
        let (place, message) = mistake_in("run = \"a\"\nchek = \"b\"\n");
        assert_eq!(place, "chek");
        assert_eq!(message, "unknown key `chek` of it; did you mean `check`?");
    }

    #[test]
    fn a_value_of_another_type_is_told_where_it_stands() {
        let (place, message) = mistake_in("check = 5\n");
        assert_eq!(place, "5");
        assert!(message.contains("expected a string"), "{message}");
    }
}
