//! `unnoticed.toml`: the saboteurs that no case notices, each with the reason.

use super::saboteur::{BrokenPlace, Saboteur};
use anyhow::Context as _;
use serde::Deserialize;
use stickler_run::pattern_fits;
use stickler_types::DialectName;

const TEXT: &str = include_str!("../../unnoticed.toml");

/// The saboteurs that nothing notices, by the reason.
pub struct ExplainedSaboteurs {
    reasons: Vec<UnnoticedReason>,
    /// Whether the run is one of some dialects alone, so that reasons of all of them may be those of others.
    narrowed: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct UnnoticedFile {
    reason: Vec<UnnoticedReason>,
}

/// A reason for which no case notices saboteurs.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct UnnoticedReason {
    kind: Explanation,
    text: String,
    /// The dialects by whose cases alone nothing notices; without them the cases of all dialects together.
    #[serde(default)]
    dialects: Vec<String>,
    unnoticed: Vec<UnnoticedEntry>,
}

/// Saboteurs that nothing notices: each of the rules in each of the places. In their names `*` stands for any text.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct UnnoticedEntry {
    /// Rules as the program prints them: `implicit.lreal-to-real.refused`, `literal.*`.
    rules: Vec<String>,
    /// Places as the program prints them: `target.initial-value`, `source.*`.
    places: Vec<String>,
    /// The places that are not meant, although `places` has them.
    #[serde(default)]
    except: Vec<String>,
    /// The pairs of types that are meant, `LDT to DT`; without them the place as a whole and each pair in it.
    #[serde(default)]
    pairs: Vec<String>,
}

/// The kind of reason for which no case notices a saboteur.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Explanation {
    /// No program can have the rule in the place.
    Impossible,
    /// No document says what must happen there.
    Open,
}

impl ExplainedSaboteurs {
    /// Reads the list that is built into this program: what it says of the cases of all dialects together, and where only some are
    /// run what it says of these.
    ///
    /// # Errors
    /// An error where the list cannot be read.
    pub fn read(dialects: &[DialectName]) -> anyhow::Result<ExplainedSaboteurs> {
        ExplainedSaboteurs::from_text(TEXT, dialects).context("harness/mutants/unnoticed.toml")
    }

    pub(super) fn from_text(text: &str, dialects: &[DialectName]) -> anyhow::Result<ExplainedSaboteurs> {
        let file: UnnoticedFile = toml::from_str(text)?;
        for reason in &file.reason {
            anyhow::ensure!(!reason.text.trim().is_empty(), "a reason has no text");
            let mut pairs = reason.unnoticed.iter().flat_map(|entry| &entry.pairs);
            if let Some(wrong) = pairs.find(|pair| !pair.contains(" to ")) {
                anyhow::bail!("`{wrong}`: pairs are written `LDT to DT`, with `*` for any type");
            }
        }
        let mut named = file.reason.iter().flat_map(|reason| &reason.dialects);
        if let Some(wrong) = named.find(|name| name.parse::<DialectName>().is_err()) {
            anyhow::bail!("no dialect `{wrong}`");
        }
        let mut reasons = file.reason;
        reasons.retain(|reason| {
            let own = &reason.dialects;
            let speaks_for = |dialect: &DialectName| own.iter().any(|name| name == dialect.as_str());
            own.is_empty() || (!dialects.is_empty() && dialects.iter().all(speaks_for))
        });
        let narrowed = !dialects.is_empty();
        Ok(ExplainedSaboteurs { reasons, narrowed })
    }

    /// Returns the entries that the run can prove wrong: of some dialects alone, those that name them.
    fn entries(&self) -> impl Iterator<Item = &UnnoticedEntry> {
        let told = |reason: &&UnnoticedReason| reason.dialects.is_empty() != self.narrowed;
        self.reasons
            .iter()
            .filter(told)
            .flat_map(|reason| &reason.unnoticed)
    }

    /// Returns the names of rules that stand for none of these.
    #[cfg(test)]
    pub(super) fn unknown_rules(&self, known: &[String]) -> Vec<&str> {
        let named = self.entries().flat_map(|entry| &entry.rules);
        let unknown = named.filter(|name| !known.iter().any(|rule| pattern_fits(name, rule)));
        unknown.map(String::as_str).collect()
    }

