//! The verdict on a case.

use serde::{Deserialize, Serialize};
use stickler_types::words;

words! {
    /// The verdict on the result of a case on an engine. Basis: reports/README.md (the words).
    #[derive(Default, Serialize, Deserialize)]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[serde(rename_all = "lowercase")]
    Verdict {
        /// The engine met the expectation.
        #[default]
        Pass = "pass",
        /// The engine did not meet an expectation that binds it.
        Fail = "fail",
        /// The engine did not meet an expectation that does not bind it: it comes from a rule of Stickler, or from a source that
        /// speaks for other engines.
        Differs = "differs",
        /// The case did not pass, as a baseline expects.
        Xfail = "xfail",
        /// The case passed, although a baseline expects that it does not.
        Xpass = "xpass",
        /// The engine states that it does not support what the case needs.
        Unsupported = "unsupported",
        /// The case says nothing of the engine, which lacks a feature of the language that the program uses.
        Waiting = "waiting",
        /// The engine crashed or panicked.
        Crash = "crash",
        /// The engine gave no answer in time.
        Timeout = "timeout",
        /// The engine did not understand a request, or its answer is invalid.
        Error = "error",
    }
}

impl Verdict {
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
