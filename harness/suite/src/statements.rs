//! What sources say in answer to questions that no case can ask, from `statements.toml`: of standard function blocks, for instance, which the
//! reference does not have, or of systems without a dialect.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::{Question, Value};
use toml::Spanned;

use crate::error::{CaseFileError, Mistake};
use crate::place::Lines;
use crate::toml_text::{self, Strings};
use crate::{SourceKind, Sources, files};

/// The file of the statements, below the root of a suite.
const STATEMENTS: &str = "statements.toml";

/// A question with the answers of sources.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StatedQuestion {
    /// What is asked: the text of a [`Question`], or words.
    pub asks: String,
    /// The answers, each with the bases that state it.
    pub answers: Vec<(String, Vec<String>)>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementsFile {
    #[serde(default)]
    question: Vec<QuestionEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct QuestionEntry {
    asks: Spanned<String>,
    answers: BTreeMap<Spanned<String>, Strings>,
}

/// Reads the statements of a suite and what is wrong with their file. A suite without the file has none.
pub(crate) fn read(root: &files::Root, sources: &Sources) -> (Vec<StatedQuestion>, Vec<CaseFileError>) {
    root.read_own(STATEMENTS, |text| {
        let lines = Lines::new(text);
        match toml_text::read::<StatementsFile>(text, 0, &lines) {
            Ok(file) => checked(file, sources, &lines),
            Err(mistake) => (Vec::new(), vec![mistake]),
        }
    })
}

fn checked(file: StatementsFile, sources: &Sources, lines: &Lines) -> (Vec<StatedQuestion>, Vec<Mistake>) {
    let mut questions: Vec<StatedQuestion> = Vec::new();
    let mut mistakes = Vec::new();
    for QuestionEntry { asks, answers } in file.question {
        let mut wrong = |at: usize, key: &str, message: String| {
            mistakes.push(Mistake::new(lines.line(at), message).key(key));
        };
        let at = asks.span().start;
        let asks = asks.into_inner();
        if questions.iter().any(|known| known.asks == asks) {
            wrong(
                at,
                "asks",
                format!("`{asks}` is asked twice; write its answers in one place"),
            );
        }
        let question = asks.parse::<Question>();
        // The other answers to a question that cases ask are those of the cases.
        if question.is_err() && answers.len() < 2 {
            wrong(
                at,
                "answers",
                "a question that no case asks needs two answers that differ".to_owned(),
            );
        }
        let answers = toml_text::in_order(answers).into_iter().map(|(says, by)| {
            let at = says.span().start;
            let says = says.into_inner();
            if matches!(question, Ok(Question::Call(_))) && Value::parse(&says).is_err() {
                wrong(
                    at,
                    "answers",
                    format!("`{says}` is no typed literal, which the answer to a call is"),
                );
            }
            if by.0.is_empty() {
                wrong(
                    at,
                    "answers",
                    format!("no source says `{says}`; name one, `source: section`"),
                );
            }
            for basis in &by.0 {
                match sources.check(basis.get_ref()) {
                    Ok((source, _)) if source.kind == SourceKind::Rule => {
                        let message = format!("`{}` is Stickler's own, and no statement", basis.get_ref());
                        wrong(basis.span().start, "answers", message);
                    }
                    Ok(_) => {}
                    Err(message) => wrong(basis.span().start, "answers", message),
                }
            }
            (says, by.0.into_iter().map(Spanned::into_inner).collect())
        });
        let answers = answers.collect();
        questions.push(StatedQuestion { asks, answers });
    }
    (questions, mistakes)
}
