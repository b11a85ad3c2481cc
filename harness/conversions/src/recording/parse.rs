//! Reads the file of a recording.

use super::{FunctionAnswers, RecordedSection, Recording, WordKey};
use crate::implicit::MatrixAnswer;
use crate::session::RefusalKind;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use stickler_types::{DialectName, ElementaryType, RecordingOrigin, Value, WrittenValue, is_part, join};
use toml::Spanned;

/// The mistake for which the file of a recording is refused: its file, its line, what is wrong, and what to do.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct RecordingError {
    /// The path of the file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The mistake, and what to do.
    pub message: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    recording: Spanned<RecordingOrigin>,
    #[serde(default)]
    answers: Vec<Spanned<AnswerSection>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AnswerSection {
    dialects: Vec<String>,
    #[serde(default)]
    implicit: WordRows,
    #[serde(default)]
    bits: WordRows,
    #[serde(default)]
    comparisons: WordRows,
    #[serde(default)]
    functions: BTreeMap<Spanned<String>, RecordedRow>,
}

/// Rows by the type of their value; in a row, the words of answers, each with a list of those that it is the answer to.
type WordRows = BTreeMap<Spanned<String>, BTreeMap<String, String>>;

#[derive(Deserialize)]
#[serde(untagged)]
enum RecordedRow {
    Refused(String),
    Calls(Vec<Vec<String>>),
}

/// A mistake: where it stands in the text, and the message.
type LocatedMistake = (usize, String);

impl Recording {
    /// Reads the text of a file; `file` is its path in messages.
    ///
    /// # Errors
    /// A file that is no recording, or lacks product, version, platform or date.
    pub fn parse(file: &str, text: &str) -> Result<Recording, RecordingError> {
        let stem = Path::new(file).file_stem();
        let name = stem.map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        read(name, text).map_err(|(offset, message)| RecordingError {
            file: file.to_owned(),
            line: 1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count(),
            message,
        })
    }
}

fn read(name: String, text: &str) -> Result<Recording, LocatedMistake> {
    let File { recording, answers } = toml::from_str(text).map_err(|error| {
        let offset = error.span().map_or(0, |span| span.start);
        let message = error.message().trim_end().replace('\n', "; ");
        let advice = match message.starts_with("missing field") {
            true => format!("; {}", RecordingOrigin::REQUIRED),
            false => String::new(),
        };
        (offset, format!("{message}{advice}"))
    })?;
    let offset = recording.span().start;
    let origin = recording.into_inner();
    if let Some(message) = origin.mistake() {
        return Err((offset, message));
    }
    let mut read = Recording::empty(&name, origin, Vec::new());
    answers
        .into_iter()
        .try_for_each(|answers| add(&mut read, answers))?;
    Ok(read)
}

fn add(recording: &mut Recording, answers: Spanned<AnswerSection>) -> Result<(), LocatedMistake> {
    let offset = answers.span().start;
    let AnswerSection {
        dialects,
        implicit,
        bits,
        comparisons,
        functions,
    } = answers.into_inner();
    let dialects: Vec<DialectName> = dialects
        .iter()
        .map(|name| name.parse().map_err(|error| (offset, format!("{error}"))))
        .collect::<Result<_, _>>()?;
    for dialect in &dialects {
        if !recording.dialects.contains(dialect) {
            recording.dialects.push(*dialect);
        }
    }
    for (section, rows) in [
        (RecordedSection::Implicit, implicit),
        (RecordedSection::Bits, bits),
        (RecordedSection::Comparisons, comparisons),
    ] {
        for (row, columns) in rows {
            let words = word_row(section, row.get_ref(), &columns);
            for (key, word) in words.map_err(|message| (row.span().start, message))? {
                let keys = dialects.iter().map(|dialect| (*dialect, key.clone()));
                recording.words.extend(keys.map(|key| (key, word)));
            }
        }
    }
    for (key, row) in functions {
        let offset = key.span().start;
        let answers = function_row(key.get_ref(), &row).map_err(|message| (offset, message))?;
        for dialect in &dialects {
            let key = (*dialect, key.get_ref().clone());
            recording.functions.insert(key, answers.clone());
        }
    }
    Ok(())
}

