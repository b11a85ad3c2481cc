//! Baselines: the known deviations of an engine from its documents, each with its reason, so that a run fails only by new
//! ones. Basis: reports/README.md (baselines).
//!
//! A baseline changes no expectation and no claim: an expected failure still counts as failed for its document. Outdated
//! entries are reported: an unexpected pass, an entry that fits no case and one past its last day each fail the run.

mod bless;
mod fold;
mod matched;
mod owned;
mod read;
mod write;

pub use bless::{Blessing, ChangeKind, EngineRun, EntryChange, bless};
pub use matched::MatchedBaseline;
pub use read::BaselineError;

use crate::{Filter, Verdict};
use jiff::civil::Date;
use semver::VersionReq;
use stickler_suite::Suite;
use stickler_types::DialectName;

/// The baseline of one engine, as its file states it.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    /// The name of the engine.
    pub engine: String,
    /// The path of the file, as messages show it.
    pub file: String,
    /// The entries, in the order of the file.
    pub entries: Vec<Entry>,
}

/// An entry of a baseline: cases with known verdicts, and the reason.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The cases that the entry is about, one or several: ids, and patterns in which `*` stands for any text; either may end in
    /// `@dialect`.
    pub cases: Vec<Filter>,
    /// The expected verdicts: one that is no pass; or several alternatives, for a compiler whose answer varies from run to
    /// run.
    pub verdicts: Vec<Verdict>,
    /// The reason, for people.
    pub reason: String,
    /// The address of further information, such as the report in the compiler's tracker.
    pub link: Option<String>,
    /// The versions of the engine to which the entry applies; `None` stands for all.
    pub versions: Option<VersionReq>,
    /// The last day on which the entry applies; `None` where it has no end.
    pub until: Option<Date>,
    /// The line of the file on which the entry begins.
    pub line: u32,
}

impl Baseline {
    /// Returns the name of the file in which the baseline of an engine is looked up. An engine behind a process chooses its
    /// own name, so every character that could lead to another folder becomes `-`.
    #[must_use]
    pub fn file_name(engine: &str) -> String {
        let harmless = |character: char| match character {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' | '.' => character,
            _ => '-',
        };
        let stem: String = engine.chars().map(harmless).collect();
        format!("{stem}.toml")
    }

    /// Returns the file and line of an entry, such as `reports/baselines/ironplc.toml:12`.
    #[must_use]
    pub fn place(&self, entry: &Entry) -> String {
        format!("{}:{}", self.file, entry.line)
    }
}

impl Entry {
    /// Returns whether the entry is about a custom dialect of which this suite has no cases. The cases of a custom dialect
    /// are there only in a run that asks for it, so the entry cannot be checked.
    fn is_beside(&self, suite: &Suite) -> bool {
        let is_beside = |dialect: DialectName| {
            dialect.is_custom() && !suite.cases.iter().any(|case| case.dialect == dialect)
        };
        let dialects = self.cases.iter().filter_map(Filter::dialect);
        dialects.into_iter().any(is_beside)
    }

    /// Returns the first id or pattern of the entry, and the number of the others.
    fn shown(&self) -> String {
        shown(self.cases.iter().map(Filter::as_str))
    }

    /// Returns whether the entry expects this verdict.
    fn expects(&self, verdict: Verdict) -> bool {
        self.verdicts.contains(&verdict)
    }
}

/// Returns the first of several ids and patterns, and the number of the others.
fn shown<'t>(cases: impl Iterator<Item = &'t str>) -> String {
    let mut cases = cases;
    let first = cases.next().unwrap_or_default();
    match cases.count() {
        0 => first.to_owned(),
        more => format!("{first} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::Baseline;

    #[test]
    fn the_file_of_a_baseline_stands_where_baselines_stand_whatever_an_engine_calls_itself() {
        assert_eq!(Baseline::file_name("ironplc"), "ironplc.toml");
        assert_eq!(Baseline::file_name("../../etc/pass wd"), "..-..-etc-pass-wd.toml");
    }
}
