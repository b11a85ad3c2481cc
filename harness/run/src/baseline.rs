//! Baselines: the known deviations of an engine from its documents, each with its reason, so that a run fails only by new
//! ones. Basis: reports/README.md (baselines).
//!
//! A baseline changes no expectation and no claim: an expected failure still counts as failed for its document. Outdated
//! entries are reported: an unexpected pass, an entry that fits no case and one past its last day each fail the run.

mod bless;
mod fold;
mod matched;
mod read;
mod write;

use crate::{Filter, Verdict};
pub use bless::{Blessing, ChangeKind, EngineRun, EntryChange, bless};
use fold::CaseKey;
use jiff::civil::Date;
pub use matched::MatchedBaseline;
pub use read::BaselineError;
use semver::VersionReq;
use std::collections::HashMap;
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
    pub fn file_name(engine: &str) -> String {
        let harmless = |character: char| match character {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' | '.' => character,
            _ => '-',
        };
        let stem: String = engine.chars().map(harmless).collect();
        format!("{stem}.toml")
    }

    /// Returns the file and line of an entry, such as `reports/baselines/ironplc.toml:12`.
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

/// The assignment of cases to the entries of a baseline.
struct Owned<'a> {
    /// The index of the entry of each case, by id and dialect.
    owners: HashMap<CaseKey<'a>, usize>,
    /// The first id or pattern of each entry that fits no case at all; what fits cases that more exact entries own fits.
    unfit: Vec<Option<Filter>>,
}

impl<'a> Owned<'a> {
    /// Assigns each case to one of the entries for which `holds` is true: an id goes before a pattern, and of several of a
    /// kind the first counts.
    ///
    /// There may be thousands of entries and a hundred thousand cases. Therefore the cases are sorted, and an entry is
    /// compared only with those that share its beginning.
    fn of(entries: &[Entry], cases: &[CaseKey<'a>], holds: impl Fn(usize) -> bool) -> Owned<'a> {
        let mut sorted = cases.to_vec();
        sorted.sort_unstable();
        let mut owned = Owned {
            owners: HashMap::new(),
            unfit: vec![None; entries.len()],
        };
        for pattern in [false, true] {
            for (index, entry) in entries.iter().enumerate() {
                for filter in entry.cases.iter().filter(|filter| filter.is_pattern() == pattern) {
                    if !owned.take(index, filter, &sorted, holds(index)) {
                        owned.unfit[index].get_or_insert_with(|| filter.clone());
                    }
                }
            }
        }
        owned
    }

    /// Assigns the cases of an id or a pattern to an entry. Returns whether there are any.
    fn take(&mut self, index: usize, filter: &Filter, sorted: &[CaseKey<'a>], holds: bool) -> bool {
        let beginning = beginning(filter);
        let from = sorted.partition_point(|(id, _)| *id < beginning);
        let alike = sorted[from..]
            .iter()
            .take_while(|(id, _)| id.starts_with(beginning));
        let mut fits = false;
        for &(id, dialect) in alike {
            let is_meant = match filter.is_pattern() {
                true => filter.fits(id, dialect.as_str()),
                false => filter.names(id, dialect.as_str()),
            };
            if is_meant {
                fits = true;
                if holds {
                    self.owners.entry((id, dialect)).or_insert(index);
                }
            }
        }
        fits
    }
}

/// Returns the beginning that the ids of all cases of an id or a pattern share. An id contains neither `*` nor `@`.
fn beginning(filter: &Filter) -> &str {
    let text = filter.as_str();
    text.split(['*', '@']).next().unwrap_or(text)
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
