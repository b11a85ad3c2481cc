//! The answers of a recording as texts, each with its question.

use super::{FunctionAnswers, RecordedSection, Recording};
use crate::implicit::MatrixAnswer;
use stickler_types::{ConversionCall, DialectName, ElementaryType, Question};

impl Recording {
    /// Returns each question that the compiler answered with a value, with acceptance or with a rejection, in no order; no call that it
    /// refused.
    pub(crate) fn answers(&self) -> Vec<(DialectName, Question, String)> {
        let words = self
            .words
            .iter()
            .filter_map(|((dialect, (section, ty, other)), word)| {
                let named = || Some((*ty, ElementaryType::from_name(other)?));
                let (question, answer) = match section {
                    RecordedSection::Implicit => (Question::Implicit(named()?), accepted(word)?),
                    RecordedSection::Bits => (Question::Part(*ty, other.clone()), accepted(word)?),
                    RecordedSection::Comparisons => (Question::Comparison(named()?), compared(word)?),
                    RecordedSection::Functions => return None,
                };
                Some((*dialect, question, answer.to_owned()))
            });
        let calls = self.functions.iter().flat_map(|((dialect, row), answers)| {
            let function = row.split('(').next().unwrap_or_default();
            let calls = match answers {
                FunctionAnswers::Calls(calls) => &calls[..],
                FunctionAnswers::Refused(_) => &[],
            };
            let answer = move |(operands, value): &(Vec<_>, Result<stickler_types::Value, _>)| {
                let value = value.as_ref().ok()?;
                let call = ConversionCall {
                    function: function.to_owned(),
                    operands: operands.clone(),
                    result: ElementaryType::from_name(value.type_name())?,
                };
                Some((*dialect, Question::Call(call), value.to_string()))
            };
            calls.iter().filter_map(answer)
        });
        words.chain(calls).collect()
    }
}

/// Returns the answer of a word about the acceptance of a program; `None` where the compiler failed or had none.
fn accepted(word: &str) -> Option<&'static str> {
    match MatrixAnswer::from_word(word)? {
        MatrixAnswer::Accepts => Some("accepted"),
        MatrixAnswer::Warns => Some("accepted with a warning"),
        MatrixAnswer::Rejects => Some("rejected"),
        MatrixAnswer::Unsupported | MatrixAnswer::Fails => None,
    }
}

/// Returns the answer of a word about a comparison.
fn compared(word: &str) -> Option<&'static str> {
    match word {
        "true" => Some("BOOL#TRUE"),
        "false" => Some("BOOL#FALSE"),
        "rejected" => Some("rejected"),
        _ => None,
    }
}
