//! Reads TOML with positions: every mistake has the line and the key that it belongs to.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{self, DeserializeOwned, Deserializer, MapAccess, SeqAccess, Visitor};
use toml::Spanned;

use crate::error::Mistake;
use crate::place::Lines;

/// Reads a document that stands at `start` of a file, whose lines are `lines`.
pub(crate) fn read<T: DeserializeOwned>(document: &str, start: usize, lines: &Lines) -> Result<T, Mistake> {
    toml::from_str(document).map_err(|error| mistake(error, start, lines))
}

fn mistake(mut error: toml::de::Error, start: usize, lines: &Lines) -> Mistake {
    let offset = error.span().map_or(0, |span: Range<usize>| span.start);
    // Without its input, the error names the keys that lead to the place.
    error.set_input(None);
    let reported = error.to_string();
    let key = reported
        .rsplit_once("\nin `")
        .and_then(|(_, keys)| keys.trim_end().strip_suffix('`'));
    let mistake = Mistake::new(
        lines.line(start + offset),
        error.message().trim_end().replace('\n', "; "),
    );
    match key {
        Some(key) => mistake.key(key),
        None => mistake,
    }
}

/// Returns the entries of a table in the order in which the file has them.
pub(crate) fn in_order<T>(table: BTreeMap<Spanned<String>, T>) -> Vec<(Spanned<String>, T)> {
    let mut entries: Vec<(Spanned<String>, T)> = table.into_iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries
}

/// One string, or several.
#[derive(Clone, Debug, Default)]
pub(crate) struct Strings(pub(crate) Vec<Spanned<String>>);

/// A key that is either a string or a list of `T`.
#[derive(Clone, Debug)]
pub(crate) enum TextOr<T> {
    Text(String),
    List(Vec<T>),
}

/// A string, a number or a truth value of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Scalar {
    Text(String),
    /// A number, whose spelling is taken from the text of the file.
    Number,
    Truth(bool),
}

impl Scalar {
    /// Returns the scalar as programs spell it; `written` is its text in the file.
    pub(crate) fn spelling(&self, written: &str) -> Box<str> {
        match self {
            Scalar::Text(text) => text.as_str().into(),
            Scalar::Number => written.into(),
            Scalar::Truth(true) => "TRUE".into(),
            Scalar::Truth(false) => "FALSE".into(),
        }
    }
}

impl<'de> Deserialize<'de> for Strings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = Spanned::<TextOr<Spanned<String>>>::deserialize(deserializer)?;
        let span = key.span();
        Ok(Strings(match key.into_inner() {
            TextOr::Text(text) => vec![Spanned::new(span, text)],
            TextOr::List(list) => list,
        }))
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for TextOr<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TextOrVisitor(std::marker::PhantomData))
    }
}

struct TextOrVisitor<T>(std::marker::PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for TextOrVisitor<T> {
    type Value = TextOr<T>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a string or an array")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(TextOr::Text(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Self::Value, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(TextOr::List)
    }
}

impl<'de> Deserialize<'de> for Scalar {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ScalarVisitor)
    }
}

struct ScalarVisitor;

/// A text that is written many times, so that a case file can have a program of a size that nobody writes.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Repetition {
    /// The text, in which `{number}` stands for the number of the repetition, and `{before}` for the one before it.
    text: String,
    times: u32,
}

impl Repetition {
    /// The largest number of times, which is more than two bytes count.
    const MAX_TIMES: u32 = 100_000;

    fn written_out(&self) -> String {
        let written = (1..=self.times).map(|number| {
            let text = self.text.replace("{number}", &number.to_string());
            text.replace("{before}", &(number - 1).to_string())
        });
        written.collect()
    }
}

impl<'de> Visitor<'de> for ScalarVisitor {
    type Value = Scalar;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(
            "a string, a number, true, false, `{ text = \"…\", times = … }`, or an array of such texts",
        )
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Scalar, E> {
        Ok(Scalar::Text(text.to_owned()))
    }

    fn visit_bool<E: de::Error>(self, truth: bool) -> Result<Scalar, E> {
        Ok(Scalar::Truth(truth))
    }

    fn visit_i64<E: de::Error>(self, _: i64) -> Result<Scalar, E> {
        Ok(Scalar::Number)
    }

    fn visit_u64<E: de::Error>(self, _: u64) -> Result<Scalar, E> {
        Ok(Scalar::Number)
    }

    fn visit_i128<E: de::Error>(self, _: i128) -> Result<Scalar, E> {
        Ok(Scalar::Number)
    }

    fn visit_u128<E: de::Error>(self, _: u128) -> Result<Scalar, E> {
        Ok(Scalar::Number)
    }

    fn visit_f64<E: de::Error>(self, _: f64) -> Result<Scalar, E> {
        Ok(Scalar::Number)
    }

    /// Joins texts and repetitions.
    fn visit_seq<A: SeqAccess<'de>>(self, mut parts: A) -> Result<Scalar, A::Error> {
        let mut joined = String::new();
        while let Some(part) = parts.next_element::<Scalar>()? {
            match part {
                Scalar::Text(text) => joined.push_str(&text),
                _ => return Err(de::Error::custom("the parts of a cell are texts")),
            }
        }
        Ok(Scalar::Text(joined))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Scalar, A::Error> {
        let repetition = Repetition::deserialize(MapAccessDeserializer::new(map))?;
        match repetition.times {
            1..=Repetition::MAX_TIMES => Ok(Scalar::Text(repetition.written_out())),
            times => Err(de::Error::custom(format!(
                "a text is repeated at most 100000 times, not {times}"
            ))),
        }
    }
}
