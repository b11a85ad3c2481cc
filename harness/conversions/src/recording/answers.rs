//! The answers of a recording as texts, each with its question.

use super::{FunctionAnswers, RecordedSection, Recording};
use stickler_types::{ConversionCall, DialectName, ElementaryType, Question};

impl Recording {
    /// Returns each question that the compiler answered with a value, with acceptance or with a rejection, in no order; no call that it
    /// refused, which may be for its name.
    pub(crate) fn answers(&self) -> Vec<(DialectName, Question, String)> {
        let words = self
            .words
            .iter()
            .filter_map(|((dialect, (section, ty, other)), word)| {
                let pair = ElementaryType::from_name(other).map(|other| (*ty, other));
                let question = match section {
                    RecordedSection::Implicit => Question::Implicit(pair?),
                    RecordedSection::Bits => Question::Part(*ty, other.clone()),
                    RecordedSection::Comparisons => Question::Comparison(pair?),
                    RecordedSection::Functions => return None,
                };
                let answer = match *word {
                    "accepts" | "warns" => "accepted",
                    "rejects" | "rejected" => "rejected",
                    "true" => "BOOL#TRUE",
                    "false" => "BOOL#FALSE",
                    _ => return None,
                };
                Some((*dialect, question, answer.to_owned()))
            });
        let mut answers: Vec<_> = words.collect();
        for ((dialect, row), recorded) in &self.functions {
            let (Some((function, _)), FunctionAnswers::Calls(calls)) = (row.split_once('('), recorded) else {
                continue;
            };
            for (operands, value) in calls {
                if let Ok(value) = value
                    && let Some(result) = ElementaryType::from_name(value.type_name())
                {
                    let (function, operands) = (function.to_owned(), operands.clone());
                    let call = ConversionCall {
                        function,
                        operands,
                        result,
                    };
                    answers.push((*dialect, Question::Call(call), value.to_string()));
                }
            }
        }
        answers
    }
}
