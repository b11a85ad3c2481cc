//! The fuzz targets: their names, and the single entry point through which libFuzzer, replays, tests and campaigns judge an
//! input.

use super::{case_file, check, convert, execute, literal, parse, protocol};
use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_types::words;

words! {
    /// A question that random input is judged by. Its word names it on the command line, the folder of its corpus, and its binary in
    /// the fuzz crate.
    FuzzTarget {
        /// The input is a source text: reading it neither fails nor hangs, and a readable text keeps its tree when it is
        /// rendered.
        Parse = "parse",
        /// The input is a literal: its canonical spelling reads to the same value, which an independent reader finds too.
        Literal = "literal",
        /// The input encodes a function, operands and a dialect: the reference agrees with exact arithmetic.
        Convert = "convert",
        /// The input encodes a program with one planted error: the diagnostic has the planted code and line, and nothing else is
        /// reported.
        Check = "check",
        /// The input encodes a well-typed program: it is accepted and terminates, and it and its variants give the values of the
        /// evaluator.
        Execute = "execute",
        /// The input is a case file: its reader returns cases or located errors.
        CaseFile = "case_file",
        /// The input is the traffic of the wire protocol: every line is answered.
        Protocol = "protocol",
    }
}

impl FuzzTarget {
    /// Judges one input; any bytes are an input.
    ///
    /// # Errors
    /// The way in which the input broke a promise of the target. A panic is such a failure, with the symptom `panic`; under
    /// libFuzzer the process ends before the failure is returned.
    #[inline(always)]
    pub fn judge(self, data: &[u8]) -> Result<InputOutcome, OracleFailure> {
        let oracle = self.oracle();
        // An oracle keeps nothing between inputs, so there is nothing that a panic could leave broken.
        catch_unwind(AssertUnwindSafe(|| oracle(data))).unwrap_or_else(|panic| Err(panicked(&*panic)))
    }

    /// Returns the function that judges. It is always inlined, so that a fuzz target links its own oracle alone: libFuzzer
    /// goes through the counters of all linked code after every input.
    #[inline(always)]
    const fn oracle(self) -> fn(&[u8]) -> Result<InputOutcome, OracleFailure> {
        match self {
            FuzzTarget::Parse => parse::judge,
            FuzzTarget::Literal => literal::judge,
            FuzzTarget::Convert => convert::judge,
            FuzzTarget::Check => check::check,
            FuzzTarget::Execute => execute::execute,
            FuzzTarget::CaseFile => case_file::judge,
            FuzzTarget::Protocol => protocol::judge,
        }
    }
}

fn panicked(payload: &(dyn Any + Send)) -> OracleFailure {
    let text = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    OracleFailure::new("panic", text.unwrap_or("a panic with no message"))
}

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

/// The verdict of an oracle on an input, or on a part of it.
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
    pub fn new(symptom: impl Into<String>, message: impl Into<String>) -> OracleFailure {
        OracleFailure {
            symptom: symptom.into(),
            message: message.into(),
            program: None,
        }
    }

    /// Adds the program that shows the failure.
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
        self.program
            .as_ref()
            .map_or(Ok(()), |program| write!(f, "\n{program}"))
    }
}

impl std::error::Error for OracleFailure {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_failure_with_its_message() {
        assert_eq!(panicked(&"broken"), OracleFailure::new("panic", "broken"));
        assert_eq!(
            panicked(&"broken 7".to_owned()),
            OracleFailure::new("panic", "broken 7")
        );
        assert_eq!(panicked(&7).message, "a panic with no message");
    }
}
