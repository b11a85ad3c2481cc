//! The kill rate, module by module.

use crate::explained::{Explained, ExplanationKind};
use crate::outcomes::{MutantFate, MutantOutcome};
use std::collections::BTreeMap;

/// The topics of the suite, and the code of each: a file, a folder, or a file and a part of the names of its functions.
/// Each mutant that survives there must be explained.
const TOPICS: [(&str, &[(&str, &str)]); 3] = [
    (
        "bit access",
        &[
            ("syntax/src/parser/partial_access.rs", ""),
            ("reference/src/semantics/places.rs", ""),
            ("reference/src/semantics/infer.rs", "infer_part"),
            ("reference/src/semantics/locations.rs", "store_part"),
            ("reference/src/execution/operations.rs", "store_part"),
        ],
    ),
    (
        "widening",
        &[
            ("reference/src/conversion/implicit.rs", ""),
            ("reference/src/semantics/contexts.rs", ""),
        ],
    ),
    (
        "conversion",
        &[
            ("reference/src/conversion/", ""),
            ("reference/src/semantics/conversions.rs", ""),
            ("reference/src/raw.rs", ""),
            ("types/src/choices.rs", ""),
        ],
    ),
];

/// A mutant with its result, its explanation and its topic.
pub struct JudgedMutant {
    /// The result of the mutant.
    pub outcome: MutantOutcome,
    /// The reason for which the mutant survives, where it is listed.
    pub kind: Option<ExplanationKind>,
    /// The topic of the suite that the mutant's place is part of.
    pub topic: Option<&'static str>,
}

impl JudgedMutant {
    /// Returns whether the mutant survives and nobody has said why.
    pub fn is_unexplained(&self) -> bool {
        self.outcome.fate == MutantFate::Survived && self.kind.is_none()
    }
}

/// Looks every survivor up in the list.
pub fn judge(outcomes: Vec<MutantOutcome>, explained: &Explained) -> Vec<JudgedMutant> {
    let kinds = explained.kinds(&outcomes);
    let judged = |(outcome, kind): (MutantOutcome, _)| JudgedMutant {
        topic: topic(&outcome),
        outcome,
        kind,
    };
    outcomes.into_iter().zip(kinds).map(judged).collect()
}

/// Returns the topic of a mutant's file and function.
fn topic(outcome: &MutantOutcome) -> Option<&'static str> {
    let file = outcome.file.strip_prefix("harness/").unwrap_or(&outcome.file);
    let function = outcome.change().rsplit(" in ").next().unwrap_or_default();
    let in_place = |&(place, name): &(&str, &str)| file.starts_with(place) && function.contains(name);
    let (topic, _) = TOPICS.iter().find(|(_, places)| places.iter().any(in_place))?;
    Some(topic)
}

/// Returns the module of a file: its crate and the folders below `src`, or with `by_file` the file.
fn module(file: &str, by_file: bool) -> String {
    let file = file
        .strip_prefix("harness/")
        .unwrap_or(file)
        .replace("/src/", "/");
    let file = file.strip_suffix(".rs").unwrap_or(&file);
    let place = if by_file {
        Some(file)
    } else {
        file.rsplit_once('/').map(|(folder, _)| folder)
    };
    place.unwrap_or(file).to_owned()
}

/// A line of the table.
#[derive(Default)]
struct MutantCounts {
    killed: usize,
    survived: usize,
    /// The number of those that survive for a reason of each kind.
    explained: [usize; ExplanationKind::ALL.len()],
}

impl MutantCounts {
    fn add(&mut self, mutant: &JudgedMutant) {
        match (mutant.outcome.fate, mutant.kind) {
            (MutantFate::Unviable, _) => {}
            (MutantFate::Killed, _) => self.killed += 1,
            (MutantFate::Survived, None) => self.survived += 1,
            (MutantFate::Survived, Some(kind)) => self.explained[kind as usize] += 1,
        }
    }

