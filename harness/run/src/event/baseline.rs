//! What the events of a run say of baselines.

use super::Verdict;
use serde::{Deserialize, Serialize};

/// A baseline that takes part in a run.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct BaselineHeader {
    /// The engine whose it is.
    pub engine: String,
    /// The file.
    pub file: String,
    /// How many entries it has.
    pub entries: u64,
    /// Those that are out of date; a run with any of them is not as expected.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outdated: Vec<OutdatedEntry>,
}

/// An entry of a baseline that no longer says anything true.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct OutdatedEntry {
    /// Where it stands: file and line.
    pub at: String,
    /// The case or the pattern.
    pub case: String,
    /// What is wrong with it, as a fragment: it fits no case, or its day is past.
    pub why: String,
}

/// What a baseline says of a case.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct BaselineNote {
    /// Where it says so: file and line.
    pub at: String,
    /// The verdict that it expects. Where the case's own is [`Verdict::Xfail`], this is what came of it.
    pub verdict: Verdict,
    /// What else it expects, of a compiler that does not do the same each time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Verdict>,
    /// Why.
    pub reason: String,
    /// Where more is written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
}

impl BaselineNote {
    /// All that it expects.
    #[must_use]
    pub fn verdicts(&self) -> Vec<Verdict> {
        [&[self.verdict], &self.others[..]].concat()
    }

    /// The note of a case of which this came, which is among what it expects.
    #[must_use]
    pub(crate) fn of_xfail(&self, came: Verdict) -> BaselineNote {
        let mut others = self.verdicts();
        others.retain(|verdict| *verdict != came);
        BaselineNote {
            verdict: came,
            others,
            ..self.clone()
        }
    }
}
