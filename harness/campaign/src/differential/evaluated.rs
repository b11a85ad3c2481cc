//! A program with all that is needed to ask an engine about it.

use super::comparison::JudgedProgram;
use stickler_generate::evaluate::{Evaluation, EvaluationError, OpenPoint, evaluate};
use stickler_generate::model::Program;
use stickler_generate::writer::{Style, write};
use stickler_types::Value;

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
