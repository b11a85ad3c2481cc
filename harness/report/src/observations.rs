//! Compares what engines do where no document states what they must do. Observations are recorded, never judged.

use indexmap::IndexMap;
use serde::Serialize;
use std::collections::BTreeMap;
use stickler_run::CaseEvent;
use stickler_types::{WordTable, grouped_by_key};

/// The maximum number of characters that are kept of a value.
const MAX_KEPT_CHARACTERS: usize = 300;

/// The observations of a run, in a few bytes each.
#[derive(Debug, Default)]
pub struct Observations {
    words: WordTable,
    /// The observations, by the id of the case and the observed variable, in the order of both.
    seen: BTreeMap<(String, u32), Vec<Seen>>,
}

/// The result of a case on one engine in one dialect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Seen {
    engine: u32,
    dialect: u32,
    value: u32,
}

/// Cases of one probe on which the engines form the same groups by their results.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Disagreement<'o> {
    /// The id of the first case.
    pub id: &'o str,
    /// The observed variable, or `acceptance`, or `fault`.
    pub name: &'o str,
    /// Each value of the first case with the engines that gave it; an engine that gave several values is named with its
    /// dialects.
    pub values: Vec<(&'o str, Vec<String>)>,
    /// The number of cases on which the engines form these groups.
    pub cases: u64,
}

impl Observations {
    /// Adds the observations of a case.
    pub fn take(&mut self, case: &CaseEvent) {
        for observed in &case.observations {
            let name = self.words.number(&observed.name);
            let value = match observed.value.char_indices().nth(MAX_KEPT_CHARACTERS) {
                None => self.words.number(&observed.value),
                Some((end, _)) => self.words.number(&observed.value[..end]),
            };
            let seen = Seen {
                engine: self.words.number(&case.engine),
                dialect: self.words.number(&case.dialect),
                value,
            };
            self.seen.entry((case.id.clone(), name)).or_default().push(seen);
        }
    }

    /// Returns the disagreements between engines, in the order of ids. `engines` is the order in which engines are named.
    pub fn disagreements(&self, engines: &[&str]) -> Vec<Disagreement<'_>> {
        let mut disagreements: IndexMap<_, Disagreement<'_>> = IndexMap::new();
        for ((id, name), seen) in self.seen.iter().filter(|(_, seen)| self.disagree(seen)) {
            let values = self.values(seen, engines);
            let who: Vec<Vec<String>> = values.iter().map(|(_, who)| who.clone()).collect();
            let alike = disagreements.entry((probe(id), *name, who));
            alike
                .or_insert_with(|| self.disagreement(id, *name, values))
                .cases += 1;
        }
        disagreements.into_values().collect()
    }

    /// Returns a disagreement of no case yet.
    fn disagreement<'o>(
        &'o self,
        id: &'o str,
        name: u32,
        values: Vec<(&'o str, Vec<String>)>,
    ) -> Disagreement<'o> {
        Disagreement {
            id,
            name: self.words.word(name),
            values,
            cases: 0,
        }
    }

    /// Returns the observations of a run of one engine: the cases of a probe in which it did the same, in the order of ids.
    pub fn of_one(&self, engine: &str) -> Vec<Disagreement<'_>> {
        let mut lists: IndexMap<_, Disagreement<'_>> = IndexMap::new();
        for ((id, name), seen) in &self.seen {
            for seen in seen {
                let values = || vec![(self.words.word(seen.value), vec![engine.to_owned()])];
                let alike = lists.entry((probe(id), *name, seen.value));
                alike
                    .or_insert_with(|| self.disagreement(id, *name, values()))
                    .cases += 1;
            }
        }
        lists.into_values().collect()
    }

    /// Returns whether two engines disagree: in a dialect that both support, or, where they share none, in all of their
    /// values.
    fn disagree(&self, seen: &[Seen]) -> bool {
        seen.iter().any(|one| {
            seen.iter()
                .filter(|other| other.engine != one.engine)
                .any(|other| differ(seen, one, other))
        })
    }

    /// Returns each value with the engines that gave it; the value of the first engine comes first.
    fn values(&self, seen: &[Seen], engines: &[&str]) -> Vec<(&str, Vec<String>)> {
        let mut values: Vec<(&str, String)> = Vec::new();
        for engine in engines {
            let own: Vec<&Seen> = seen
                .iter()
                .filter(|seen| self.words.word(seen.engine) == *engine)
                .collect();
            let one_value = own
                .windows(2)
                .all(|pair| matches!(pair, [one, other] if one.value == other.value));
            for seen in own.iter().take(if one_value { 1 } else { usize::MAX }) {
                let who = match one_value {
                    true => (*engine).to_owned(),
                    false => format!("{engine} in {}", self.words.word(seen.dialect)),
                };
                let value = self.words.word(seen.value);
                values.push((value, who));
            }
        }
        grouped_by_key(values)
    }
}

/// Returns whether two results of different engines contradict each other.
fn differ(seen: &[Seen], one: &Seen, other: &Seen) -> bool {
    if one.value == other.value {
        return false;
    }
    if one.dialect == other.dialect {
        return true;
    }
    let of = |engine: u32| seen.iter().filter(move |seen| seen.engine == engine);
    let share_a_dialect =
        of(one.engine).any(|one| of(other.engine).any(|other| one.dialect == other.dialect));
    let share_a_value = of(one.engine).any(|one| of(other.engine).any(|other| one.value == other.value));
    !share_a_dialect && !share_a_value
}

/// Returns the part of an id that the cases of a table's probe share, or the whole id where the case comes from no table.
pub(crate) fn probe(id: &str) -> &str {
    id.split_once('(').map_or(id, |(probe, _)| probe)
}
