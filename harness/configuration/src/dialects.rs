//! Reads the tables `[dialects.NAME]`.

use crate::draft::Draft;
use crate::near::{advice, list};
use crate::override_tables::{conversions, flags, implicit, operators};
use crate::table::{ConfigurationMistake, table, text};
use std::collections::BTreeMap;
use std::ops::Range;
use stickler_types::definition::OperatorOverrides;
use stickler_types::{BuiltIn, Definition, DialectName, Stated};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of a table `[dialects.NAME]`.
const KEYS: [&str; 7] = [
    "extends",
    "about",
    "source",
    "implicit",
    "flags",
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

/// Returns the definitions of a table `[dialects]`, in the order of the file.
///
/// # Errors
/// The first mistake.
pub(crate) fn definitions(
    dialects: &DeTable<'_>,
    written: &dyn Fn(&Range<usize>) -> String,
) -> Result<Vec<(Definition, Range<usize>)>, ConfigurationMistake> {
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
    let mut read: Vec<Option<Definition>> = vec![None; entries.len()];
    for at in 0..entries.len() {
        // Those that extend one another, each before the one that it extends.
        let mut open = vec![at];
        while let Some(&next) = open.last() {
            match base(&entries[next], &by_name)? {
                _ if read[next].is_some() => {
                    open.pop();
                }
                Base::Defined(other, span) if read[other].is_none() => {
                    if open.contains(&other) {
                        return Err(in_a_circle(&entries[next], &span));
                    }
                    open.push(other);
                }
                Base::Defined(other, _) => {
                    let entry = &entries[next];
                    let start = read[other]
                        .as_ref()
                        .map(|other| taken_over(other, entry, written));
                    read[next] = start.map(|start| definition(entry, start, written)).transpose()?;
                }
                Base::BuiltIn(base) => {
                    let entry = &entries[next];
                    let start = Definition::new(entry.name, base, &written(&entry.span));
                    read[next] = Some(definition(entry, start, written)?);
                }
            }
        }
    }
    let spans = entries.into_iter().map(|entry| entry.span);
    Ok(read.into_iter().flatten().zip(spans).collect())
}

/// Checks that a name means nothing else on the command line, in a filter or in the key of a case.
fn check_name(name: &str, span: &Range<usize>) -> Result<(), ConfigurationMistake> {
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
    BuiltIn(BuiltIn),
    /// A dialect of the file, by its index, and the position of the key `extends`.
    Defined(usize, Range<usize>),
}

fn base(entry: &DialectTable<'_, '_>, by_name: &BTreeMap<&str, usize>) -> Result<Base, ConfigurationMistake> {
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
        return Ok(Base::BuiltIn(built_in.base()));
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
    start: Definition,
    written: &dyn Fn(&Range<usize>) -> String,
) -> Result<Definition, ConfigurationMistake> {
    let words = |key: &str| entry.keys.get(key).map(|value| words(key, value)).transpose();
    let mut draft = Draft {
        definition: start,
        source: words("source")?,
        written,
    };
    draft.definition.about = words("about")?;
    for (key, value) in entry.keys.iter() {
        let whose = format!("dialects.{}.{}", entry.name, key.get_ref());
        match key.get_ref().as_ref() {
            "extends" | "about" | "source" => {}
            "flags" => flags(table(&whose, value)?, &mut draft)?,
            "conversions" => conversions(table(&whose, value)?, &mut draft)?,
            "operators" => operators(table(&whose, value)?, &mut draft)?,
            // Which types there are depends on the flags.
            "implicit" => {}
            word => {
                let whose = format!("of `[dialects.{}]`", entry.name);
                return Err(ConfigurationMistake::unknown_key(key.span(), word, &whose, &KEYS));
            }
        }
    }
    if let Some(value) = entry.keys.get("implicit") {
        implicit(
            table(&format!("dialects.{}.implicit", entry.name), value)?,
            &mut draft,
        )?;
    }
    Ok(draft.definition)
}

/// Returns the definition of the extended dialect under the name of the extending one.
fn taken_over(
    other: &Definition,
    entry: &DialectTable<'_, '_>,
    written: &dyn Fn(&Range<usize>) -> String,
) -> Definition {
    fn said<T: Copy>(stated: &Stated<T>, name: &str) -> Stated<T> {
        let rest = stated.basis.split_once(':').map_or("", |(_, rest)| rest);
        Stated {
            value: stated.value,
            basis: format!("{name}:{rest}"),
        }
    }
    fn choice<T: Copy>(stated: &Option<Stated<T>>, name: &str) -> Option<Stated<T>> {
        stated.as_ref().map(|stated| said(stated, name))
    }
    let name = entry.name;
    let operators = &other.operators;
    let implicit = other.implicit.iter();
    let flags = other.flags.iter();
    Definition {
        name: name.to_owned(),
        base: other.base,
        about: None,
        is_variant: false,
        place: written(&entry.span),
        implicit: implicit
            .map(|(pair, stated)| (*pair, said(stated, name)))
            .collect(),
        flags: flags.map(|(flag, stated)| (*flag, said(stated, name))).collect(),
        rounding: choice(&other.rounding, name),
        out_of_range: choice(&other.out_of_range, name),
        truncation_out_of_range: choice(&other.truncation_out_of_range, name),
        text_reading: choice(&other.text_reading, name),
        real_text: choice(&other.real_text, name),
        bit_string_text: choice(&other.bit_string_text, name),
        moment_text: choice(&other.moment_text, name),
        bits_as_real: choice(&other.bits_as_real, name),
        bit_string_as_bool: choice(&other.bit_string_as_bool, name),
        moment_units: choice(&other.moment_units, name),
        operators: OperatorOverrides {
            implicit_warnings: choice(&operators.implicit_warnings, name),
            operands: choice(&operators.operands, name),
            compared: choice(&operators.compared, name),
            result_signs: choice(&operators.result_signs, name),
            constant_types: choice(&operators.constant_types, name),
            shift_counts: choice(&operators.shift_counts, name),
        },
    }
}

/// Reads a text for people, which terminals and reports show.
fn words(key: &str, value: &Spanned<DeValue<'_>>) -> Result<String, ConfigurationMistake> {
    let words = text(key, value)?;
    match words.chars().any(char::is_control) {
        true => Err(ConfigurationMistake::at(
            value.span(),
            format!("`{key}` must be one line, without control characters"),
        )),
        false => Ok(words.to_owned()),
    }
}
