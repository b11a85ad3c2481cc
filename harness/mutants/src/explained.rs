//! `survivors.toml`: the mutants that no case can kill, each with the reason.

use crate::outcomes::{MutantFate, MutantOutcome};
use anyhow::Context as _;
use serde::Deserialize;
use stickler_types::words;

const TEXT: &str = include_str!("../survivors.toml");

/// The mutants that survive for a reason.
pub struct Explained(Vec<ExplainedSurvivor>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExplainedFile {
    survivor: Vec<ExplainedSurvivor>,
}

/// Mutants of one file that survive for one reason.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExplainedSurvivor {
    /// The file, below `harness/`.
    file: String,
    /// The changes, as cargo-mutants words them behind the place: `replace X with Y in F`. Lines move, so none is named: a
    /// change that survives at two places of a function stands here twice.
    mutants: Vec<String>,
    kind: ExplanationKind,
    /// The reason for which no case can kill the mutants.
    reason: String,
}

words! {
    /// The kind of reason for which a mutant survives.
    #[derive(Deserialize)]
    #[serde(rename_all = "kebab-case")]
    ExplanationKind {
        /// No input tells the mutant from the original.
        Equivalent = "equivalent",
        /// The mutant differs only where no document says what must come.
        Open = "open",
        /// The mutant differs only in what a case cannot see: a message, a suggestion, a position within a line.
        Unseen = "unseen",
        /// No program reaches the code: it is for a choice that no dialect makes, or for other callers than the suite.
        Unused = "unused",
    }
}

impl Explained {
    /// Reads the list that is built into this program.
    ///
    /// # Errors
    /// An error where the list cannot be read.
    pub fn read() -> anyhow::Result<Explained> {
        Explained::from_text(TEXT).context("harness/mutants/survivors.toml")
    }

    fn from_text(text: &str) -> anyhow::Result<Explained> {
        let file: ExplainedFile = toml::from_str(text)?;
        for entry in &file.survivor {
            anyhow::ensure!(
                !entry.reason.trim().is_empty(),
                "an entry of {} has no reason",
                entry.file
            );
        }
        Ok(Explained(file.survivor))
    }

    /// Returns why each mutant survives; `None` where it was killed, or survives for no reason that is listed. A change
    /// that is listed once explains one survivor.
    pub fn kinds(&self, outcomes: &[MutantOutcome]) -> Vec<Option<ExplanationKind>> {
        let mut left: Vec<(&ExplainedSurvivor, &str)> = self.changes().collect();
        let kind = |outcome: &MutantOutcome| {
            let explained = |(entry, change): &(&ExplainedSurvivor, &str)| explains(entry, change, outcome);
            let survives = outcome.fate == MutantFate::Survived;
            let at = left.iter().position(|listed| survives && explained(listed))?;
            Some(left.swap_remove(at).0.kind)
        };
        outcomes.iter().map(kind).collect()
    }

    /// Returns the changes of the list that were tried and killed.
    pub fn stale<'a>(&'a self, outcomes: impl Iterator<Item = &'a MutantOutcome> + Clone) -> Vec<String> {
        let tried = |entry, change| outcomes.clone().any(|outcome| explains(entry, change, outcome));
        let survives = |entry, change| {
            let mut survivors = outcomes
                .clone()
                .filter(|outcome| outcome.fate == MutantFate::Survived);
            survivors.any(|outcome| explains(entry, change, outcome))
        };
        self.changes()
            .filter(|&(entry, change)| tried(entry, change) && !survives(entry, change))
            .map(|(entry, change)| format!("harness/{}: {change}", entry.file))
            .collect()
    }

    fn changes(&self) -> impl Iterator<Item = (&ExplainedSurvivor, &str)> {
        self.0
            .iter()
            .flat_map(|entry| entry.mutants.iter().map(move |change| (entry, change.as_str())))
    }
}

fn explains(entry: &ExplainedSurvivor, change: &str, outcome: &MutantOutcome) -> bool {
    outcome.file.strip_prefix("harness/") == Some(&entry.file) && outcome.change() == change
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIST: &str = include_str!("../tests/survivors.toml");

    fn outcome(line: u32, fate: MutantFate) -> MutantOutcome {
        MutantOutcome {
            name: format!("harness/reference/src/raw.rs:{line}:5: replace < with <= in narrow"),
            file: "harness/reference/src/raw.rs".to_owned(),
            fate,
        }
    }

    #[test]
    fn what_is_listed_once_explains_one_survivor() {
        let list = Explained::from_text(LIST).unwrap();
        let outcomes = [
            outcome(1, MutantFate::Killed),
            outcome(2, MutantFate::Survived),
            outcome(3, MutantFate::Survived),
        ];
        assert_eq!(
            list.kinds(&outcomes),
            [None, Some(ExplanationKind::Equivalent), None]
        );
    }

    #[test]
    fn what_is_listed_and_killed_is_told() {
        let list = Explained::from_text(LIST).unwrap();
        assert_eq!(list.stale([outcome(1, MutantFate::Killed)].iter()).len(), 1);
        assert_eq!(list.stale([outcome(1, MutantFate::Survived)].iter()), [""; 0]);
        assert_eq!(list.stale([].iter()), [""; 0]);
    }

    /// Returns the name of the function that a change is in: what stands behind `in`, or what is replaced as a whole.
    fn function(change: &str) -> Option<&str> {
        let whole = || change.strip_prefix("replace ")?.split_once(" -> ");
        let path = match change.rsplit_once(" in ") {
            Some((_, path)) => path,
            None => whole()?.0,
        };
        path.rsplit("::").next()
    }

    #[test]
    fn the_list_of_this_repository_can_be_read_and_names_files_and_functions_that_exist() {
        let list = Explained::read().unwrap();
        for (entry, change) in list.changes() {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../").to_owned() + &entry.file;
            let source = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
            let is_there = |name: &str| source.contains(&format!("fn {name}"));
            assert!(function(change).is_none_or(is_there), "{path}: {change}");
        }
    }
}
