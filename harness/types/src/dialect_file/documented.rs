//! Reads the file of a documented system.

use super::definitions::words;
use super::draft::Draft;
use super::override_tables::{choices, elementary, overrides};
use super::table::{ConfigurationMistake, Read, mistake, table, text};
use crate::choice::Choice;
use crate::documents::PageOnReals;
use crate::near::advice;
use crate::{
    DeclaredFeatures, Dialect, DialectKind, DialectName, ElementaryType, OutOfRange, Rounding, Value,
};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of the file.
const KEYS: [&str; 17] = [
    "title",
    "about",
    "order",
    "extends",
    "asked-beside",
    "features",
    "documents",
    "page-on-reals",
    "variants",
    "flags",
    "language",
    "conversions",
    "operators",
    "implicit",
    "names",
    "inputs",
    "ranges",
];

/// The content of the file of a documented system.
#[derive(Clone, Debug)]
pub struct DialectFile {
    /// The system.
    pub dialect: Dialect,
    /// The variants of the system by compiler options.
    pub variants: Vec<Dialect>,
}

/// Returns the dialects of embedded files, in their order, and after them their variants by name.
///
/// # Panics
/// Panics on a mistake in a file, which the first use of any dialect shows.
pub(crate) fn documented(files: &[(&str, &str)]) -> Vec<Dialect> {
    let mut read: Vec<Dialect> = Vec::with_capacity(files.len());
    let mut variants = Vec::new();
    for ((name, text), own) in files.iter().zip(DialectName::ALL) {
        let extended = |other: &str| read.iter().find(|one| one.spelling == other).cloned();
        let place = format!("conformance-cases/dialects/{name}.toml");
        match read_documented((name, own), text, &place, &extended) {
            Ok(file) => {
                read.push(file.dialect);
                variants.extend(file.variants);
            }
            Err(mistake) => panic!("{place}:{}: {}", line(text, mistake.span.start), mistake.message),
        }
    }
    variants.sort_by(|one, other| one.spelling.cmp(&other.spelling));
    read.extend(variants);
    read
}

/// Reads the file of a documented system, of this name. `extended` returns another system by its name; `place` is the path of the
/// file for messages.
///
/// # Errors
/// The first mistake in the file.
pub fn read_documented(
    (name, own): (&str, DialectName),
    text: &str,
    place: &str,
    extended: &dyn Fn(&str) -> Option<Dialect>,
) -> Read<DialectFile> {
    let document = DeTable::parse(text).map_err(|error| mistake(&error, 0..0, "of the file", &[]))?;
    let keys = document.get_ref();
    let mut draft = draft(Dialect {
        spelling: name.to_owned(),
        base: own,
        place: place.to_owned(),
        ..start(keys, extended)?
    });
    for (key, value) in keys.iter() {
        let (key, at) = (key.get_ref().as_ref(), key.span());
        let dialect = &mut draft.dialect;
        match key {
            "title" => dialect.title = words(key, value)?,
            "about" => dialect.about = Some(text_of(key, value)?),
            "asked-beside" => dialect.asked_beside = Some(text_of(key, value)?),
            "features" => features(&mut dialect.features, table(key, value)?)?,
            "documents" => choices(table(key, value)?, key, "[documents]", &mut draft)?,
            "names" => names(&mut dialect.names, table(key, value)?)?,
            "inputs" => inputs(&mut draft, table(key, value)?)?,
            "ranges" => ranges(&mut draft, table(key, value)?)?,
            "page-on-reals" => {
                dialect.documents.page_on_reals = Some(page_on_reals(table(key, value)?, &at)?)
            }
            _ if KEYS.contains(&key) => {}
            _ => {
                return Err(ConfigurationMistake::unknown_key(
                    at,
                    key,
                    "of the file of a dialect",
                    &KEYS,
                ));
            }
        }
    }
    if draft.dialect.title.is_empty() {
        let message = "the file has no `title`, a name of the system for people";
        return Err(ConfigurationMistake::at(0..0, message));
    }
    overrides(keys, "", &mut draft)?;
    let dialect = draft.dialect;
    let variants = match keys.get("variants") {
        Some(value) => variants(table("variants", value)?, &dialect, (text, place))?,
        None => Vec::new(),
    };
    Ok(DialectFile { dialect, variants })
}

fn draft(dialect: Dialect) -> Draft<'static> {
    Draft {
        dialect,
        source: None,
        written: None,
        converts: |_, _| true,
    }
}

/// Returns what the file begins with: the system that it extends, or the defaults.
fn start(keys: &DeTable<'_>, extended: &dyn Fn(&str) -> Option<Dialect>) -> Read<Dialect> {
    let Some(extends) = keys.get("extends") else {
        return Ok(Dialect::DEFAULT);
    };
    let name = text("extends", extends)?;
    let Some(mut other) = extended(name) else {
        let known = DialectName::ALL.map(DialectName::as_str);
        let advice = advice(name, &known);
        let message = format!("there is no dialect `{name}` before this one to extend; {advice}");
        return Err(ConfigurationMistake::at(extends.span(), message));
    };
    // They speak of the other system alone.
    (other.title, other.about) = (String::new(), None);
    other.documents.page_on_reals = None;
    other.asked_beside = None;
    Ok(other)
}

/// Reads what the system says of the features of the language. Whether there is a feature of a name, the suite says, which has their list.
fn features(declared: &mut DeclaredFeatures, keys: &DeTable<'_>) -> Read<()> {
    for (key, value) in keys.iter() {
        match key.get_ref().as_ref() {
            "edition" => declared.edition = Some(edition(value)?),
            "has" => declared.has = texts("has", value)?,
            "lacks" => {
                declared.lacks = texts("lacks", value)?;
                let types = declared.lacks.iter();
                declared.lacked_types = types.filter_map(|key| ElementaryType::from_name(key)).collect();
            }
            other => {
                let known = ["edition", "has", "lacks"];
                return Err(ConfigurationMistake::unknown_key(
                    key.span(),
                    other,
                    "of `[features]`",
                    &known,
                ));
            }
        }
    }
    Ok(())
}

