//! Reads the overrides of a dialect: the tables `implicit`, `flags`, `language`, `conversions` and `operators`.

use super::draft::Draft;
use super::near::{advice, list};
use super::table::{ConfigurationMistake, table, text};
use crate::definition::{ConversionOverrides, Flag, LanguageOverrides, OperatorOverrides};
use crate::dialect::ThirdEditionTypes;
use crate::{DialectKind, ElementaryType, MatrixWord};
use std::collections::BTreeSet;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The words that an override may state for a pair of different types.
const WORDS: [MatrixWord; 4] = [
    MatrixWord::Yes,
    MatrixWord::Warn,
    MatrixWord::No,
    MatrixWord::Open,
];

/// Reads the tables of overrides among the keys of a dialect; `whose` stands before the name of a table in messages.
///
/// # Errors
/// The first mistake in one of them; other keys are not looked at.
pub(crate) fn overrides(
    keys: &DeTable<'_>,
    whose: &str,
    draft: &mut Draft<'_>,
) -> Result<(), ConfigurationMistake> {
    let find = |name: &str| {
        keys.get(name)
            .map(|value| table(&format!("{whose}{name}"), value))
            .transpose()
    };
    // Which types there are depends on the tables before it.
    let tables: [(&str, Reader); 5] = [
        ("flags", flags),
        ("language", language),
        ("conversions", conversions),
        ("operators", operators),
        ("implicit", implicit),
    ];
    for (name, read) in tables {
        if let Some(keys) = find(name)? {
            read(keys, draft)?;
        }
    }
    Ok(())
}

/// A function that reads a table of overrides.
type Reader = fn(&DeTable<'_>, &mut Draft<'_>) -> Result<(), ConfigurationMistake>;

/// Reads `[dialects.NAME.flags]`.
///
/// # Errors
/// An unknown flag, or a value that is neither true nor false.
fn flags(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    for (key, value) in keys.iter() {
        let word = key.get_ref().as_ref();
        let Some(flag) = Flag::from_word(word) else {
            let known: Vec<&str> = Flag::ALL.iter().map(|flag| flag.as_str()).collect();
            return Err(ConfigurationMistake::unknown_key(
                key.span(),
                word,
                &of("flags", draft),
                &known,
            ));
        };
        let Some(on) = value.get_ref().as_bool() else {
            let found = value.get_ref().type_str();
            let message = format!("`{word}` must be true or false, and this is of type {found}");
            return Err(ConfigurationMistake::at(value.span(), message));
        };
        let stated = draft.stated(on, word, &key.span());
        draft.definition.flags.insert(flag, stated);
        match flag {
            // The documents of a system have tables of their own about these pairs.
            Flag::CrossFamilyWidening if draft.definition.kind == DialectKind::Custom => {
                cross_family(on, &key.span(), draft);
            }
            Flag::ThirdEditionTypes if !on => without_third_edition(draft),
            _ => {}
        }
    }
    Ok(())
}

/// Removes the inherited statements about types that the dialect does not have.
fn without_third_edition(draft: &mut Draft<'_>) {
    let has = |ty: ElementaryType| !ty.is_third_edition();
    draft
        .definition
        .implicit
        .retain(|(from, to), _| has(*from) && has(*to));
}

/// Applies the flag for cross-family widening to the cells of the matrix that it decides. Basis: ironplc-type-conversions:
/// Cross-family widening ("an integer type of strictly greater bit width").
fn cross_family(on: bool, at: &Range<usize>, draft: &mut Draft<'_>) {
    let cell = if on { MatrixWord::Yes } else { MatrixWord::No };
    for from in ElementaryType::ALL.into_iter().filter(|ty| ty.is_bit_string()) {
        for to in ElementaryType::ALL.into_iter().filter(|ty| ty.is_integer()) {
            if from.bits() < to.bits() {
                let stated = draft.stated(cell, Flag::CrossFamilyWidening.as_str(), at);
                draft.definition.implicit.insert((from, to), stated);
            }
        }
    }
}

