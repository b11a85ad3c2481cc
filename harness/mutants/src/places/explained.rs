//! `unnoticed.toml`: the saboteurs that no case notices, each with the reason.

use super::saboteur::{BrokenPlace, Saboteur};
use anyhow::Context as _;
use serde::Deserialize;

const TEXT: &str = include_str!("../../unnoticed.toml");

/// The saboteurs that nothing notices for a reason.
pub struct ExplainedSaboteurs(Vec<UnnoticedEntry>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct UnnoticedFile {
    unnoticed: Vec<UnnoticedEntry>,
}

/// Saboteurs that nothing notices for one reason: each of the rules in each of the places.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct UnnoticedEntry {
    rules: Vec<String>,
    /// Places as the program prints them: `target.initial-value`.
    places: Vec<String>,
    /// The pairs of types that are meant, `LDT to DT`, where `*` stands for any type; without them the place as a whole and each
    /// pair in it.
    #[serde(default)]
    pairs: Vec<String>,
    kind: Explanation,
    /// The reason for which no case can notice.
    reason: String,
}

/// The kind of reason for which no case notices a saboteur.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Explanation {
    /// No program can have the rule in the place.
    Impossible,
    /// No document says what must happen there.
    Open,
    /// A program could ask, and the suite does not: the reason says what it asks instead.
    Unasked,
}

impl ExplainedSaboteurs {
    /// Reads the list that is built into this program.
    ///
    /// # Errors
    /// An error where the list cannot be read.
    pub fn read() -> anyhow::Result<ExplainedSaboteurs> {
        ExplainedSaboteurs::from_text(TEXT).context("harness/mutants/unnoticed.toml")
    }

    pub(super) fn from_text(text: &str) -> anyhow::Result<ExplainedSaboteurs> {
        let file: UnnoticedFile = toml::from_str(text)?;
        for entry in &file.unnoticed {
            let what = || format!("{} in {}", entry.rules.join(", "), entry.places.join(", "));
            anyhow::ensure!(!entry.reason.trim().is_empty(), "{}: no reason", what());
            let wrong = entry.pairs.iter().find(|pair| !pair.contains(" to "));
            anyhow::ensure!(
                wrong.is_none(),
                "{}: pairs are written `LDT to DT`, with `*` for any type",
                what()
            );
        }
        Ok(ExplainedSaboteurs(file.unnoticed))
    }

    /// Returns the rules that the list names.
    #[cfg(test)]
    pub(super) fn rules(&self) -> impl Iterator<Item = &str> {
        self.0
            .iter()
            .flat_map(|entry| entry.rules.iter().map(String::as_str))
    }

    /// Returns why nothing notices a saboteur.
    pub fn kind(&self, saboteur: &Saboteur) -> Option<Explanation> {
        let entry = self.0.iter().find(|entry| entry.explains(saboteur))?;
        Some(entry.kind)
    }

    /// Returns what the list explains although it is noticed, or does not exist. `explained` are the saboteurs that
    /// [`ExplainedSaboteurs::kind`] found in the list.
    pub fn stale<'a>(&self, explained: impl Iterator<Item = &'a Saboteur> + Clone) -> Vec<String> {
        let mut stale = Vec::new();
        for entry in &self.0 {
            for rule in &entry.rules {
                for place in &entry.places {
                    let is_meant = |saboteur: &Saboteur| {
                        saboteur.rule.to_string() == *rule && entry.names_in(saboteur.place, place)
                    };
                    if !explained.clone().any(is_meant) {
                        stale.push(format!("{rule} in {place}"));
                    }
                }
            }
        }
        stale
    }
}

impl UnnoticedEntry {
    fn explains(&self, saboteur: &Saboteur) -> bool {
        let rule = saboteur.rule.to_string();
        self.rules.contains(&rule) && self.names(saboteur.place)
    }

    fn names(&self, place: BrokenPlace) -> bool {
        self.places.iter().any(|name| self.names_in(place, name))
    }

    /// Returns whether the entry means a place, or a pair of types in it, by one of its names.
    fn names_in(&self, place: BrokenPlace, name: &str) -> bool {
        let BrokenPlace::Cell(from, to, target) = place else {
            return self.pairs.is_empty() && place.to_string() == name;
        };
        let is_pair = |pair: &String| {
            let Some((row, column)) = pair.split_once(" to ") else {
                return false;
            };
            let fits = |word: &str, name: &str| word == "*" || word == name;
            fits(row, from.name()) && fits(column, to.name())
        };
        BrokenPlace::Target(target).to_string() == name
            && (self.pairs.is_empty() || self.pairs.iter().any(is_pair))
    }
}
