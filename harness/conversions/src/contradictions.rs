//! Contradictions: questions to which documents, editions of the standard, recordings and measurements give different answers.
//!
//! [`ContradictionsBuilder`] takes answers, each with its origin, and groups the questions on which they differ into topics: questions of
//! one kind on which the same systems part in the same way are one [`Topic`], which shows the question with the most different answers.

mod builder;
mod kind;
mod write;

pub use builder::{AskedQuestion, ContradictionsBuilder};
pub use kind::kind_of;

use serde::Serialize;
use std::collections::HashMap;
use std::sync::Arc;
use stickler_types::DialectName;

/// What an answer rests on: a source that states it, or a compiler that was recorded or measured to give it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize)]
pub struct AnswerOrigin {
    /// The system of which the answer is, or the edition of the standard.
    pub system: String,
    /// `document`, `standard`, `recording` or `measurement`.
    pub kind: &'static str,
    /// The source and section, as the suite writes a basis.
    pub source: String,
    /// The publisher and its relation to the makers of the system, such as `ForgeIEC, integrator`; `None` where the makers say it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub publisher: Option<String>,
    /// The edition, version, commit or date of the source.
    pub read: String,
    /// The address at which it opens.
    pub address: String,
}

/// Every topic on which sources contradict each other, the largest disagreement first.
#[derive(Clone, Default, Debug, Serialize)]
pub struct Contradictions {
    /// The topics that are kept.
    pub topics: Vec<Topic>,
    /// The number of topics, those that were left out among them.
    pub number: usize,
    /// The number of questions of all topics.
    pub questions: usize,
    /// By the id of a case and its dialect, the topic whose question it asks, and the answer that the case states.
    #[serde(skip)]
    cases: HashMap<(Arc<str>, DialectName), (usize, String)>,
}

/// Questions of one kind on which the same systems part in the same way.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Topic {
    /// The question with the most different answers.
    pub question: String,
    /// The kind of the questions.
    pub kind: String,
    /// The id of a case that asks the question, where one does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// The program of the question, where its text does not say all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// The answers, those of most systems first.
    pub answers: Vec<TopicAnswer>,
    /// The number of systems that have an answer.
    pub systems: usize,
    /// The number of questions of the topic.
    pub questions: usize,
    /// Some of the other questions.
    pub others: Vec<String>,
}

/// An answer to the question of a topic.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct TopicAnswer {
    /// The answer: a value, `accepted`, `rejected` …
    pub answer: String,
    /// The origins, ordered by system.
    pub by: Vec<AnswerOrigin>,
}

impl Contradictions {
    /// Leaves out all topics but the largest ones. [`Contradictions::number`] still counts all.
    pub fn keep(&mut self, largest: usize) {
        self.topics.truncate(largest);
        self.cases.retain(|_, (topic, _)| *topic < largest);
    }

    /// Returns whether no source contradicts another.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.topics.is_empty()
    }

    /// Returns the index of the topic whose question a case asks, and the answer that the case states; `None` for every other case.
    #[must_use]
    pub fn asked_by(&self, case: &Arc<str>, dialect: DialectName) -> Option<(usize, &str)> {
        let (topic, answer) = self.cases.get(&(Arc::clone(case), dialect))?;
        Some((*topic, answer))
    }
}
