//! Reads the tables `[dialects.NAME]` of `stickler.toml`.

use super::draft::{Draft, Written};
use super::override_tables::overrides;
use super::table::{ConfigurationMistake, Read, table, text};
use crate::near::{advice, list};
use crate::{Dialect, DialectName, ElementaryType};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of a table `[dialects.NAME]`.
const KEYS: [&str; 8] = [
    "extends",
    "about",
    "source",
    "implicit",
    "flags",
    "language",
    "conversions",
    "operators",
];

/// The greatest length of a dialect's name.
const MAX_NAME_LEN: usize = 64;

/// A table of the file, with its name.
struct DialectTable<'v, 'i> {
    name: &'v str,
    span: Range<usize>,
    keys: &'v DeTable<'i>,
}

/// Returns the definitions of a table `[dialects]`, in the order of the file. `converts` says whether a conversion function for a
/// pair of types exists.
///
/// # Errors
/// The first mistake.
pub fn definitions(
    dialects: &DeTable<'_>,
    written: Written<'_>,
    converts: fn(ElementaryType, ElementaryType) -> bool,
) -> Read<Vec<(Dialect, Range<usize>)>> {
    let mut entries = Vec::new();
    for (key, value) in dialects.iter() {
        let (name, span) = (key.get_ref().as_ref(), key.span());
        check_name(name, &span)?;
        let keys = table(&format!("dialects.{name}"), value)?;
        entries.push(DialectTable { name, span, keys });
    }
    entries.sort_by_key(|entry| entry.span.start);
    let by_name: BTreeMap<&str, usize> = (0..)
        .map(|at| (entries[at].name, at))
        .take(entries.len())
        .collect();
    let mut read: Vec<Option<Dialect>> = vec![None; entries.len()];
    for at in 0..entries.len() {
        // Those that extend one another, each before the one that it extends.
        let mut open = vec![at];
        while let Some(&next) = open.last() {
            if read[next].is_some() {
                open.pop();
                continue;
            }
            let entry = &entries[next];
            let place = written(&entry.span);
            let start = match base(entry, &by_name)? {
                Base::Documented(base) => Dialect::custom(entry.name, base, &place),
                Base::Defined(other, span) => match &read[other] {
                    Some(other) => other.extended(entry.name, &place),
                    None if open.contains(&other) => return Err(in_a_circle(entry, &span)),
                    None => {
                        open.push(other);
                        continue;
                    }
                },
            };
            read[next] = Some(definition(entry, start, (written, converts))?);
        }
    }
    let spans = entries.into_iter().map(|entry| entry.span);
    Ok(read.into_iter().flatten().zip(spans).collect())
}

/// Checks that a name means nothing else on the command line, in a filter or in the key of a case.
fn check_name(name: &str, span: &Range<usize>) -> Read<()> {
    let plain = |character: char| character.is_ascii_alphanumeric() || "-_.".contains(character);
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.chars().all(plain)
        && name.len() <= MAX_NAME_LEN;
    if !is_name {
        let message = format!(
            "`{}` cannot be the name of a dialect; it has letters, digits, `-`, `_` and `.`, a letter at its start, and no \
             more than {MAX_NAME_LEN} of them",
            name.escape_debug()
        );
        return Err(ConfigurationMistake::at(span.clone(), message));
    }
    let taken = DialectName::ALL
        .into_iter()
        .find(|dialect| dialect.as_str().eq_ignore_ascii_case(name));
    match taken {
        Some(dialect) => {
            let message = format!("there is a dialect `{dialect}` already; give this one another name");
            Err(ConfigurationMistake::at(span.clone(), message))
        }
        None => Ok(()),
    }
}

/// The dialect that another one extends.
enum Base {
    Documented(DialectName),
    /// A dialect of the file, by its index, and the position of the key `extends`.
    Defined(usize, Range<usize>),
}

fn base(entry: &DialectTable<'_, '_>, by_name: &BTreeMap<&str, usize>) -> Read<Base> {
    let Some(extends) = entry.keys.get("extends") else {
        let message = format!(
            "`[dialects.{}]` does not say which dialect it extends, by `extends = \"…\"`; there are {}",
            entry.name,
            list(DialectName::ALL.map(DialectName::as_str))
        );
        return Err(ConfigurationMistake::at(entry.span.clone(), message));
    };
    let name = text("extends", extends)?;
    if let Some(built_in) = DialectName::ALL
        .into_iter()
        .find(|dialect| dialect.as_str() == name)
    {
        return Ok(Base::Documented(built_in));
    }
    if name == entry.name {
        let message = format!("`{name}` cannot extend itself");
        return Err(ConfigurationMistake::at(extends.span(), message));
    }
    match by_name.get(name) {
        Some(&at) => Ok(Base::Defined(at, extends.span())),
        None => {
            let built_in = DialectName::ALL.map(DialectName::as_str);
            let names: Vec<&str> = built_in.into_iter().chain(by_name.keys().copied()).collect();
            let message = format!("there is no dialect `{name}` to extend; {}", advice(name, &names));
            Err(ConfigurationMistake::at(extends.span(), message))
        }
    }
}

fn in_a_circle(entry: &DialectTable<'_, '_>, at: &Range<usize>) -> ConfigurationMistake {
    let message = format!(
        "`{}` extends itself by way of others; one of them must extend {}",
        entry.name,
        list(DialectName::ALL.map(DialectName::as_str))
    );
    ConfigurationMistake::at(at.clone(), message)
}

/// Reads one table, whose overrides are added to the definition `start`.
fn definition(
    entry: &DialectTable<'_, '_>,
    start: Dialect,
    (written, converts): (Written<'_>, fn(ElementaryType, ElementaryType) -> bool),
) -> Read<Dialect> {
    let words = |key: &str| entry.keys.get(key).map(|value| words(key, value)).transpose();
    let mut draft = Draft {
        dialect: start,
        source: words("source")?,
        written: Some(written),
        converts,
    };
    draft.dialect.about = words("about")?;
    let whose = format!("dialects.{}.", entry.name);
    overrides(entry.keys, &whose, &mut draft)?;
    let mut keys = entry.keys.iter().map(|(key, _)| key);
    if let Some(key) = keys.find(|key| !KEYS.contains(&key.get_ref().as_ref())) {
        let whose = format!("of `[dialects.{}]`", entry.name);
        return Err(ConfigurationMistake::unknown_key(
            key.span(),
            key.get_ref(),
            &whose,
            &KEYS,
        ));
    }
    Ok(draft.dialect)
}

/// Reads a text for people, which terminals and reports show.
pub(crate) fn words(key: &str, value: &Spanned<DeValue<'_>>) -> Read<String> {
    let words = text(key, value)?;
    match words.chars().any(char::is_control) {
        true => Err(ConfigurationMistake::at(
            value.span(),
            format!("`{key}` must be one line, without control characters"),
        )),
        false => Ok(words.to_owned()),
    }
}