/// Reads a row: its type, and the word of the answer for each listed type or part.
fn word_row(
    section: RecordedSection,
    row: &str,
    columns: &BTreeMap<String, String>,
) -> Result<Vec<(WordKey, &'static str)>, String> {
    let from = type_of(row)?;
    let mut read = Vec::new();
    for (word, listed) in columns {
        let word = match section {
            RecordedSection::Comparisons => comparison(word)?,
            _ => matrix_answer(word)?,
        };
        for text in listed.split_whitespace() {
            let column = match section {
                RecordedSection::Bits => part_of(text)?,
                _ => type_of(text)?.name().to_owned(),
            };
            read.push(((section, from, column), word));
        }
    }
    Ok(read)
}

fn matrix_answer(word: &str) -> Result<&'static str, String> {
    let answer = MatrixAnswer::from_word(word).map(MatrixAnswer::as_str);
    answer.ok_or_else(|| {
        let known = join(MatrixAnswer::ALL, ", ");
        format!("`{word}` is no answer of a compiler; one of {known} is")
    })
}

fn comparison(word: &str) -> Result<&'static str, String> {
    let refusals = RefusalKind::STORED.map(RefusalKind::word);
    let mut known = ["true", "false"].into_iter().chain(refusals);
    known.find(|known| *known == word).ok_or_else(|| {
        let known = refusals.join(", ");
        format!("`{word}` is neither `true` nor `false` nor one of {known}")
    })
}

/// Reads a bit or a part of a variable.
fn part_of(text: &str) -> Result<String, String> {
    match is_part(text) {
        true => Ok(text.to_owned()),
        false => Err(format!("`{text}` is no bit or part such as `7`, `%X7` or `%B1`")),
    }
}

fn function_row(key: &str, row: &RecordedRow) -> Result<FunctionAnswers, String> {
    let no_signature = || format!("`{key}` is no signature such as `REAL_TO_INT(REAL) : INT`");
    let (call, result) = key.split_once(") : ").ok_or_else(no_signature)?;
    let (_, operands) = call.split_once('(').ok_or_else(no_signature)?;
    let operands: Vec<ElementaryType> = operands.split(", ").map(type_of).collect::<Result<_, _>>()?;
    let result = type_of(result)?;
    let calls = match row {
        RecordedRow::Refused(word) => {
            let kind = RefusalKind::stored(word);
            return Ok(FunctionAnswers::Refused(kind.ok_or_else(|| no_answer(word))?));
        }
        RecordedRow::Calls(calls) => calls,
    };
    let call = |texts: &Vec<String>| match texts.split_last() {
        Some((answer, given)) if given.len() == operands.len() => {
            let typed = given.iter().zip(&operands);
            let values = typed.map(|(text, ty)| value(text, *ty));
            let answer = match RefusalKind::stored(answer) {
                Some(kind) => Err(kind),
                None => Ok(observed(answer, result).ok_or_else(|| no_answer(answer))?),
            };
            Ok((values.collect::<Result<_, _>>()?, answer))
        }
        _ => Err(format!(
            "a call of `{key}` is a list of {} texts: its operands and its result",
            operands.len() + 1
        )),
    };
    Ok(FunctionAnswers::Calls(
        calls.iter().map(call).collect::<Result<_, _>>()?,
    ))
}

fn type_of(name: &str) -> Result<ElementaryType, String> {
    ElementaryType::from_name(name).ok_or_else(|| format!("`{name}` is no elementary type"))
}

fn value(text: &str, ty: ElementaryType) -> Result<Value, String> {
    let written = WrittenValue::parse(ty, text);
    Ok(written
        .map_err(|error| format!("`{text}` is no value of type {ty}: {error}"))?
        .value)
}

/// Reads a result, which may be a value that its type does not have.
fn observed(text: &str, ty: ElementaryType) -> Option<Value> {
    let beyond = || {
        Value::parse_observed(text)
            .ok()
            .filter(|value| value.type_name() == ty.name())
    };
    value(text, ty).ok().or_else(beyond)
}

fn no_answer(text: &str) -> String {
    let words: Vec<&str> = RefusalKind::STORED.iter().map(|kind| kind.word()).collect();
    format!(
        "`{text}` is neither a value of the result's type nor one of {}",
        words.join(", ")
    )
}
