//! The verdict on a case.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The verdict on the result of a case on an engine. Basis: reports/README.md (the words).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The engine met the expectation.
    #[default]
    Pass,
    /// The engine did not meet an expectation that binds it.
    Fail,
    /// The engine did not meet an expectation that does not bind it: it comes from a rule of Stickler, or from a source that
    /// speaks for other engines.
    Differs,
    /// The case did not pass, as a baseline expects.
    Xfail,
    /// The case passed, although a baseline expects that it does not.
    Xpass,
    /// The engine states that it does not support what the case needs.
    Unsupported,
    /// The case says nothing of the engine, which lacks a feature of the language that the program uses.
    Waiting,
    /// The engine crashed or panicked.
    Crash,
    /// The engine gave no answer in time.
    Timeout,
    /// The engine did not understand a request, or its answer is invalid.
    Error,
}

impl Verdict {
    /// Every verdict, in the order in which reports count them.
    pub const ALL: [Verdict; 10] = [
        Verdict::Pass,
        Verdict::Fail,
        Verdict::Differs,
        Verdict::Xfail,
        Verdict::Xpass,
        Verdict::Unsupported,
        Verdict::Waiting,
        Verdict::Crash,
        Verdict::Timeout,
        Verdict::Error,
    ];

    /// Returns the word that reports use, such as `pass`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Verdict::Pass => "pass",
            Verdict::Fail => "fail",
            Verdict::Differs => "differs",
            Verdict::Xfail => "xfail",
            Verdict::Xpass => "xpass",
            Verdict::Unsupported => "unsupported",
            Verdict::Waiting => "waiting",
            Verdict::Crash => "crash",
            Verdict::Timeout => "timeout",
            Verdict::Error => "error",
        }
    }

    /// Joins alternative verdicts for people: `fail or crash`.
    #[must_use]
    pub fn any_of(verdicts: &[Verdict]) -> String {
        let words: Vec<&str> = verdicts.iter().map(|verdict| verdict.as_str()).collect();
        words.join(" or ")
    }

    /// Returns whether a run with this verdict in it is still as expected. An unexpected pass is not: its baseline is stale.
    #[must_use]
    pub const fn is_as_expected(self) -> bool {
        matches!(
            self,
            Verdict::Pass | Verdict::Differs | Verdict::Xfail | Verdict::Unsupported | Verdict::Waiting
        )
    }

    /// Returns whether the engine did something else than the case expects. An engine that does not support a case did nothing.
    #[must_use]
    pub const fn is_discrepancy(self) -> bool {
        matches!(
            self,
            Verdict::Fail
                | Verdict::Differs
                | Verdict::Xfail
                | Verdict::Crash
                | Verdict::Timeout
                | Verdict::Error
        )
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_have_one_spelling() {
        for verdict in Verdict::ALL {
            assert_eq!(serde_json::to_string(&verdict).unwrap(), format!("\"{verdict}\""));
        }
    }
}
