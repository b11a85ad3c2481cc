//! What an engine did with a program.

use stickler_types::{Fault, Value};

/// A value under the name by which it was asked for (`q`, `a[1]`, `q@3`).
pub type NamedValue = (String, Value);

/// What an engine did with a program. Crashing is not rejecting (design, section 2, rule 3).
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
        /// Why, sorted by line, column, code.
        diagnostics: Vec<Diagnostic>,
    },
    /// The program was accepted and stopped at a run-time fault.
    Faulted {
        /// What kind of fault.
        fault: Fault,
        /// The line (from 1), where the engine tells it.
        line: Option<u32>,
        /// The values observed so far.
        values: Vec<NamedValue>,
    },
    /// The program as normalised source.
    Rendered {
        /// The whole source.
        text: String,
    },
    /// The engine cannot answer this request, and says so.
    Unsupported {
        /// Why, as a fragment.
        reason: String,
    },
    /// The engine died, or panicked.
    Crashed {
        /// What is known about it, as a fragment.
        reason: String,
    },
    /// The engine did not answer in time.
    TimedOut {
        /// How long it was waited for, in milliseconds.
        after_ms: u64,
    },
    /// The engine did not understand the request, or answered nonsense.
    Error {
        /// What went wrong, as a fragment.
        message: String,
    },
}

impl Outcome {
    /// A limit of time as messages tell it: `300 ms`, `60 s`, `1.5 s`.
    #[must_use]
    pub fn limit(milliseconds: u64) -> String {
        match (milliseconds / 1000, milliseconds % 1000) {
            (0, rest) => format!("{rest} ms"),
            (seconds, 0) => format!("{seconds} s"),
            (seconds, rest) => format!("{seconds}.{rest:03}").trim_end_matches('0').to_owned() + " s",
        }
    }
}

/// Something that an engine finds wrong with a program. Only the message is sure to be there in a foreign
/// engine's answer.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Diagnostic {
    /// A code of the registry where the engine or its adapter has one, otherwise the engine's own.
    pub code: Option<String>,
    /// The line, from 1.
    pub line: Option<u32>,
    /// The column, from 1, in Unicode scalar values.
    pub column: Option<u32>,
    /// The line on which it ends.
    pub end_line: Option<u32>,
    /// The column after its last character.
    pub end_column: Option<u32>,
    /// What is wrong, for a person.
    pub message: String,
    /// Text that replaces exactly the span and makes the program acceptable.
    pub suggestion: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::Outcome;

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
}
