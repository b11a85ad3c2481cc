//! The table of saboteurs, by rule and by place.

use super::claim::Rule;
use super::explained::{ExplainedSaboteurs, Explanation};
use super::measure::Tally;
use super::saboteur::{BrokenPlace, Saboteur};
use std::collections::BTreeMap;

/// A saboteur and what came of it.
pub struct Judged {
    /// The saboteur.
    pub saboteur: Saboteur,
    /// The cases that were run against it; none where no program has its rule in its place.
    pub tally: Tally,
    /// Why no case notices, where that is listed.
    pub kind: Option<Explanation>,
}

impl Judged {
    /// Returns whether some case notices.
    pub fn is_noticed(&self) -> bool {
        self.tally.noticed > 0
    }

    /// Returns whether every case that sees the saboteur only records: then it breaks no claim.
    pub fn is_recorded(&self) -> bool {
        self.tally.changed > 0 && self.tally.recorded == self.tally.changed
    }

    /// Returns whether no case notices, although some asserts something or none sees it, and nobody has said why.
    pub fn is_unexplained(&self) -> bool {
        !self.is_noticed() && !self.is_recorded() && self.kind.is_none()
    }

    /// Returns the line that says what is wrong with a saboteur that no case notices.
    pub fn complaint(&self) -> String {
        let Judged { saboteur, tally, .. } = self;
        let example = tally.example.as_deref().unwrap_or_default();
        match tally {
            Tally { met: 0, .. } => {
                format!("no case: {saboteur}: no program of the suite has this rule in this place")
            }
            Tally { changed: 0, met, .. } => {
                format!(
                    "changes nothing: {saboteur}: {met} cases have it, and no value of theirs shows it ({example})"
                )
            }
            Tally { changed, .. } => {
                format!(
                    "unnoticed: {saboteur}: {changed} cases see it, and none of them asserts what it breaks ({example})"
                )
            }
        }
    }
}

/// Looks every saboteur up that is not noticed.
pub fn judge(tallies: BTreeMap<Saboteur, Tally>, explained: &ExplainedSaboteurs) -> Vec<Judged> {
    let judged = |(saboteur, tally): (Saboteur, Tally)| Judged {
        kind: explained.kind(&saboteur).filter(|_| tally.noticed == 0),
        saboteur,
        tally,
    };
    tallies.into_iter().map(judged).collect()
}

/// The columns of the table.
const COLUMNS: [&str; 5] = ["sources", "targets", "surroundings", "pairs", "bits"];

const fn column(place: BrokenPlace) -> usize {
    match place {
        BrokenPlace::Source(_) => 0,
        BrokenPlace::Target(_) => 1,
        BrokenPlace::Surrounding(_) => 2,
        BrokenPlace::Cell(..) => 3,
        BrokenPlace::Bit(..) => 4,
    }
}

/// A field of the table.
#[derive(Clone, Copy, Default)]
struct Field {
    noticed: usize,
    recorded: usize,
    explained: usize,
    all: usize,
    /// The fewest cases that notice one of them.
    fewest: Option<usize>,
}

impl Field {
    fn add(&mut self, judged: &Judged) {
        self.all += 1;
        self.noticed += usize::from(judged.is_noticed());
        self.recorded += usize::from(judged.is_recorded());
        self.explained += usize::from(judged.kind.is_some() && !judged.is_recorded());
        let noticed = judged.is_noticed().then_some(judged.tally.noticed);
        self.fewest = self.fewest.into_iter().chain(noticed).min();
    }

    /// Returns how many are noticed, how many break no claim (`o`) or are explained (`e`), and how many there are.
    fn text(self) -> String {
        if self.all == 0 {
            return "-".to_owned();
        }
        let mut text = self.noticed.to_string();
        for (number, mark) in [(self.recorded, 'o'), (self.explained, 'e')] {
            if number > 0 {
                text += &format!("+{number}{mark}");
            }
        }
        text += &format!("/{}", self.all);
        text
    }
}

/// Returns the table of rules: of the saboteurs in sources, targets, surroundings, pairs of types in a target, and bits, how many
/// are noticed, how many explained, and how many there are; and the fewest cases that notice one of them.
pub fn by_rule(judged: &[Judged]) -> String {
    let mut rows: BTreeMap<Rule, [Field; COLUMNS.len()]> = BTreeMap::new();
    let mut sums = [Field::default(); COLUMNS.len()];
    for one in judged {
        let at = column(one.saboteur.place);
        rows.entry(one.saboteur.rule).or_default()[at].add(one);
        sums[at].add(one);
    }
    let mut table = String::new();
    line(&mut table, "rule", COLUMNS.map(str::to_owned), "fewest cases");
    for (rule, fields) in rows {
        let fewest = spelled(fields.iter().filter_map(|field| field.fewest).min());
        line(&mut table, &rule.to_string(), fields.map(Field::text), &fewest);
    }
    line(&mut table, "all", sums.map(Field::text), "");
    table
}

fn spelled(fewest: Option<usize>) -> String {
    fewest.map_or_else(|| "-".to_owned(), |fewest| fewest.to_string())
}

fn line(table: &mut String, name: &str, fields: [String; COLUMNS.len()], fewest: &str) {
    *table += &format!("{name:<48}");
    for (field, width) in fields.iter().zip([20, 20, 20, 24, 11]) {
        *table += &format!("{field:>width$}");
    }
    *table += &format!("{fewest:>14}\n");
}

/// Returns the table of places: how many rules are noticed there, and the fewest cases that notice one.
pub fn by_place(judged: &[Judged]) -> String {
    let mut rows: BTreeMap<String, Field> = BTreeMap::new();
    let places = judged.iter().filter(|one| column(one.saboteur.place) < 3);
    for one in places {
        rows.entry(one.saboteur.place.to_string()).or_default().add(one);
    }
    let mut table = format!("{:<48}{:>16}{:>14}\n", "place", "rules", "fewest cases");
    for (place, field) in rows {
        table += &format!("{place:<48}{:>16}{:>14}\n", field.text(), spelled(field.fewest));
    }
    table
}
