//! The results of cargo-mutants, from its `outcomes.json`.

use anyhow::Context as _;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The result of one mutant.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MutantOutcome {
    /// `FILE:LINE:COLUMN: replace X with Y in F`.
    pub name: String,
    /// The mutated file, from the root of the repository.
    pub file: String,
    /// Whether the suite noticed.
    pub fate: MutantFate,
}

impl MutantOutcome {
    /// Returns the name without file, line and column: `replace X with Y in F`.
    pub fn change(&self) -> &str {
        self.name.splitn(4, ':').last().unwrap_or_default().trim_start()
    }
}

/// Whether the suite noticed a mutant.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MutantFate {
    /// Some case failed, or did not end.
    Killed,
    /// Every case passed.
    Survived,
    /// The mutant does not compile, so there was nothing to notice.
    Unviable,
}

/// Reads the results of several runs, in the order of names. Of a mutant that several have, the last one's counts.
///
/// # Errors
/// The folder has no results, or they cannot be read.
pub fn read_all(folders: &[PathBuf]) -> anyhow::Result<Vec<MutantOutcome>> {
    let mut outcomes = BTreeMap::new();
    for folder in folders {
        let text = text(folder)?;
        let read = read(&text)
            .with_context(|| format!("{}: not the outcomes of cargo-mutants", folder.display()))?;
        outcomes.extend(read.into_iter().map(|outcome| (outcome.name.clone(), outcome)));
    }
    Ok(outcomes.into_values().collect())
}

fn text(folder: &Path) -> anyhow::Result<String> {
    let places = [
        folder.join("outcomes.json"),
        folder.join("mutants.out/outcomes.json"),
    ];
    let found = places.iter().find(|place| place.is_file());
    let place =
        found.with_context(|| format!("{}: no `mutants.out/outcomes.json` in it", folder.display()))?;
    std::fs::read_to_string(place).with_context(|| format!("cannot read {}", place.display()))
}

/// The parts of `outcomes.json` that are read; cargo-mutants 27 writes more.
#[derive(Deserialize)]
struct OutcomesFile {
    outcomes: Vec<OutcomeEntry>,
}

#[derive(Deserialize)]
struct OutcomeEntry {
    scenario: Scenario,
    summary: String,
}

#[derive(Deserialize)]
enum Scenario {
    Baseline,
    Mutant(Mutant),
}

#[derive(Deserialize)]
struct Mutant {
    name: String,
    file: String,
}

fn read(text: &str) -> anyhow::Result<Vec<MutantOutcome>> {
    let file: OutcomesFile = serde_json::from_str(text)?;
    Ok(file.outcomes.into_iter().filter_map(outcome).collect())
}

/// A run that was interrupted leaves mutants without a verdict; they are left out, like the baseline.
fn outcome(entry: OutcomeEntry) -> Option<MutantOutcome> {
    let Scenario::Mutant(Mutant { name, file }) = entry.scenario else {
        return None;
    };
    let fate = match entry.summary.as_str() {
        "CaughtMutant" | "Timeout" => MutantFate::Killed,
        "MissedMutant" => MutantFate::Survived,
        "Unviable" => MutantFate::Unviable,
        _ => return None,
    };
    Some(MutantOutcome { name, file, fate })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The results as cargo-mutants 27.1 writes them, shortened.
    const TEXT: &str = include_str!("../tests/outcomes.json");

    #[test]
    fn a_mutant_that_takes_too_long_is_killed_and_one_without_a_verdict_left_out() {
        let outcomes = read(TEXT).unwrap();
        let fates: Vec<_> = outcomes
            .iter()
            .map(|outcome| (outcome.change(), outcome.fate))
            .collect();
        assert_eq!(
            fates,
            [
                ("replace < with == in f", MutantFate::Survived),
                ("replace g -> bool with true", MutantFate::Killed)
            ]
        );
    }

    #[test]
    fn a_later_folder_overrules_an_earlier_one() {
        let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
        let texts = [TEXT.to_owned(), TEXT.replace("MissedMutant", "CaughtMutant")];
        for (folder, text) in folders.iter().zip(texts) {
            std::fs::write(folder.path().join("outcomes.json"), text).unwrap();
        }
        let paths: Vec<PathBuf> = folders.iter().map(|folder| folder.path().to_owned()).collect();
        let outcomes = read_all(&paths).unwrap();
        assert!(
            outcomes.iter().all(|outcome| outcome.fate == MutantFate::Killed),
            "{outcomes:?}"
        );
    }

    #[test]
    fn a_folder_without_results_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = read_all(&[folder.path().to_owned()]).unwrap_err().to_string();
        assert!(error.contains("outcomes.json"), "{error}");
    }
}
