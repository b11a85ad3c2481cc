//! Contradictions: questions to which documents, editions of the standard, recordings and measurements give different answers.
//!
//! [`ContradictionsBuilder`] takes answers, each with its origin, and groups the questions on which they differ into topics: questions of
//! one kind on which the same systems part in the same way are one [`Topic`], which shows the question on which the most systems differ.

mod builder;

pub use builder::{AskedQuestion, ContradictionsBuilder, NewAnswer};

use serde::Serialize;
use std::io::{self, Write};
use stickler_types::{DialectName, counted, shortened};

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

/// The maximum number of characters of a question or an answer in a line.
const MAX_CHARACTERS: usize = 100;

impl Contradictions {
    /// Writes the topics, and how many there are.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for (number, topic) in (1..).zip(&self.topics) {
            topic.write(number, out)?;
        }
        let topics = counted(self.number as u64, "contradiction", "contradictions");
        let questions = counted(self.questions as u64, "question", "questions");
        match self.topics.len() {
            all if all == self.number => writeln!(out, "{topics} on {questions}."),
            shown => writeln!(
                out,
                "{topics} on {questions}; the {shown} largest are shown, --all shows all."
            ),
        }
    }
}

impl Topic {
    fn write(&self, number: usize, out: &mut dyn Write) -> io::Result<()> {
        let answers = counted(self.answers.len() as u64, "answer", "answers");
        let systems = counted(self.systems as u64, "system", "systems");
        writeln!(out, "{number}. {}", shortened(&self.question, MAX_CHARACTERS))?;
        write!(out, "   {}: {answers}, {systems}", self.kind)?;
        if let [first, ..] = &self.others[..] {
            let first = shortened(first, MAX_CHARACTERS);
            write!(
                out,
                "; the same sides on {} more, such as {first}",
                self.questions - 1
            )?;
        }
        writeln!(out)?;
        if let (Some(case), Some(_)) = (&self.case, &self.program) {
            writeln!(out, "   stickler show '{case}'")?;
        }
        for (answer, by) in &self.answers {
            writeln!(out, "   {}", shortened(answer, MAX_CHARACTERS))?;
            for origin in by {
                write!(out, "      {}: {} ", origin.system, origin.source)?;
                writeln!(
                    out,
                    "({}; {})\n        {}",
                    origin.kind, origin.read, origin.address
                )?;
            }
        }
        writeln!(out)
    }
}
