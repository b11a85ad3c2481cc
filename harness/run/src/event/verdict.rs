//! What came of a case, and how exactly.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// What came of a case on an engine. Basis: design, section 1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// All that was expected happened, and nothing else.
    Pass,
    /// Something else happened.
    Fail,
    /// It failed, and a baseline says so.
    Xfail,
    /// It passed, and a baseline says that it fails.
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

/// How exactly a rejection or a fault was right, the best first. Basis: design, section 6.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Grade {
    /// The right codes on the right lines, and no others.
    #[default]
    Code,
    /// The right lines, and no others.
    Line,
    /// Rejected, the place unknown or wrong.
    Rejected,
}

impl Grade {
    /// The word for it, such as `code`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Grade::Code => "code",
            Grade::Line => "line",
            Grade::Rejected => "rejected",
        }
    }

    /// Whether this grade is as good as `needed`, or better.
    #[must_use]
    pub fn suffices(self, needed: Grade) -> bool {
        self <= needed
    }
}

impl fmt::Display for Grade {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.as_str())
    }
}

impl FromStr for Grade {
    type Err = String;

    /// Reads `code`, `line` or `rejected`; the error lists them.
    fn from_str(text: &str) -> Result<Grade, String> {
        match text {
            "code" => Ok(Grade::Code),
            "line" => Ok(Grade::Line),
            "rejected" => Ok(Grade::Rejected),
            _ => Err(format!(
                "unknown grade `{text}`; the grades are `code`, `line` and `rejected`"
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_better_grade_suffices_where_a_worse_one_is_needed_and_not_the_other_way_round() {
        assert!(Grade::Code.suffices(Grade::Rejected));
        assert!(Grade::Line.suffices(Grade::Line));
        assert!(!Grade::Rejected.suffices(Grade::Line));
    }

    #[test]
    fn verdicts_and_grades_have_one_spelling() {
        for verdict in Verdict::ALL {
            assert_eq!(serde_json::to_string(&verdict).unwrap(), format!("\"{verdict}\""));
        }
        for grade in [Grade::Code, Grade::Line, Grade::Rejected] {
            assert_eq!(serde_json::to_string(&grade).unwrap(), format!("\"{grade}\""));
            assert_eq!(grade.to_string().parse(), Ok(grade));
        }
    }
}
