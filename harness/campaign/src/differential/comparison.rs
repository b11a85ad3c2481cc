//! Comparing what an engine did with what the evaluator gives.

use stickler_engines::Outcome;
use stickler_generate::reduce::deviation;
use stickler_types::{DialectName, Value};

/// A program that an engine is asked to run, with the values that it must give.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JudgedProgram<'a> {
    /// The dialect of the program.
    pub(crate) dialect: DialectName,
    /// The text of the program.
    pub(crate) text: &'a str,
    /// The variables that are observed at the end of one scan, with the values that they must have.
    pub(crate) values: &'a [(String, Value)],
    /// Whether an engine must accept the program and give these values. Where something happens that no document settles, it need
    /// not.
    pub(crate) binds: bool,
}

/// The result of a comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Agreement {
    /// The engine did what it must.
    Agrees,
    /// The engine says that it cannot do this.
    Unsupported,
    /// The engine did something else than it must.
    Disagrees {
        /// The text of an [`OutcomeSymptom`](stickler_generate::reduce::OutcomeSymptom), which stays the same when the program is
        /// made smaller.
        symptom: String,
        /// A message for a person.
        message: String,
    },
}

impl Agreement {
    /// Returns the symptom of a disagreement.
    pub(crate) fn symptom(&self) -> Option<&str> {
        match self {
            Agreement::Disagrees { symptom, .. } => Some(symptom),
            Agreement::Agrees | Agreement::Unsupported => None,
        }
    }
}

/// Compares an outcome with what was asked. Where an engine is not bound, only what no program excuses counts: to die, to
/// hang, to answer nonsense.
pub(crate) fn compare(question: JudgedProgram<'_>, outcome: &Outcome) -> Agreement {
    match outcome {
        Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => Agreement::Unsupported,
        Outcome::Executed { .. } | Outcome::Rejected { .. } | Outcome::Faulted { .. } if !question.binds => {
            Agreement::Agrees
        }
        _ => match deviation(question.values, outcome) {
            None => Agreement::Agrees,
            Some((symptom, message)) => Agreement::Disagrees {
                symptom: symptom.to_string(),
                message,
            },
        },
    }
}
