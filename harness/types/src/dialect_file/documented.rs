//! Reads the file of a documented system.

use super::definitions::words;
use super::draft::Draft;
use super::near::advice;
use super::override_tables::overrides;
use super::table::{ConfigurationMistake, mistake, table, text};
use crate::choices::Choice;
use crate::definition::DialectKind;
use crate::documents::{Documents, PageOnReals};
use crate::{Definition, DialectName};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of the file, besides the tables of overrides.
const KEYS: [&str; 12] = [
    "title",
    "about",
    "order",
    "extends",
    "known-in-part",
    "documents",
    "variants",
    "flags",
    "language",
    "conversions",
    "operators",
    "implicit",
];

/// The content of the file of a documented system.
#[derive(Clone, Debug)]
pub struct DialectFile {
    /// What the file states of the system.
    pub definition: Definition,
    /// The variants of the system by compiler options.
    pub variants: Vec<Definition>,
}

/// Returns the definitions of embedded files, in their order, and after them those of their variants by name.
///
/// # Panics
/// Panics on a mistake in a file, which the first use of any dialect shows.
pub(crate) fn documented(files: &[(&str, &str)]) -> Vec<Definition> {
    let mut read: Vec<Definition> = Vec::with_capacity(files.len());
    let mut variants = Vec::new();
    for ((name, text), own) in files.iter().zip(DialectName::ALL) {
        let extended = |other: &str| read.iter().find(|one| one.name == other).cloned();
        let place = format!("conformance-cases/dialects/{name}.toml");
        match read_documented((name, own), text, &place, &extended) {
            Ok(file) => {
                read.push(file.definition);
                variants.extend(file.variants);
            }
            Err(mistake) => {
                let line = text
                    .get(..mistake.span.start)
                    .map_or(1, |before| before.matches('\n').count() + 1);
                panic!("{place}:{line}: {}", mistake.message);
            }
        }
    }
    variants.sort_by(|one, other| one.name.cmp(&other.name));
    read.extend(variants);
    read
}

/// Reads the file of a documented system, of this name. `extended` returns what the file of another system states, by its name;
/// `place` is the path of the file for messages.
///
/// # Errors
/// The first mistake in the file.
pub fn read_documented(
    (name, own): (&str, DialectName),
    text: &str,
    place: &str,
    extended: &dyn Fn(&str) -> Option<Definition>,
) -> Result<DialectFile, ConfigurationMistake> {
    let document = DeTable::parse(text).map_err(|error| mistake(&error, 0..0, "of the file", &[]))?;
    let keys = document.get_ref();
    let mut names = keys.iter().map(|(key, _)| key);
    if let Some(key) = names.find(|key| !KEYS.contains(&key.get_ref().as_ref())) {
        let whose = "of the file of a dialect";
        return Err(ConfigurationMistake::unknown_key(
            key.span(),
            key.get_ref(),
            whose,
            &KEYS,
        ));
    }
    let mut draft = draft(start((name, own), keys, place, extended)?);
    draft.definition.title = match keys.get("title") {
        Some(title) => words("title", title)?,
        None => {
            return Err(ConfigurationMistake::at(
                0..0,
                "the file has no `title`, a name of the system for people",
            ));
        }
    };
    draft.definition.about = keys
        .get("about")
        .map(|about| text_of("about", about))
        .transpose()?;
    if let Some(partly) = keys.get("known-in-part") {
        draft.definition.is_known_in_part = truth("known-in-part", partly)?;
    }
    if let Some(value) = keys.get("documents") {
        documents(table("documents", value)?, &mut draft.definition.documents)?;
    }
    overrides(keys, "", &mut draft)?;
    let definition = draft.definition;
    let variants = match keys.get("variants") {
        Some(value) => variants(table("variants", value)?, &definition, (text, place))?,
        None => Vec::new(),
    };
    Ok(DialectFile { definition, variants })
}

fn draft(definition: Definition) -> Draft<'static> {
    Draft {
        definition,
        source: None,
        written: None,
        converts: |_, _| true,
    }
}

