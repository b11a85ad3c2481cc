//! What came of a case.

use serde::{Deserialize, Serialize};
use std::fmt;

/// What came of a case on an engine. Basis: design, section 1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// All that was expected happened, and nothing else.
    #[default]
    Pass,
    /// Something else happened.
    Fail,
    /// It did not pass, and a baseline says so.
    Xfail,
    /// It passed, and a baseline says that it does not.
    Xpass,
    /// The engine says that it cannot do this.
    Unsupported,
    /// The engine died or panicked.
    Crash,
    /// The engine gave no answer in time.
    Timeout,
    /// The engine did not understand, or answered nonsense.
    Error,
}

impl Verdict {
    /// Every verdict, in the order in which reports count them.
    pub const ALL: [Verdict; 8] = [
        Verdict::Pass,
        Verdict::Fail,
        Verdict::Xfail,
        Verdict::Xpass,
        Verdict::Unsupported,
        Verdict::Crash,
        Verdict::Timeout,
        Verdict::Error,
    ];

    /// The word that reports use, such as `pass`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Verdict::Pass => "pass",
            Verdict::Fail => "fail",
            Verdict::Xfail => "xfail",
            Verdict::Xpass => "xpass",
            Verdict::Unsupported => "unsupported",
            Verdict::Crash => "crash",
            Verdict::Timeout => "timeout",
            Verdict::Error => "error",
        }
    }

    /// Several, as a person is told that any of them may come: `fail or crash`.
    #[must_use]
    pub fn any_of(verdicts: &[Verdict]) -> String {
        let words: Vec<&str> = verdicts.iter().map(|verdict| verdict.as_str()).collect();
        words.join(" or ")
    }

    /// Whether a run with this verdict in it is still as expected. An unexpected pass is not: its baseline is
    /// stale.
    #[must_use]
    pub const fn is_as_expected(self) -> bool {
        matches!(self, Verdict::Pass | Verdict::Xfail | Verdict::Unsupported)
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
