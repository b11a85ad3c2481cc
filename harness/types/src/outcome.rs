//! The answers of engines: the outcome of a request.

use crate::{Diagnostic, Fault, Value};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Whether a program must be accepted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Acceptance {
    /// No error may be given.
    #[default]
    Required,
    /// The program must be rejected with the errors that the expectation lists, at least one, and no others.
    Rejected,
    /// No document decides: whether the program is accepted is recorded, and nothing is asserted.
    #[serde(rename = "open")]
    Observed,
}

/// A value with the name under which it was requested (`q`, `a[1]`, `q@3`; see
/// [`Observation::key`](crate::Observation::key)).
pub type NamedValue = (String, Value);

/// The outcome of a request to an engine. Crashing is not rejecting.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Outcome {
    /// The program was accepted; nothing was executed.
    Accepted {
        /// The warnings, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        warnings: Vec<Diagnostic>,
    },
    /// The program ran to the end of its last scan.
    Executed {
        /// The observed values, in the order asked for.
        values: Vec<NamedValue>,
        /// The warnings of the compiler, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        warnings: Vec<Diagnostic>,
    },
    /// The program was rejected.
    Rejected {
        /// The errors, sorted by line, column and code; the warnings of a rejected program are left out.
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
        /// The warnings of the compiler, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        warnings: Vec<Diagnostic>,
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
    /// The outcome of a program that was accepted without a warning, and not executed.
    pub const ACCEPTED: Outcome = Outcome::Accepted { warnings: Vec::new() };

    /// Returns the outcome of a program that ran to its end and had no warning.
    pub const fn executed(values: Vec<NamedValue>) -> Outcome {
        let warnings = Vec::new();
        Outcome::Executed { values, warnings }
    }

    /// Returns the outcome of a program that was rejected with these diagnostics, of which the errors are kept.
    pub fn rejected(mut diagnostics: Vec<Diagnostic>) -> Outcome {
        diagnostics.retain(Diagnostic::is_error);
        Outcome::Rejected { diagnostics }
    }

    /// Returns the outcome of an engine that crashed, for this reason.
    pub fn crashed(reason: impl Into<String>) -> Outcome {
        let reason = reason.into();
        Outcome::Crashed { reason }
    }

    /// Returns the outcome of checking a program: rejected where a diagnostic is an error, otherwise accepted with the
    /// diagnostics as warnings.
    pub fn of_check(diagnostics: Vec<Diagnostic>) -> Outcome {
        match diagnostics.iter().any(Diagnostic::is_error) {
            true => Outcome::rejected(diagnostics),
            false => Outcome::Accepted {
                warnings: diagnostics,
            },
        }
    }

    /// Returns whether a program and its rendered text ended alike. The lines of faults and errors may differ, since comments are
    /// dropped; and a program that was rejected may have been rendered all the same, so that its text is rejected at whatever place.
    pub fn ends_like(&self, rendered: &Outcome) -> bool {
        use Outcome::{Faulted, Rejected};
        match (self, rendered) {
            (Rejected { .. }, Rejected { .. }) => true,
            (
                Faulted { fault, values, .. },
                Faulted {
                    fault: again,
                    values: same,
                    ..
                },
            ) => (fault, values) == (again, same),
            _ => self == rendered,
        }
    }

    /// Returns the same outcome with these warnings of the compiler, where it is one that has warnings.
    pub fn with_warnings(mut self, of_compiler: Vec<Diagnostic>) -> Outcome {
        if let Outcome::Accepted { warnings }
        | Outcome::Executed { warnings, .. }
        | Outcome::Faulted { warnings, .. } = &mut self
        {
            *warnings = of_compiler;
        }
        self
    }

    /// Returns the warnings of a program that was accepted; `None` where no compiler accepted it.
    pub fn warnings(&self) -> Option<&[Diagnostic]> {
        match self {
            Outcome::Accepted { warnings }
            | Outcome::Executed { warnings, .. }
            | Outcome::Faulted { warnings, .. } => Some(warnings),
            _ => None,
        }
    }

    /// Formats a time limit for messages: `300 ms`, `60 s`, `1.5 s`.
    pub fn limit(milliseconds: u64) -> String {
        match (milliseconds / 1000, milliseconds % 1000) {
            (0, rest) => format!("{rest} ms"),
            (seconds, 0) => format!("{seconds} s"),
            (seconds, rest) => format!("{seconds}.{rest:03}").trim_end_matches('0').to_owned() + " s",
        }
    }
}

impl fmt::Display for Outcome {
    /// Writes the outcome in one line, without values and rendered text: `accepted`, `accepted with 2 warnings`, `no answer
    /// within 60 s`, `crashed: panicked: out of memory`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Outcome::Accepted { warnings } => match warnings.len() {
                0 => f.write_str("accepted"),
                1 => f.write_str("accepted with 1 warning"),
                several => write!(f, "accepted with {several} warnings"),
            },
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, Severity};

    #[test]
    fn a_limit_is_told_in_seconds_where_there_are_any() {
        let reported = [0, 300, 1000, 1500, 2050, 60_000].map(Outcome::limit);
        assert_eq!(reported, ["0 ms", "300 ms", "1 s", "1.5 s", "2.05 s", "60 s"]);
    }

    #[test]
    fn a_program_with_warnings_alone_is_accepted() {
        let warning = || Diagnostic {
            severity: Severity::Warning,
            ..Diagnostic::default()
        };
        let accepted = Outcome::of_check(vec![warning(), warning()]);
        assert_eq!(accepted.to_string(), "accepted with 2 warnings");
        assert_eq!(accepted.warnings().map(<[_]>::len), Some(2));
        let rejected = Outcome::of_check(vec![warning(), Diagnostic::default()]);
        let diagnostics = vec![Diagnostic::default()];
        assert_eq!(rejected, Outcome::Rejected { diagnostics });
        assert_eq!(Outcome::of_check(Vec::new()), Outcome::ACCEPTED);
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
        let rejected = |diagnostics: Vec<Diagnostic>| Outcome::Rejected { diagnostics };
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
            warnings: Vec::new(),
        };
        for (outcome, described) in [
            (
                rejected(vec![first]),
                "rejected: P4035 on line 6, column 13: no INT",
            ),
            (rejected(vec![nameless]), "rejected: error on line 6: no INT"),
            (rejected(Vec::new()), "rejected, with no diagnostic"),
            (faulted, "fault subrange on line 3"),
            (Outcome::TimedOut { after_ms: 1500 }, "no answer within 1.5 s"),
        ] {
            assert_eq!(outcome.to_string(), described);
        }
    }
}