    /// Returns why nothing notices a saboteur.
    pub fn kind(&self, saboteur: &Saboteur) -> Option<Explanation> {
        let explains =
            |reason: &&UnnoticedReason| reason.unnoticed.iter().any(|entry| entry.explains(saboteur));
        Some(self.reasons.iter().find(explains)?.kind)
    }

    /// Returns what is wrong with the list, of which `unnoticed` are the saboteurs that it explains and `noticed` all that are noticed.
    pub fn stale(&self, unnoticed: &[&Saboteur], noticed: &[&Saboteur]) -> Vec<String> {
        let mut stale = Vec::new();
        for entry in self.entries() {
            stale.extend(entry.idle(unnoticed));
            stale.extend(entry.noticed(noticed));
            stale.extend(entry.idle_exceptions(noticed));
        }
        stale
    }
}

impl UnnoticedEntry {
    /// Returns each rule and place that stand for no saboteur that needs an explanation.
    fn idle(&self, unnoticed: &[&Saboteur]) -> impl Iterator<Item = String> {
        let idle = self.names().filter(move |(rule, place)| {
            let mut meant = unnoticed
                .iter()
                .filter(|saboteur| self.means(saboteur, rule, place));
            meant.next().is_none()
        });
        idle.map(|(rule, place)| format!("{rule} in {place}, which is noticed or does not exist"))
    }

    /// Returns the saboteurs that are noticed although a `*` stands for them. Of a pair of types another place may be noticed.
    fn noticed(&self, noticed: &[&Saboteur]) -> impl Iterator<Item = String> {
        let patterns = self
            .names()
            .filter(|(rule, place)| rule.contains('*') || place.contains('*'));
        patterns.flat_map(move |(rule, place)| {
            let covered = noticed.iter().filter(move |saboteur| {
                whole_place(saboteur.place) == saboteur.place && self.means(saboteur, rule, place)
            });
            covered
                .map(move |saboteur| format!("{saboteur} by `{rule}` in `{place}`, although it is noticed"))
        })
    }

    /// Returns the exceptions that are none, because no rule of the entry is noticed there.
    fn idle_exceptions(&self, noticed: &[&Saboteur]) -> impl Iterator<Item = String> {
        let idle = self.except.iter().filter(move |place| {
            let mut there = noticed.iter().filter(|saboteur| {
                let rule = saboteur.rule.to_string();
                saboteur.place.to_string() == **place
                    && self.rules.iter().any(|name| pattern_fits(name, &rule))
            });
            there.next().is_none()
        });
        idle.map(|place| {
            format!("nothing in {place} by its exception: no rule of the entry is noticed there")
        })
    }

    /// Returns each rule with each place.
    fn names(&self) -> impl Iterator<Item = (&str, &str)> {
        self.rules
            .iter()
            .flat_map(|rule| self.places.iter().map(move |place| (&**rule, &**place)))
    }

    fn explains(&self, saboteur: &Saboteur) -> bool {
        self.names()
            .any(|(rule, place)| self.means(saboteur, rule, place))
    }

    /// Returns whether the entry means a saboteur by one of its rules and one of its places.
    fn means(&self, saboteur: &Saboteur, rule: &str, place: &str) -> bool {
        let whole = whole_place(saboteur.place).to_string();
        self.has_pair(saboteur.place)
            && pattern_fits(rule, &saboteur.rule.to_string())
            && pattern_fits(place, &whole)
            && !self.except.contains(&whole)
    }

    /// Returns whether a place is a pair of types that is listed, or anything where none are listed.
    fn has_pair(&self, place: BrokenPlace) -> bool {
        if self.pairs.is_empty() {
            return true;
        }
        let BrokenPlace::Cell(from, to, _) = place else {
            return false;
        };
        let pair = format!("{} to {}", from.name(), to.name());
        self.pairs.iter().any(|listed| pattern_fits(listed, &pair))
    }
}

/// Returns the place that a pair of types is in; any other place as it is.
fn whole_place(place: BrokenPlace) -> BrokenPlace {
    match place {
        BrokenPlace::Cell(_, _, target) => BrokenPlace::Target(target),
        place => place,
    }
}
