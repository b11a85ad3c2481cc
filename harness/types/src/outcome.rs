//! The answers of engines: the outcome of a request.

use crate::{Code, Fault, Value};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A value with the name under which it was requested (`q`, `a[1]`, `q@3`; see
/// [`Observation::key`](crate::Observation::key)).
pub type NamedValue = (String, Value);

/// The outcome of a request to an engine. Crashing is not rejecting.
#[derive(Clone, PartialEq, Debug)]
pub enum Outcome {
    /// The program was accepted; nothing was executed.
    Accepted,
    /// The program ran to the end of its last scan.
    Executed {
        /// The observed values, in the order asked for.
        values: Vec<NamedValue>,
    },
    /// The program was rejected.
    Rejected {
        /// The diagnostics, sorted by line, column and code.
        diagnostics: Vec<Diagnostic>,
    },
    /// The program was accepted and stopped at a run-time fault.
    Faulted {
        /// The kind of fault.
        fault: Fault,
        /// The line (from 1), if the engine reports it.
        line: Option<u32>,
        /// The values observed so far.
        values: Vec<NamedValue>,
    },
    /// The program was rendered as normalised source.
    Rendered {
        /// The whole source.
        text: String,
    },
    /// The engine does not support this request, and reports that.
    Unsupported {
        /// The reason, as a fragment.
        reason: String,
    },
    /// The compiler reports that it does not implement a construct of the program.
    NotImplemented {
        /// The compiler's own message, as a fragment.
        reason: String,
    },
    /// The program was accepted, and what the compiler made of it is of no use: it cannot be built, or it dies when it runs.
    Unusable {
        /// The reason why the result is of no use, as a fragment: `the C that it wrote cannot be built: …`.
        reason: String,
    },
    /// The engine died, or panicked.
    Crashed {
        /// The known circumstances, as a fragment.
        reason: String,
    },
    /// The engine did not answer in time.
    TimedOut {
        /// The time that the harness waited, in milliseconds.
        after_ms: u64,
    },
    /// The engine did not understand the request, or its answer is not valid.
    Error {
        /// A description of the error, as a fragment.
        message: String,
    },
}

impl Outcome {
    /// Formats a time limit for messages: `300 ms`, `60 s`, `1.5 s`.
    #[must_use]
    pub fn limit(milliseconds: u64) -> String {
        match (milliseconds / 1000, milliseconds % 1000) {
            (0, rest) => format!("{rest} ms"),
            (seconds, 0) => format!("{seconds} s"),
            (seconds, rest) => format!("{seconds}.{rest:03}").trim_end_matches('0').to_owned() + " s",
        }
    }
}

impl fmt::Display for Outcome {
    /// Writes the outcome in one line, without values and rendered text: `accepted`, `no answer within 60 s`,
    /// `crashed: panicked: out of memory`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Outcome::Accepted => f.write_str("accepted"),
            Outcome::Executed { .. } => f.write_str("executed"),
            Outcome::Rejected { diagnostics } => match diagnostics.first() {
                Some(first) => write!(f, "rejected: {first}"),
                None => f.write_str("rejected, with no diagnostic"),
            },
            Outcome::Faulted { fault, line, .. } => {
                write!(f, "fault {fault}")?;
                line.map_or(Ok(()), |line| write!(f, " on line {line}"))
            }
            Outcome::Rendered { .. } => f.write_str("rendered"),
            Outcome::Unsupported { reason } => write!(f, "unsupported: {reason}"),
            Outcome::NotImplemented { reason } => write!(f, "not implemented: {reason}"),
            Outcome::Unusable { reason } => write!(f, "accepted, but {reason}"),
            Outcome::Crashed { reason } => write!(f, "crashed: {reason}"),
            Outcome::TimedOut { after_ms } => write!(f, "no answer within {}", Outcome::limit(*after_ms)),
            Outcome::Error { message } => write!(f, "error: {message}"),
        }
    }
}

/// A diagnostic that an engine reports for a program. A foreign engine may report only the message; the reference always
/// reports a registered code and the whole span.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Diagnostic {
    /// A code of Stickler's registry, or the engine's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// The line, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub line: Option<u32>,
    /// The column, from 1, in Unicode scalar values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub column: Option<u32>,
    /// The line on which the span ends, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub end_line: Option<u32>,
    /// The column after the last character of the span.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub end_column: Option<u32>,
    /// A description of the problem, for a person.
    #[serde(default)]
    pub message: String,
    /// A text that replaces exactly the span and makes the program acceptable.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub suggestion: Option<String>,
}

impl Diagnostic {
    /// Returns the code, if the registry has it.
    #[must_use]
    pub fn registered_code(&self) -> Option<Code> {
        self.code.as_deref()?.parse().ok()
    }
}

impl fmt::Display for Diagnostic {
    /// Writes `P4035 on line 6, column 13: …` without the unknown parts; `error` stands in for a missing code.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code.as_deref().unwrap_or("error"))?;
        if let Some(line) = self.line {
            write!(f, " on line {line}")?;
            if let Some(column) = self.column {
                write!(f, ", column {column}")?;
            }
        }
        write!(f, ": {}", self.message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_told_in_seconds_where_there_are_any() {
        for (milliseconds, told) in [
            (0, "0 ms"),
            (300, "300 ms"),
            (1000, "1 s"),
            (1500, "1.5 s"),
            (2050, "2.05 s"),
            (60_000, "60 s"),
        ] {
            assert_eq!(Outcome::limit(milliseconds), told);
        }
    }

    #[test]
    fn outcomes_and_diagnostics_are_described_in_one_line() {
        let first = Diagnostic {
            code: Some("P4035".to_owned()),
            line: Some(6),
            column: Some(13),
            message: "no INT".to_owned(),
            ..Diagnostic::default()
        };
        assert_eq!(first.registered_code(), Some(Code::AssignmentTypeMismatch));
        let rejected = |diagnostics: &[Diagnostic]| Outcome::Rejected {
            diagnostics: diagnostics.to_vec(),
        };
        let nameless = Diagnostic {
            code: None,
            column: None,
            ..first.clone()
        };
        assert_eq!(nameless.registered_code(), None);
        let faulted = Outcome::Faulted {
            fault: Fault::Subrange,
            line: Some(3),
            values: Vec::new(),
        };
        for (outcome, described) in [
            (rejected(&[first]), "rejected: P4035 on line 6, column 13: no INT"),
            (rejected(&[nameless]), "rejected: error on line 6: no INT"),
            (rejected(&[]), "rejected, with no diagnostic"),
            (faulted, "fault subrange on line 3"),
            (Outcome::TimedOut { after_ms: 1500 }, "no answer within 1.5 s"),
        ] {
            assert_eq!(outcome.to_string(), described);
        }
    }
}