/// Returns what the file begins with: the statements of the system that it extends, or none.
fn start(
    (name, own): (&str, DialectName),
    keys: &DeTable<'_>,
    place: &str,
    extended: &dyn Fn(&str) -> Option<Definition>,
) -> Result<Definition, ConfigurationMistake> {
    let Some(extends) = keys.get("extends") else {
        return Ok(Definition::documented(name, own, place));
    };
    let other = text("extends", extends)?;
    let Some(other) = extended(other) else {
        let known = DialectName::ALL.map(DialectName::as_str);
        let message = format!(
            "there is no dialect `{other}` before this one to extend; {}",
            advice(other, &known)
        );
        return Err(ConfigurationMistake::at(extends.span(), message));
    };
    let taken_over = Definition::extending(&other, name, place);
    Ok(Definition {
        base: own,
        kind: DialectKind::Documented,
        documents: Documents {
            page_on_reals: None,
            ..other.documents
        },
        ..taken_over
    })
}

/// Reads the table `documents`.
fn documents(keys: &DeTable<'_>, documents: &mut Documents) -> Result<(), ConfigurationMistake> {
    const KNOWN: [&str; 8] = [
        "implicit",
        "functions",
        "bits",
        "partial-access",
        "untyped-literals",
        "inputs-left-out",
        "wide-strings",
        "page-on-reals",
    ];
    for (key, value) in keys.iter() {
        let name = key.get_ref().as_ref();
        match name {
            "implicit" => documents.implicit = choice(name, value)?,
            "functions" => documents.functions = choice(name, value)?,
            "bits" => documents.bits = truth(name, value)?,
            "partial-access" => documents.partial_access = truth(name, value)?,
            "untyped-literals" => documents.untyped_literals = truth(name, value)?,
            "inputs-left-out" => documents.inputs_left_out = truth(name, value)?,
            "wide-strings" => documents.wide_strings = truth(name, value)?,
            "page-on-reals" => {
                documents.page_on_reals = Some(page_on_reals(table(name, value)?, &key.span())?)
            }
            _ => {
                return Err(ConfigurationMistake::unknown_key(
                    key.span(),
                    name,
                    "of `[documents]`",
                    &KNOWN,
                ));
            }
        }
    }
    Ok(())
}

fn page_on_reals(keys: &DeTable<'_>, at: &Range<usize>) -> Result<PageOnReals, ConfigurationMistake> {
    let get = |name: &str| {
        let missing =
            || ConfigurationMistake::at(at.clone(), format!("`[documents.page-on-reals]` has no `{name}`"));
        keys.get(name).ok_or_else(missing)
    };
    Ok(PageOnReals {
        basis: text_of("basis", get("basis")?)?,
        rounding: choice("rounding", get("rounding")?)?,
        out_of_range: choice("out-of-range", get("out-of-range")?)?,
    })
}

/// Reads the variants of a system.
fn variants(
    keys: &DeTable<'_>,
    base: &Definition,
    (text, place): (&str, &str),
) -> Result<Vec<Definition>, ConfigurationMistake> {
    let mut found = Vec::new();
    for (key, value) in keys.iter() {
        let name = key.get_ref().as_ref();
        let lines = text
            .get(..key.span().start)
            .map_or(1, |before| before.matches('\n').count() + 1);
        let place = format!("{place}:{lines}");
        let written = |_: &Range<usize>| place.clone();
        let table = table(&format!("variants.{name}"), value)?;
        let mut draft = Draft {
            written: Some(&written),
            ..draft(Definition {
                kind: DialectKind::Variant,
                ..Definition::extending(base, name, &place)
            })
        };
        draft.definition.about = table
            .get("about")
            .map(|about| words("about", about))
            .transpose()?;
        overrides(table, &format!("variants.{name}."), &mut draft)?;
        found.push(draft.definition);
    }
    Ok(found)
}

fn text_of(key: &str, value: &Spanned<DeValue<'_>>) -> Result<String, ConfigurationMistake> {
    text(key, value).map(|text| text.trim().to_owned())
}

fn truth(key: &str, value: &Spanned<DeValue<'_>>) -> Result<bool, ConfigurationMistake> {
    let wrong = || ConfigurationMistake::at(value.span(), format!("`{key}` must be true or false"));
    value.get_ref().as_bool().ok_or_else(wrong)
}

fn choice<T: Choice>(key: &str, value: &Spanned<DeValue<'_>>) -> Result<T, ConfigurationMistake> {
    let word = text(key, value)?;
    T::read(word).ok_or_else(|| {
        let message = format!("`{key}` is not `{word}`; {}", advice(word, &T::known()));
        ConfigurationMistake::at(value.span(), message)
    })
}
