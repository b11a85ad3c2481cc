//! The parts of events that concern baselines.

use super::Verdict;
use serde::{Deserialize, Serialize};

/// A baseline that takes part in a run.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BaselineHeader {
    /// The name of the engine that the baseline is for.
    pub engine: String,
    /// The path of the file, as messages show it.
    pub file: String,
    /// The number of entries.
    pub entries: u64,
    /// The entries that are out of date; a run with any of them is not as expected.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outdated: Vec<OutdatedEntry>,
}

/// An entry of a baseline that no longer applies to anything.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OutdatedEntry {
    /// The file and line of the entry.
    pub at: String,
    /// The id or the pattern of the entry.
    pub case: String,
    /// The reason why the entry is out of date, as a fragment: it fits no case, or its last day is past.
    pub why: String,
}

/// The note of a baseline on a case.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BaselineNote {
    /// The file and line of the entry.
    pub at: String,
    /// The verdict that the entry expects. For a case whose verdict is [`Verdict::Xfail`], the actual verdict.
    pub verdict: Verdict,
    /// The alternative verdicts that the entry expects, for a compiler whose answer varies from run to run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Verdict>,
    /// The reason that the entry states.
    pub reason: String,
    /// The address of further information, where the entry has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
}

impl BaselineNote {
    /// Returns all verdicts that the entry expects.
    #[must_use]
    pub fn verdicts(&self) -> Vec<Verdict> {
        [&[self.verdict], &self.others[..]].concat()
    }

    /// Returns the note for a case with this actual verdict, which is one of the expected ones.
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
