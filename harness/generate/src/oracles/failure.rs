//! The result of an oracle for one input.

use std::fmt;

/// The result for an input that broke no promise.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InputOutcome {
    /// The input was checked against everything that the oracle knows.
    Checked,
    /// The input cannot be judged, for this reason, such as `too short` or `poisoned`.
    Skipped(&'static str),
}

/// The way in which an input broke a promise.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OracleFailure {
    /// The kind of the failure, by which findings are grouped: short, and the same for every input that fails in this way,
    /// such as `internal-error`, `value:INT`, `rejected:P4035`. It contains nothing that changes when an input is reduced.
    pub symptom: String,
    /// The message for a person: the expected result, the actual one, and the place.
    pub message: String,
    /// The program, if the input encodes one.
    pub program: Option<String>,
}

/// What an oracle says of an input, or of a part of it.
pub type Judged<T = InputOutcome> = Result<T, OracleFailure>;

/// Returns a failure without a program.
///
/// # Errors
/// The failure.
pub(super) fn failed<T>(symptom: impl Into<String>, message: impl Into<String>) -> Judged<T> {
    Err(OracleFailure::new(symptom, message))
}

impl OracleFailure {
    /// Creates a failure without a program; [`OracleFailure::of_program`] adds one.
    #[must_use]
    pub fn new(symptom: impl Into<String>, message: impl Into<String>) -> OracleFailure {
        OracleFailure {
            symptom: symptom.into(),
            message: message.into(),
            program: None,
        }
    }

    /// Adds the program that shows the failure.
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
