//! Reads the file of a recording.

use super::{FunctionAnswers, Recording, RecordingOrigin};
use crate::implicit::{MatrixAnswer, TypePair};
use crate::session::RefusalKind;
use serde::Deserialize;
use std::collections::{BTreeMap, HashMap};
use stickler_types::{DialectName, ElementaryType, Value, WrittenValue};
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
    answers: Vec<Spanned<Answers>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Answers {
    dialects: Vec<String>,
    #[serde(default)]
    implicit: BTreeMap<Spanned<String>, BTreeMap<String, String>>,
    #[serde(default)]
    functions: BTreeMap<Spanned<String>, Row>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Row {
    Refused(String),
    Calls(Vec<Vec<String>>),
}

/// A mistake: where it stands in the text, and the message.
type Mistake = (usize, String);

impl Recording {
    /// Reads the text of a file; `file` is its path in messages.
    ///
    /// # Errors
    /// A file that is no recording, or lacks product, version, platform or date.
    pub fn parse(file: &str, text: &str) -> Result<Recording, RecordingError> {
        read(text).map_err(|(offset, message)| RecordingError {
            file: file.to_owned(),
            line: 1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count(),
            message,
        })
    }
}

fn read(text: &str) -> Result<Recording, Mistake> {
    let File { recording, answers } = toml::from_str(text).map_err(|error| {
        let offset = error.span().map_or(0, |span| span.start);
        let message = error.message().trim_end().replace('\n', "; ");
        let advice = match message.starts_with("missing field") {
            true => "; a recording says in [recording] its product, version, platform and date",
            false => "",
        };
        (offset, format!("{message}{advice}"))
    })?;
    let offset = recording.span().start;
    let origin = recording.into_inner();
    for (name, text) in [
        ("product", &origin.product),
        ("version", &origin.version),
        ("platform", &origin.platform),
        ("date", &origin.date),
    ] {
        if text.trim().is_empty() {
            let message =
                format!("`{name}` is empty; say there what was recorded, for answers differ with it");
            return Err((offset, message));
        }
    }
    let mut read = Recording {
        origin,
        dialects: Vec::new(),
        implicit: HashMap::new(),
        functions: HashMap::new(),
    };
    answers
        .into_iter()
        .try_for_each(|answers| add(&mut read, answers))?;
    Ok(read)
}

fn add(recording: &mut Recording, answers: Spanned<Answers>) -> Result<(), Mistake> {
    let offset = answers.span().start;
    let Answers {
        dialects,
        implicit,
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
    for (row, columns) in implicit {
        let offset = row.span().start;
        let pairs = implicit_row(row.get_ref(), &columns).map_err(|message| (offset, message))?;
        for dialect in &dialects {
            let keyed = pairs.iter().map(|(pair, answer)| ((*dialect, *pair), *answer));
            recording.implicit.extend(keyed);
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

fn implicit_row(
    row: &str,
    columns: &BTreeMap<String, String>,
) -> Result<Vec<(TypePair, MatrixAnswer)>, String> {
    let from = type_of(row)?;
    let mut pairs = Vec::new();
    for (word, types) in columns {
        let answer = MatrixAnswer::from_word(word).ok_or_else(|| {
            let known = MatrixAnswer::ALL.map(MatrixAnswer::as_str).join(", ");
            format!("`{word}` is no answer of a compiler; one of {known} is")
        })?;
        for name in types.split_whitespace() {
            pairs.push(((from, type_of(name)?), answer));
        }
    }
    Ok(pairs)
}

fn function_row(key: &str, row: &Row) -> Result<FunctionAnswers, String> {
    let no_signature = || format!("`{key}` is no signature such as `REAL_TO_INT(REAL) : INT`");
    let (call, result) = key.split_once(") : ").ok_or_else(no_signature)?;
    let (_, operands) = call.split_once('(').ok_or_else(no_signature)?;
    let operands: Vec<ElementaryType> = operands.split(", ").map(type_of).collect::<Result<_, _>>()?;
    let result = type_of(result)?;
    let calls = match row {
        Row::Refused(word) => {
            let kind = RefusalKind::from_word(word);
            return Ok(FunctionAnswers::Refused(kind.ok_or_else(|| no_answer(word))?));
        }
        Row::Calls(calls) => calls,
    };
    let call = |texts: &Vec<String>| match texts.split_last() {
        Some((answer, given)) if given.len() == operands.len() => {
            let typed = given.iter().zip(&operands);
            let values = typed.map(|(text, ty)| value(text, *ty));
            let answer = match RefusalKind::from_word(answer) {
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