/// Reads a table of choices; `set` makes the choice of a key and lists the words of the key where there is none.
fn choices(
    keys: &DeTable<'_>,
    (name, known): (&str, &[&str]),
    draft: &mut Draft<'_>,
    set: impl Fn(&mut Draft<'_>, &str, &str, Option<String>) -> Option<Result<(), Vec<&'static str>>>,
) -> Result<(), ConfigurationMistake> {
    for (key, value) in keys.iter() {
        let (at, key) = (key.span(), key.get_ref().as_ref());
        let number = value.get_ref().as_integer().filter(|_| key == "real-text");
        let word = match number {
            Some(number) => number.as_str(),
            None if known.contains(&key) => text(key, value)?,
            None => "",
        };
        let basis = draft.basis(key, &at);
        match set(draft, key, word, basis) {
            Some(Ok(())) => {}
            Some(Err(words)) if key == "real-text" => {
                let words: String = words.iter().map(|word| format!("\"{word}\", ")).collect();
                let message = format!("`{key}` is {words}or a number of significant digits from 1 to 40");
                return Err(ConfigurationMistake::at(value.span(), message));
            }
            Some(Err(words)) => {
                let message = format!("`{key}` is not `{word}`; {}", advice(word, &words));
                return Err(ConfigurationMistake::at(value.span(), message));
            }
            None => {
                return Err(ConfigurationMistake::unknown_key(
                    at,
                    key,
                    &of(name, draft),
                    known,
                ));
            }
        }
    }
    Ok(())
}

fn language(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    choices(
        keys,
        ("language", LanguageOverrides::KEYS),
        draft,
        |draft, key, word, basis| draft.definition.language.set(key, word, basis),
    )
}

fn conversions(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    // What was stated of truncation alone goes with what was stated of all numbers outside.
    if keys.get("out-of-range").is_some() {
        draft.definition.conversions.truncation_out_of_range = None;
    }
    choices(
        keys,
        ("conversions", ConversionOverrides::KEYS),
        draft,
        |draft, key, word, basis| draft.definition.conversions.set(key, word, basis),
    )
}

fn operators(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    choices(
        keys,
        ("operators", OperatorOverrides::KEYS),
        draft,
        |draft, key, word, basis| draft.definition.operators.set(key, word, basis),
    )
}

/// Returns the option of `all` that a value names.
fn one_of<T: Copy>(
    key: &str,
    value: &Spanned<DeValue<'_>>,
    all: &[T],
    as_str: impl Fn(T) -> &'static str,
) -> Result<T, ConfigurationMistake> {
    let word = text(key, value)?;
    all.iter()
        .copied()
        .find(|known| as_str(*known) == word)
        .ok_or_else(|| {
            let known: Vec<&str> = all.iter().map(|known| as_str(*known)).collect();
            let message = format!("`{key}` is not `{word}`; {}", advice(word, &known));
            ConfigurationMistake::at(value.span(), message)
        })
}

/// Reads `[dialects.NAME.implicit]`: `"FROM.TO" = "yes"`, with or without the quotes.
///
/// # Errors
/// An unknown type, a type that the dialect does not have, a pair that cannot be overridden or is stated twice, or an
/// unknown word.
fn implicit(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    let mut read = BTreeSet::new();
    for (key, value) in keys.iter() {
        let name = key.get_ref().as_ref();
        match (value.get_ref().as_table(), name.split_once('.')) {
            // Without quotes TOML reads a table of its own.
            (Some(columns), None) => {
                for (column, value) in columns.iter() {
                    let to = column.get_ref().as_ref();
                    let pair = cell((name, &key.span()), (to, &column.span()), value, draft)?;
                    once(&mut read, pair, &column.span())?;
                }
            }
            (None, Some((from, to))) => {
                let pair = cell((from, &key.span()), (to, &key.span()), value, draft)?;
                once(&mut read, pair, &key.span())?;
            }
            _ => {
                let message = format!(
                    "`{name}` names no pair of types; write the value's type, a point and the target's: `\"INT.BOOL\" = \"no\"`"
                );
                return Err(ConfigurationMistake::at(key.span(), message));
            }
        }
    }
    Ok(())
}

/// Checks that a pair is stated once; it can be written with and without quotes, which are different keys to TOML.
fn once(read: &mut BTreeSet<Pair>, pair: Pair, at: &Range<usize>) -> Result<(), ConfigurationMistake> {
    if read.insert(pair) {
        return Ok(());
    }
    let message = format!("`{}.{}` has a word already", pair.0, pair.1);
    Err(ConfigurationMistake::at(at.clone(), message))
}

/// The type of a value, and that of its target.
type Pair = (ElementaryType, ElementaryType);

fn cell(
    (from, from_at): (&str, &Range<usize>),
    (to, to_at): (&str, &Range<usize>),
    value: &Spanned<DeValue<'_>>,
    draft: &mut Draft<'_>,
) -> Result<Pair, ConfigurationMistake> {
    let key = format!("{from}.{to}");
    let (from, to) = (elementary(from, from_at, draft)?, elementary(to, to_at, draft)?);
    if from == to {
        let message = format!("`{key}` needs no word; a type always stands for itself");
        return Err(ConfigurationMistake::at(to_at.clone(), message));
    }
    let word = one_of(&key, value, &WORDS, MatrixWord::as_str)?;
    if word != MatrixWord::No && !(draft.converts)(from, to) {
        let message = format!(
            "`{key}` cannot be `{}`; there is no conversion from {from} to {to}",
            word.as_str()
        );
        return Err(ConfigurationMistake::at(value.span(), message));
    }
    let stated = draft.stated(word, &format!("implicit {from}.{to}"), from_at);
    draft.definition.implicit.insert((from, to), stated);
    Ok((from, to))
}

/// Returns the elementary type of a name, if the dialect has it.
fn elementary(
    name: &str,
    at: &Range<usize>,
    draft: &Draft<'_>,
) -> Result<ElementaryType, ConfigurationMistake> {
    let types = ElementaryType::ALL.map(ElementaryType::name);
    let found = ElementaryType::ALL.into_iter().find(|ty| ty.name() == name);
    let ty = found.ok_or_else(|| {
        let message = format!("there is no type `{name}`; {}", advice(name, &types));
        ConfigurationMistake::at(at.clone(), message)
    })?;
    if ty.is_third_edition() && !has_third_edition(draft) {
        let message = format!(
            "`{}` has no type {ty}, for {} has none; `third-edition-types = true` among its flags gives it {}",
            draft.definition.name,
            draft.definition.base,
            list(
                ElementaryType::ALL
                    .into_iter()
                    .filter(|ty| ty.is_third_edition())
                    .map(ElementaryType::name)
            )
        );
        return Err(ConfigurationMistake::at(at.clone(), message));
    }
    Ok(ty)
}

fn has_third_edition(draft: &Draft<'_>) -> bool {
    let language = &draft.definition.language;
    let has_some = || {
        let stated = language.third_edition_types.as_ref();
        stated.is_none_or(|stated| stated.value != ThirdEditionTypes::None)
    };
    draft
        .definition
        .flag(Flag::ThirdEditionTypes)
        .unwrap_or_else(has_some)
}

fn of(table: &str, draft: &Draft<'_>) -> String {
    format!("of `[dialects.{}.{table}]`", draft.definition.name)
}
