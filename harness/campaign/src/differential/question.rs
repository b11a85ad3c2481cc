//! A program with the values that it must give, and how what an engine did with it compares with them.

use stickler_engines::Outcome;
use stickler_generate::evaluate::{Evaluation, EvaluationError, OpenPoint, evaluate};
use stickler_generate::model::Program;
use stickler_generate::reduce::deviation;
use stickler_generate::writer::{Style, write};
use stickler_types::{DialectName, Value};

/// A program, its text, and what it must give.
pub(crate) struct EvaluatedProgram {
    /// The text.
    pub(crate) text: String,
    /// The program.
    pub(crate) program: Program,
    /// The values at the end of one scan.
    pub(crate) values: Vec<(String, Value)>,
    /// The events that no document settles. Where there is one, an engine may give other values.
    pub(crate) opened: Vec<OpenPoint>,
    /// Whether the reference must give these values even where no document settles them.
    pub(crate) binds_the_reference: bool,
}

impl EvaluatedProgram {
    /// Evaluates and writes a program.
    ///
    /// # Errors
    /// The reason for which nothing can be asked about the program, the same words for all programs of a kind.
    pub(crate) fn new(program: Program) -> Result<EvaluatedProgram, &'static str> {
        let evaluation = evaluate(&program, 1).map_err(word)?;
        let binds_the_reference = evaluation.binds_the_reference();
        let Evaluation { values, opened, .. } = evaluation;
        let text = write(&program, &Style::default()).text;
        Ok(EvaluatedProgram {
            text,
            program,
            values,
            opened,
            binds_the_reference,
        })
    }

    /// Returns the question that an engine is asked about the program.
    pub(crate) fn question(&self, is_reference: bool) -> JudgedProgram<'_> {
        JudgedProgram {
            dialect: self.program.dialect,
            text: &self.text,
            values: &self.values,
            binds: self.opened.is_empty() || (is_reference && self.binds_the_reference),
        }
    }
}

const fn word(refusal: EvaluationError) -> &'static str {
    match refusal {
        EvaluationError::Fault(_) => "stops with a fault",
        EvaluationError::StepLimit => "takes too long",
        EvaluationError::Raw | EvaluationError::IllFormed(_) => "the generator made no program",
    }
}

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
