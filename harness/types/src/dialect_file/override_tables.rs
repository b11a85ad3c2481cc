//! Reads the overrides of a dialect: the tables `implicit`, `flags`, `language`, `conversions` and `operators`.

use super::draft::Draft;
use super::table::{ConfigurationMistake, Read, table};
use crate::choice::one_of;
use crate::dialect::{Pair, Stated, TABLES, ThirdEditionTypes};
use crate::near::{advice, list};
use crate::{Dialect, ElementaryType, MatrixWord};
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
pub(crate) fn overrides(keys: &DeTable<'_>, whose: &str, draft: &mut Draft<'_>) -> Read<()> {
    let find = |name: &str| {
        let found = keys
            .get(name)
            .map(|value| table(&format!("{whose}{name}"), value));
        found.transpose()
    };
    for name in TABLES {
        if let Some(keys) = find(name)? {
            let whose = format!("[dialects.{}.{name}]", draft.dialect.spelling);
            choices(keys, name, &whose, draft)?;
        }
    }
    // Which types there are depends on the tables before it.
    find("implicit")?.map_or(Ok(()), |keys| implicit(keys, draft))
}

/// Reads the keys of a table of choices; `whose` names the table in messages.
///
/// # Errors
/// An unknown key, or a value that the key cannot have.
pub(crate) fn choices(keys: &DeTable<'_>, name: &str, whose: &str, draft: &mut Draft<'_>) -> Read<()> {
    for (key, value) in keys.iter() {
        let (at, key) = (key.span(), key.get_ref().as_ref());
        let basis = draft.basis(key, &at);
        let unknown = || {
            let known: Vec<&str> = Dialect::keys_of(name).collect();
            ConfigurationMistake::unknown_key(at, key, &format!("of `{whose}`"), &known)
        };
        let stated = draft
            .dialect
            .state(&format!("{name}.{key}"), value.get_ref(), basis);
        stated
            .ok_or_else(unknown)?
            .map_err(|message| ConfigurationMistake::at(value.span(), format!("`{key}` {message}")))?;
    }
    Ok(())
}

/// Reads `[dialects.NAME.implicit]`: `"FROM.TO" = "yes"`, with or without the quotes.
///
/// # Errors
/// An unknown type, a type that the dialect does not have, a pair that cannot be overridden or is stated twice, or an
/// unknown word.
fn implicit(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Read<()> {
    let mut read = BTreeSet::new();
    for (key, value) in keys.iter() {
        let name = key.get_ref().as_ref();
        match (value.get_ref().as_table(), name.split_once('.')) {
            // Without quotes TOML reads a table of its own.
            (Some(columns), None) => {
                for (column, value) in columns.iter() {
                    let to = column.get_ref().as_ref();
                    cell((name, &key.span()), (to, &column.span()), value, draft, &mut read)?;
                }
            }
            (None, Some((from, to))) => {
                cell((from, &key.span()), (to, &key.span()), value, draft, &mut read)?;
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

/// Reads the word of a pair, which is not among those that were `read`.
fn cell(
    (from, from_at): (&str, &Range<usize>),
    (to, to_at): (&str, &Range<usize>),
    value: &Spanned<DeValue<'_>>,
    draft: &mut Draft<'_>,
    read: &mut BTreeSet<Pair>,
) -> Read<()> {
    let key = format!("{from}.{to}");
    let (from, to) = (elementary(from, from_at, draft)?, elementary(to, to_at, draft)?);
    if from == to {
        let message = format!("`{key}` needs no word; a type always stands for itself");
        return Err(ConfigurationMistake::at(to_at.clone(), message));
    }
    let word = one_of(value.get_ref(), &WORDS, MatrixWord::as_str)
        .map_err(|message| ConfigurationMistake::at(value.span(), format!("`{key}` {message}")))?;
    if word != MatrixWord::No && !(draft.converts)(from, to) {
        let message = format!(
            "`{key}` cannot be `{}`; there is no conversion from {from} to {to}",
            word.as_str()
        );
        return Err(ConfigurationMistake::at(value.span(), message));
    }
    let basis = draft.basis(&format!("implicit {from}.{to}"), from_at);
    draft
        .dialect
        .cells
        .insert((from, to), Stated { value: word, basis });
    // A pair can be written with and without quotes, which are different keys to TOML.
    if !read.insert((from, to)) {
        let message = format!("`{key}` has a word already");
        return Err(ConfigurationMistake::at(to_at.clone(), message));
    }
    Ok(())
}

/// Returns the elementary type of a name, if the dialect has it.
pub(crate) fn elementary(name: &str, at: &Range<usize>, draft: &Draft<'_>) -> Read<ElementaryType> {
    let types = ElementaryType::ALL.map(ElementaryType::name);
    let found = ElementaryType::ALL.into_iter().find(|ty| ty.name() == name);
    let ty = found.ok_or_else(|| {
        let message = format!("there is no type `{name}`; {}", advice(name, &types));
        ConfigurationMistake::at(at.clone(), message)
    })?;
    if ty.is_third_edition() && draft.dialect.third_edition_types == ThirdEditionTypes::None {
        let third_edition = ElementaryType::ALL.into_iter().filter(|ty| ty.is_third_edition());
        let message = format!(
            "`{}` has no type {ty}, for {} has none; `third-edition-types = true` among its flags gives it {}",
            draft.dialect.spelling,
            draft.dialect.base,
            list(third_edition.map(ElementaryType::name))
        );
        return Err(ConfigurationMistake::at(at.clone(), message));
    }
    Ok(ty)
}
