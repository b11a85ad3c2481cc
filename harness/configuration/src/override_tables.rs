//! Reads the overrides of a table `[dialects.NAME]`: `implicit`, `flags`, `conversions` and `operators`.

use crate::draft::Draft;
use crate::near::{advice, list};
use crate::table::{ConfigurationMistake, text};
use std::collections::BTreeSet;
use std::ops::Range;
use stickler_types::definition::Flag;
use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsReal, ComparedTypes, ConstantTypes, DialectName, ElementaryType,
    ImplicitWarnings, MatrixWord, MomentText, MomentUnits, OperandTypes, OutOfRange, RealText, ResultSigns,
    Rounding, ShiftCounts, Stated, TextReading,
};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys of the table `conversions`.
const CONVERSIONS: [&str; 10] = [
    "rounding",
    "out-of-range",
    "truncation-out-of-range",
    "text-reading",
    "real-text",
    "bit-string-text",
    "moment-text",
    "bits-as-real",
    "bit-string-as-bool",
    "moment-units",
];

/// The keys of the table `operators`.
const OPERATORS: [&str; 6] = [
    "implicit-warnings",
    "operands",
    "compared",
    "result-signs",
    "constant-types",
    "shift-counts",
];

/// The words that an override may state for a pair of different types.
const WORDS: [MatrixWord; 4] = [
    MatrixWord::Yes,
    MatrixWord::Warn,
    MatrixWord::No,
    MatrixWord::Open,
];

/// The permitted numbers of significant digits; a real number of 64 bits never needs more than 17.
const DIGITS: std::ops::RangeInclusive<u8> = 1..=40;

/// Reads `[dialects.NAME.flags]`.
///
/// # Errors
/// An unknown flag, or a value that is neither true nor false.
pub(crate) fn flags(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
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
            Flag::CrossFamilyWidening => cross_family(on, &key.span(), draft),
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

/// Reads `[dialects.NAME.conversions]`.
///
/// # Errors
/// An unknown choice, or an unknown word for one.
pub(crate) fn conversions(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    for (key, value) in keys.iter() {
        let (name, at) = (key.get_ref().as_ref(), &key.span());
        let entry = ChoiceEntry { name, at, value };
        macro_rules! choose {
            ($field:ident, $all:expr, $words:ident) => {
                draft.definition.$field = Some(entry.choice($all, $words::as_str, draft)?)
            };
        }
        match name {
            "rounding" => choose!(rounding, &Rounding::OF_CONVERSIONS, Rounding),
            "out-of-range" => choose!(out_of_range, OutOfRange::ALL, OutOfRange),
            "truncation-out-of-range" => choose!(truncation_out_of_range, OutOfRange::ALL, OutOfRange),
            "text-reading" => choose!(text_reading, TextReading::ALL, TextReading),
            "real-text" => {
                let word = real_text(name, value)?;
                draft.definition.real_text = Some(draft.stated(word, name, at));
            }
            "bit-string-text" => choose!(bit_string_text, BitStringText::ALL, BitStringText),
            "moment-text" => choose!(moment_text, MomentText::ALL, MomentText),
            "bits-as-real" => choose!(bits_as_real, BitsAsReal::ALL, BitsAsReal),
            "bit-string-as-bool" => choose!(bit_string_as_bool, BitStringAsBool::ALL, BitStringAsBool),
            "moment-units" => choose!(moment_units, MomentUnits::ALL, MomentUnits),
            _ => return Err(entry.unknown("conversions", &CONVERSIONS, draft)),
        }
    }
    Ok(())
}

/// Reads `[dialects.NAME.operators]`.
///
/// # Errors
/// An unknown choice, or an unknown word for one.
pub(crate) fn operators(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
    for (key, value) in keys.iter() {
        let (name, at) = (key.get_ref().as_ref(), &key.span());
        let entry = ChoiceEntry { name, at, value };
        macro_rules! choose {
            ($field:ident, $words:ident) => {
                draft.definition.operators.$field = Some(entry.choice($words::ALL, $words::as_str, draft)?)
            };
        }
        match name {
            "implicit-warnings" => choose!(implicit_warnings, ImplicitWarnings),
            "operands" => choose!(operands, OperandTypes),
            "compared" => choose!(compared, ComparedTypes),
            "result-signs" => choose!(result_signs, ResultSigns),
            "constant-types" => choose!(constant_types, ConstantTypes),
            "shift-counts" => choose!(shift_counts, ShiftCounts),
            _ => return Err(entry.unknown("operators", &OPERATORS, draft)),
        }
    }
    Ok(())
}

/// A key of a table of choices, and its value.
struct ChoiceEntry<'e, 'v> {
    name: &'e str,
    at: &'e Range<usize>,
    value: &'e Spanned<DeValue<'v>>,
}

impl ChoiceEntry<'_, '_> {
    /// Returns the choice of `all` that the value names, with its basis.
    fn choice<T: Copy>(
        &self,
        all: &[T],
        as_str: impl Fn(T) -> &'static str,
        draft: &Draft<'_>,
    ) -> Result<Stated<T>, ConfigurationMistake> {
        let word = one_of(self.name, self.value, all, as_str)?;
        Ok(draft.stated(word, self.name, self.at))
    }

    /// Returns the mistake of a key that the table does not have.
    fn unknown(&self, table: &str, known: &[&str], draft: &Draft<'_>) -> ConfigurationMistake {
        ConfigurationMistake::unknown_key(self.at.clone(), self.name, &of(table, draft), known)
    }
}

fn real_text(name: &str, value: &Spanned<DeValue<'_>>) -> Result<RealText, ConfigurationMistake> {
    let said = format!(
        "`{name}` is \"shortest\", \"by-width\", or a number of significant digits from {} to {}",
        DIGITS.start(),
        DIGITS.end()
    );
    let digits = value
        .get_ref()
        .as_integer()
        .and_then(|number| u8::from_str_radix(number.as_str(), number.radix()).ok())
        .filter(|digits| DIGITS.contains(digits));
    match (value.get_ref().as_str(), digits) {
        (Some("shortest"), _) => Ok(RealText::Shortest),
        (Some("by-width"), _) => Ok(RealText::ByWidth),
        (None, Some(digits)) => Ok(RealText::SignificantDigits(digits)),
        _ => Err(ConfigurationMistake::at(value.span(), said)),
    }
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
pub(crate) fn implicit(keys: &DeTable<'_>, draft: &mut Draft<'_>) -> Result<(), ConfigurationMistake> {
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
    if word != MatrixWord::No && !has_meaning(from, to) {
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
            draft.definition.base.name(),
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
    let base = || !stickler_exact::signatures("TO_LTIME", draft.definition.base.name()).is_empty();
    draft
        .definition
        .flag(Flag::ThirdEditionTypes)
        .unwrap_or_else(base)
}

/// Returns whether a conversion function for the pair exists, in a dialect that has all types.
fn has_meaning(from: ElementaryType, to: ElementaryType) -> bool {
    !stickler_exact::signatures(&format!("{from}_TO_{to}"), DialectName::IronplcEd3).is_empty()
}

fn of(table: &str, draft: &Draft<'_>) -> String {
    format!("of `[dialects.{}.{table}]`", draft.definition.name)
}