    fn line(&self, name: &str) -> String {
        let explained: String = self
            .explained
            .iter()
            .map(|count| format!("{count:>11}"))
            .collect();
        let (killed, survived) = (self.killed, self.survived);
        let all = killed + survived + self.explained.iter().sum::<usize>();
        let rate = percentage(killed, all);
        let of_the_rest = percentage(killed, killed + survived);
        format!("  {name:30}{all:>8}{killed:>8}{rate:>9}{explained}{survived:>13}{of_the_rest:>9}\n")
    }
}

fn percentage(part: usize, all: usize) -> String {
    match all {
        0 => "-".to_owned(),
        _ => format!("{}.{} %", 100 * part / all, 1000 * part / all % 10),
    }
}

/// Returns the table: modules, then topics, then all.
pub fn table(mutants: &[JudgedMutant], by_file: bool) -> String {
    let mut modules: BTreeMap<String, MutantCounts> = BTreeMap::new();
    let mut topics: BTreeMap<&str, MutantCounts> = BTreeMap::new();
    let mut all = MutantCounts::default();
    for mutant in mutants {
        modules
            .entry(module(&mutant.outcome.file, by_file))
            .or_default()
            .add(mutant);
        if let Some(topic) = mutant.topic {
            topics.entry(topic).or_default().add(mutant);
        }
        all.add(mutant);
    }
    let mut text = heading("Module");
    text.extend(modules.iter().map(|(name, counts)| counts.line(name)));
    text += "\n";
    text += &heading("Topic");
    text.extend(topics.iter().map(|(name, counts)| counts.line(name)));
    text += &all.line("all");
    let unviable = mutants
        .iter()
        .filter(|mutant| mutant.outcome.fate == MutantFate::Unviable)
        .count();
    text += &format!("\n{unviable} more do not compile and are not counted.\n");
    text
}

/// Returns the heading of the table; its last column leaves out what is explained.
fn heading(first: &str) -> String {
    let explained: String = ExplanationKind::ALL.map(|kind| format!("{kind:>11}")).concat();
    format!(
        "{first:32}{:>8}{:>8}{:>9}{explained}{:>13}{:>9}\n",
        "mutants", "killed", "rate", "unexplained", "rate"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(file: &str, fate: MutantFate, kind: Option<ExplanationKind>) -> JudgedMutant {
        let outcome = MutantOutcome {
            name: format!("{file}:1:1: replace < with == in f"),
            file: file.to_owned(),
            fate,
        };
        JudgedMutant {
            topic: topic(&outcome),
            outcome,
            kind,
        }
    }

    #[test]
    fn the_places_of_all_topics_are_there() {
        for (place, name) in TOPICS.iter().flat_map(|(_, places)| places.iter()) {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../").to_owned() + place;
            let source = match place.ends_with('/') {
                true => std::fs::read_dir(&path).map(|_| String::new()),
                false => std::fs::read_to_string(&path),
            };
            let source = source.unwrap_or_else(|error| panic!("{path}: {error}"));
            assert!(source.contains(name), "{path} has no {name}");
        }
    }

    #[test]
    fn mutants_are_counted_by_module_and_by_topic() {
        let implicit = "harness/reference/src/conversion/implicit.rs";
        let mutants = [
            judged(implicit, MutantFate::Killed, None),
            judged(implicit, MutantFate::Survived, Some(ExplanationKind::Equivalent)),
            judged(
                "harness/reference/src/conversion/bcd.rs",
                MutantFate::Survived,
                None,
            ),
            judged("harness/types/src/value.rs", MutantFate::Unviable, None),
        ];
        let text = table(&mutants, false);
        let spaced = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        let lines: Vec<String> = text.lines().map(spaced).collect();
        for expected in [
            "reference/conversion 3 1 33.3 % 1 0 0 0 1 50.0 %",
            "types 0 0 - 0 0 0 0 0 -",
            "widening 2 1 50.0 % 1 0 0 0 0 100.0 %",
            "conversion 1 0 0.0 % 0 0 0 0 1 0.0 %",
            "all 3 1 33.3 % 1 0 0 0 1 50.0 %",
            "1 more do not compile and are not counted.",
        ] {
            assert!(
                lines.iter().any(|line| line == expected),
                "{expected} is not in\n{text}"
            );
        }
        assert!(table(&mutants, true).contains("reference/conversion/implicit "));
    }
}
