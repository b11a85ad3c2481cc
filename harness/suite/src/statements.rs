//! What sources say in answer to questions that no case asks yet, from `statements.toml`: of standard function blocks, for instance, or of
//! systems without a dialect.

use std::collections::BTreeMap;

use stickler_types::{Question, Value};
use toml::Spanned;

use crate::error::{CaseFileError, Mistake};
use crate::place::Lines;
use crate::toml_text::{self, Strings};
use crate::{SourceKind, Sources, files};

/// The answer of a source to a question.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SourceStatement {
    /// What is asked: the text of a [`Question`], or words.
    pub asks: String,
    /// The answer.
    pub answer: String,
    /// The source and section that state it.
    pub basis: String,
}

/// The answers to each question, and the bases of each answer.
type StatementTables = BTreeMap<Spanned<String>, BTreeMap<Spanned<String>, Strings>>;

/// Reads the statements of a suite and what is wrong with their file. A suite without the file has none.
pub(crate) fn read(root: &files::Root, sources: &Sources) -> (Vec<SourceStatement>, Vec<CaseFileError>) {
    root.read_toml("statements.toml", |tables, lines| checked(tables, sources, lines))
}

fn checked(
    tables: StatementTables,
    sources: &Sources,
    lines: &Lines,
) -> (Vec<SourceStatement>, Vec<Mistake>) {
    let mut statements = Vec::new();
    let mut mistakes = Vec::new();
    let mut wrong = |at: usize, message: String| mistakes.push(Mistake::new(lines.line(at), message));
    for (asks, table) in toml_text::in_order(tables) {
        let question = asks.get_ref().parse::<Question>();
        // The other answers to a question that cases ask are those of the cases.
        if question.is_err() && table.len() < 2 {
            wrong(
                asks.span().start,
                "no case asks this; give two answers that differ".to_owned(),
            );
        }
        for (says, Strings(by)) in toml_text::in_order(table) {
            if matches!(question, Ok(Question::Call(_))) && Value::parse(says.get_ref()).is_err() {
                let message = format!(
                    "`{}` is no typed literal, as the answer to a call is",
                    says.get_ref()
                );
                wrong(says.span().start, message);
            }
            for basis in by {
                match sources.check(basis.get_ref()) {
                    Ok((source, _)) if source.kind == SourceKind::Rule => {
                        wrong(
                            basis.span().start,
                            "a rule of Stickler's own is no statement".to_owned(),
                        );
                    }
                    Ok(_) => statements.push(SourceStatement {
                        asks: asks.get_ref().clone(),
                        answer: says.get_ref().clone(),
                        basis: basis.into_inner(),
                    }),
                    Err(message) => wrong(basis.span().start, message),
                }
            }
        }
    }
    (statements, mistakes)
}