/// Reads the names that the system has for types and functions of the standard: `MULTIME = "MUL"`.
fn names(names: &mut BTreeMap<String, String>, keys: &DeTable<'_>) -> Read<()> {
    for (key, value) in keys.iter() {
        let name = key.get_ref().to_ascii_uppercase();
        names.insert(name, text_of(key.get_ref(), value)?.to_ascii_uppercase());
    }
    Ok(())
}

/// Reads the types that TO_TIME and its kin take, by the type that they give: `TIME = ["LTIME", "DINT"]`.
fn inputs(draft: &mut Draft<'_>, keys: &DeTable<'_>) -> Read<()> {
    for (key, value) in keys.iter() {
        let to = elementary(key.get_ref(), &key.span(), draft)?;
        let names = texts(key.get_ref(), value)?.into_iter();
        let types = names.map(|name| elementary(&name, &value.span(), draft));
        // A few lists for each file, which is read once.
        let types: &'static [ElementaryType] = Vec::leak(types.collect::<Result<_, _>>()?);
        draft.dialect.inputs.insert(to, types);
    }
    Ok(())
}

/// Reads the least and the greatest value of durations and dates, and of which length all are a multiple:
/// `TIME = ["T#0ms", "T#4294967295ms", "T#1ms"]`.
fn ranges(draft: &mut Draft<'_>, keys: &DeTable<'_>) -> Read<()> {
    for (key, value) in keys.iter() {
        let ty = elementary(key.get_ref(), &key.span(), draft)?;
        let literals = texts(key.get_ref(), value)?;
        let of_type = |literal: &String| match Value::parse(literal) {
            Ok(Value::Plain { ty: of, raw }) if of == ty && ty.is_moment() => Some(raw.cast_signed()),
            _ => None,
        };
        let range: Option<Vec<i64>> = literals.iter().map(of_type).collect();
        let range = range.filter(|range| matches!(range.len(), 2 | 3) && range.get(2) != Some(&0));
        let wrong = format!("`{ty}` must be a list of the least and the greatest {ty}, and a length");
        let range = range.ok_or_else(|| ConfigurationMistake::at(value.span(), wrong))?;
        draft.dialect.ranges.insert(ty, range);
    }
    Ok(())
}

fn edition(value: &Spanned<DeValue<'_>>) -> Read<u8> {
    let number = value
        .get_ref()
        .as_integer()
        .and_then(|number| number.as_str().parse().ok());
    let is_edition = |number: &u8| DeclaredFeatures::EDITIONS.contains(number);
    number.filter(is_edition).ok_or_else(|| {
        ConfigurationMistake::at(value.span(), "`edition` is 2, 3 or 4, an edition of IEC 61131-3")
    })
}

fn page_on_reals(keys: &DeTable<'_>, at: &Range<usize>) -> Read<PageOnReals> {
    let get = |name: &str| {
        let missing = || ConfigurationMistake::at(at.clone(), format!("`[page-on-reals]` has no `{name}`"));
        keys.get(name).ok_or_else(missing)
    };
    let mut page = PageOnReals {
        basis: text_of("basis", get("basis")?)?,
        rounding: Rounding::Truncate,
        out_of_range: OutOfRange::Wrap,
    };
    stated(&mut page.rounding, "rounding", get("rounding")?)?;
    stated(&mut page.out_of_range, "out-of-range", get("out-of-range")?)?;
    Ok(page)
}

/// Reads the variants of a system.
fn variants(keys: &DeTable<'_>, base: &Dialect, (text, place): (&str, &str)) -> Read<Vec<Dialect>> {
    let mut found = Vec::new();
    for (key, value) in keys.iter() {
        let name = key.get_ref().as_ref();
        let place = format!("{place}:{}", line(text, key.span().start));
        let written = |_: &Range<usize>| place.clone();
        let table = table(&format!("variants.{name}"), value)?;
        let mut draft = Draft {
            written: Some(&written),
            ..draft(Dialect {
                kind: DialectKind::Variant,
                ..base.extended(name, &place)
            })
        };
        let about = table.get("about").map(|about| words("about", about));
        draft.dialect.about = about.transpose()?;
        overrides(table, &format!("variants.{name}."), &mut draft)?;
        found.push(draft.dialect);
    }
    Ok(found)
}

/// Returns the line of a position in a text, from 1.
fn line(text: &str, at: usize) -> usize {
    text.get(..at)
        .map_or(1, |before| before.matches('\n').count() + 1)
}

fn texts(key: &str, value: &Spanned<DeValue<'_>>) -> Read<Vec<String>> {
    let Some(items) = value.get_ref().as_array() else {
        return Err(ConfigurationMistake::at(
            value.span(),
            format!("`{key}` must be a list of texts"),
        ));
    };
    items.iter().map(|item| text_of(key, item)).collect()
}

fn text_of(key: &str, value: &Spanned<DeValue<'_>>) -> Read<String> {
    text(key, value).map(|text| text.trim().to_owned())
}

/// Makes the choice that a value names.
fn stated(choice: &mut dyn Choice, key: &str, value: &Spanned<DeValue<'_>>) -> Read<()> {
    let wrong = |message| ConfigurationMistake::at(value.span(), format!("`{key}` {message}"));
    choice.state(key, value.get_ref()).map_err(wrong)
}
