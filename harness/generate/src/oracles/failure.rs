//! What an oracle says of one input: that it was tried, or how it failed.

use std::fmt;

/// What became of an input that broke nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InputOutcome {
    /// The input was held against everything that the oracle knows.
    Checked,
    /// The input asked nothing that can be judged; the word says why, such as `too short` or `poisoned`.
    Skipped(&'static str),
}

/// How an input broke what an oracle holds it to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OracleFailure {
    /// What kind of failure this is, by which findings are told apart: short, the same for every input that fails in this way,
    /// such as `internal-error`, `value:INT`, `rejected:P4035`. It holds nothing that changes when an input is reduced.
    pub symptom: String,
    /// What happened, for a person: what was expected, what came, and where.
    pub message: String,
    /// The program, where the input stands for one.
    pub program: Option<String>,
}

impl OracleFailure {
    /// A failure of an input that stands for no program, or whose program is added by [`OracleFailure::of_program`].
    #[must_use]
    pub fn new(symptom: impl Into<String>, message: impl Into<String>) -> OracleFailure {
        OracleFailure {
            symptom: symptom.into(),
            message: message.into(),
            program: None,
        }
    }

    /// The same failure, which this program shows.
    #[must_use]
    pub fn of_program(self, program: impl Into<String>) -> OracleFailure {
        OracleFailure {
            program: Some(program.into()),
            ..self
        }
    }
}

impl fmt::Display for OracleFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.symptom, self.message)?;
        match &self.program {
            Some(program) => write!(f, "\n{program}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for OracleFailure {}
