//! The statements of documents about conversions: which types convert implicitly, which bits and parts of a type have a name,
//! and what the functions give for boundary values and for the values of the cases of a run.
//!
//! Programs that show conversions, such as the page of a run, read them as one table, in which a word stands once and
//! everything else is a number.

mod builder;
mod curve;

use super::recorded::{QuestionNumber, RecordedAnswers};
use crate::contradictions::Contradictions;
pub use builder::{StatedFunction, StatementsBuilder};
use curve::Curve;
use serde::{Serialize, Serializer};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;
use stickler_types::{DialectName, MatrixWord, PrintedResult, Value};

/// The statements of documents about conversions, and which case of a run asks which question.
#[derive(Default, Serialize)]
pub struct Statements {
    dialects: Vec<&'static str>,
    /// The names of the systems of these dialects, for people.
    titles: Vec<&'static str>,
    words: Vec<String>,
    /// The pairs of types.
    pairs: Vec<Accepted>,
    /// The types with the bits and parts that programs take out of them.
    parts: Vec<Accepted>,
    functions: Vec<FunctionStatements>,
    /// The calls of all functions, one function after the other.
    calls: CallStatements,
    /// The bases of calls, which most have in common: by the dialects of the function, the number of a word; `null` where no
    /// document states the result.
    bases: Vec<Vec<Option<u32>>>,
    /// The calls of which a vendor's page states another value than was recorded: the number of the call, the index of the dialect
    /// among all, the word of that value and the word of its basis.
    disputed: Vec<(usize, usize, u32, u32)>,
    /// What sources print of calls that no case makes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub printed: Vec<PrintedResult>,
    /// Where sources contradict each other.
    pub contradictions: Contradictions,
    /// The number of the question of each case that asks one, by the id of the case.
    #[serde(skip)]
    questions: HashMap<Arc<str>, QuestionNumber>,
    /// The answers of recordings, by recording and dialect.
    #[serde(skip)]
    recorded: Vec<RecordedAnswers>,
}

/// A statement of documents about two words, such as a pair of types: whether a program with them is accepted.
#[derive(Serialize)]
struct Accepted {
    from: u32,
    to: u32,
    /// By dialect, the word of the documents and the basis; `null` where none speaks of it.
    #[serde(serialize_with = "stated_words")]
    stated: Vec<Option<(MatrixWord, u32)>>,
}

fn stated_words<S: Serializer>(
    stated: &[Option<(MatrixWord, u32)>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        stated
            .iter()
            .map(|one| one.map(|(word, basis)| (word.as_str(), basis))),
    )
}

/// A function with the types of one of its signatures.
#[derive(Serialize)]
struct FunctionStatements {
    name: u32,
    operands: Vec<u32>,
    result: u32,
    /// The indices of the dialects that have the function with these types.
    dialects: Vec<usize>,
    /// The number of its calls, boundary values first.
    calls: usize,
    /// The number of its boundary values.
    boundaries: usize,
    /// The samples of a function that its pictures are drawn from; none where a table shows as much.
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<Curve>,
}

/// The calls, each property a list with an element for each call.
#[derive(Default, Serialize)]
struct CallStatements {
    /// The words of the operands.
    operands: Vec<Vec<u32>>,
    /// The index of the bases.
    bases: Vec<usize>,
    /// The words of the stated values: one where all dialects with a basis state the same, otherwise one for each of them.
    values: Vec<Vec<u32>>,
}

/// The answer that a case expects to the question that it asks.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CaseStatement<'c> {
    /// The id of the case.
    pub case: &'c Arc<str>,
    /// The dialect.
    pub dialect: DialectName,
    /// Whether the program must be accepted.
    pub word: MatrixWord,
    /// The value that the case asserts, if it asserts exactly one.
    pub result: Option<&'c Value>,
    /// The source and section that the case cites.
    pub basis: &'c Arc<str>,
}

impl Statements {
    /// Returns the number of the question that a case asks, by its id; `None` for a case that asks another.
    pub fn question(&self, case: &str) -> Option<QuestionNumber> {
        self.questions.get(case).copied()
    }

    /// Returns the answers of recordings to the questions, by recording and dialect.
    pub fn recorded(&self) -> &[RecordedAnswers] {
        &self.recorded
    }

    /// Returns the names of the functions, such as `REAL_TO_INT`.
    pub fn function_names(&self) -> BTreeSet<&str> {
        self.functions
            .iter()
            .map(|function| self.word(function.name))
            .collect()
    }

    /// Returns the name of the function of whose call a question is; `None` where it is of another thing.
    pub fn function_of(&self, question: QuestionNumber) -> Option<&str> {
        let mut call = (question as usize).checked_sub(self.pairs.len() + self.parts.len())?;
        let function = self.functions.iter().find(|function| {
            let is_here = call < function.calls;
            call = if is_here { call } else { call - function.calls };
            is_here
        })?;
        Some(self.word(function.name))
    }

    fn word(&self, number: u32) -> &str {
        &self.words[number as usize]
    }

    /// Returns whether there is no question.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.parts.is_empty() && self.functions.is_empty()
    }
}
