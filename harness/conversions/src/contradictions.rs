//! Contradictions: questions to which documents, editions of the standard, recordings and measurements give different answers.
//!
//! [`ContradictionsBuilder`] takes answers, each with its origin, and groups the questions on which they differ into topics: questions of
//! one kind on which the same systems part in the same way are one [`Topic`], which shows the question on which the most systems differ.

mod builder;
mod kind;
mod write;

pub use builder::{AskedQuestion, ContradictionsBuilder, NewAnswer};

use serde::Serialize;
use stickler_types::DialectName;

/// The origin of an answer to a question: the source that states the answer, or the compiler that was recorded or measured to give it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
pub struct AnswerOrigin {
    /// The system whose answer it is, or the edition of the standard.
    pub system: String,
    /// The kind of the source: `document`, `standard`, `recording`, `measurement`; behind it `of ForgeIEC` where somebody else publishes it.
    pub kind: String,
    /// The source and section, as the suite writes a basis.
    pub source: String,
    /// The edition, version, commit or date of the source.
    pub read: String,
    /// The address at which it opens.
    pub address: String,
    /// The dialect in which the question was asked.
    #[serde(skip)]
    pub dialect: Option<DialectName>,
}

/// The topics on which sources contradict each other, the largest disagreement first.
#[derive(Clone, Default, Debug, Serialize)]
pub struct Contradictions {
    /// The topics that are kept.
    pub topics: Vec<Topic>,
    /// The number of topics, those that were left out among them.
    pub number: usize,
    /// The number of questions of all topics.
    pub questions: usize,
}

/// Questions of one kind on which the same systems part in the same way.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Topic {
    /// The question on which the most systems differ.
    pub question: String,
    /// The kind of the questions.
    pub kind: String,
    /// The id of a case that asks the question, where one does.
    pub case: Option<String>,
    /// The program of the question, where its text does not say all.
    pub program: Option<String>,
    /// The answers, those with the most origins first, and the origins of each, ordered by system.
    pub answers: Vec<(String, Vec<AnswerOrigin>)>,
    /// The number of systems that have an answer.
    pub systems: usize,
    /// The number of questions of the topic.
    pub questions: usize,
    /// Examples of the other questions of the topic.
    pub others: Vec<String>,
}
