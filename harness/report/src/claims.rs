//! Claims: the statements of each section of each document, and how many of its cases an engine meets. Every report begins
//! with them, and takes them from here.

use crate::basis::Basis;
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};
use std::iter::Sum;
use std::ops::AddAssign;
use stickler_run::{CaseEvent, Verdict};

/// The results of the cases of one claim, counted. Every case counts once.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Standing {
    /// The number of cases in which the engine did what the document says (verdicts pass and xpass).
    pub passed: u64,
    /// The number of cases in which the engine did something else, whether a baseline expects that or not, or crashed, timed
    /// out or gave an invalid answer.
    pub failed: u64,
    /// The number of cases in `failed` that a baseline expects (verdict xfail).
    pub known: u64,
    /// The number of cases in which the engine did something else, and the source does not bind it (verdict differs).
    pub differs: u64,
    /// The number of cases that the document leaves open: the result was recorded, nothing was asserted.
    pub open: u64,
    /// The number of cases that the engine does not support.
    pub unsupported: u64,
    /// The number of cases that wait for a feature which the engine lacks.
    pub waiting: u64,
}

impl Standing {
    /// Returns the number of all cases of the claim.
    pub const fn cases(self) -> u64 {
        self.passed + self.failed + self.differs + self.open + self.unsupported + self.waiting
    }

    /// Returns the number of cases in `failed` that no baseline expects.
    pub const fn unexpected(self) -> u64 {
        self.failed - self.known
    }

    /// Returns the number of cases that a document decides and the engine supports.
    pub const fn decided(self) -> u64 {
        self.passed + self.failed
    }

    /// Returns how many of a thousand decided cases pass, rounded down; `None` where there are none.
    pub fn per_mille(self) -> Option<u64> {
        (self.passed * 1000).checked_div(self.decided())
    }

    pub(crate) fn count(&mut self, event: &CaseEvent) {
        if event.verdict == Verdict::Xfail {
            self.known += 1;
        }
        let counter = match event.verdict {
            Verdict::Pass if event.open => &mut self.open,
            Verdict::Pass | Verdict::Xpass => &mut self.passed,
            Verdict::Unsupported => &mut self.unsupported,
            Verdict::Waiting => &mut self.waiting,
            Verdict::Differs => &mut self.differs,
            Verdict::Fail | Verdict::Xfail | Verdict::Crash | Verdict::Timeout | Verdict::Error => {
                &mut self.failed
            }
        };
        *counter += 1;
    }
}

impl AddAssign for Standing {
    fn add_assign(&mut self, other: Standing) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.known += other.known;
        self.differs += other.differs;
        self.open += other.open;
        self.unsupported += other.unsupported;
        self.waiting += other.waiting;
    }
}

/// The title of a column, and its number.
type Column = (&'static str, fn(&Standing) -> u64);

/// The columns of a table of claims of one engine.
pub(crate) const COLUMNS: [Column; 6] = [
    ("passed", |standing| standing.passed),
    ("failed", |standing| standing.failed),
    ("differs", |standing| standing.differs),
    ("open", |standing| standing.open),
    ("unsupported", |standing| standing.unsupported),
    ("waiting", |standing| standing.waiting),
];

/// Adds the standings of engines, in the same order.
pub(crate) fn add(sums: &mut [Standing], standings: &[Standing]) {
    for (sum, standing) in sums.iter_mut().zip(standings) {
        *sum += *standing;
    }
}

impl<'a> Sum<&'a Standing> for Standing {
    fn sum<I: Iterator<Item = &'a Standing>>(all: I) -> Standing {
        all.fold(Standing::default(), |mut sum, standing| {
            sum += *standing;
            sum
        })
    }
}

/// A section of a source with the results of one engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ClaimResult"))]
pub struct Claim<'a> {
    /// The name of the engine.
    pub engine: &'a str,
    /// The key of the source.
    pub source: &'a str,
    /// The section of the source.
    pub section: &'a str,
    /// The number of cases by what came of them.
    pub standing: Standing,
}

/// A section of a document with the results of several engines side by side; or, where `section` is empty and `sum` is set,
/// the sum of a document's sections.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Row<'a> {
    /// The document, such as `ironplc-type-conversions`.
    pub source: &'a str,
    /// The section; empty where a basis names a whole document.
    pub section: &'a str,
    /// Whether the row is the sum of the rows that follow, the document's sections.
    pub sum: bool,
    /// The results of each engine, in the requested order.
    pub standings: Vec<Standing>,
}

impl Row<'_> {
    /// Returns whether any of the engines fails a case of the claim.
    pub fn failed(&self) -> bool {
        self.standings.iter().any(|standing| standing.failed > 0)
    }
}

/// All claims of a run, by engine, document and section.
#[derive(Debug, Default)]
pub struct Claims {
    engines: BTreeMap<String, FxHashMap<String, Standing>>,
}

impl Claims {
    /// Adds the result of a case.
    pub fn take(&mut self, event: &CaseEvent) {
        let bases = entry(&mut self.engines, &event.engine);
        match bases.get_mut(&event.basis) {
            Some(standing) => standing.count(event),
            None => bases.entry(event.basis.clone()).or_default().count(event),
        }
    }

    /// Returns every claim, sorted by engine, document and section.
    pub fn iter(&self) -> impl Iterator<Item = Claim<'_>> {
        self.engines.iter().flat_map(|(engine, claims)| {
            in_order(claims.keys()).map(move |(basis, Basis { source, section })| Claim {
                engine,
                source,
                section,
                standing: claims[basis],
            })
        })
    }

    /// Returns the claims with these engines side by side: each document, followed by its sections.
    pub fn rows(&self, engines: &[&str]) -> Vec<Row<'_>> {
        let bases: BTreeSet<&String> = self.engines.values().flat_map(FxHashMap::keys).collect();
        let mut rows: Vec<Row<'_>> = Vec::new();
        let mut document = 0;
        for (basis, Basis { source, section }) in in_order(bases) {
            let of = |engine: &&str| self.engines.get(*engine).and_then(|claims| claims.get(basis));
            let standings = engines.iter().map(|engine| of(engine).copied());
            let standings: Vec<Standing> = standings.map(Option::unwrap_or_default).collect();
            if rows.get(document).is_none_or(|row| row.source != source) {
                document = rows.len();
                rows.push(Row {
                    source,
                    section: "",
                    sum: true,
                    standings: vec![Standing::default(); engines.len()],
                });
            }
            add(&mut rows[document].standings, &standings);
            rows.push(Row {
                source,
                section,
                sum: false,
                standings,
            });
        }
        rows
    }

    /// Returns the sum of all claims for an engine.
    pub fn of_engine(&self, engine: &str) -> Standing {
        let claims = self.engines.get(engine).into_iter();
        claims.flat_map(FxHashMap::values).sum()
    }
}

/// Parses each basis, and returns it with the text, sorted by document and section.
fn in_order<'a>(
    bases: impl IntoIterator<Item = &'a String>,
) -> impl Iterator<Item = (&'a String, Basis<'a>)> {
    let mut sorted: Vec<_> = bases.into_iter().map(|basis| (basis, Basis::of(basis))).collect();
    sorted.sort_by_key(|(_, named)| *named);
    sorted.into_iter()
}

/// Returns the entry of a key, and creates it where it is missing. Unlike the map's own `entry`, it copies the key only
/// then.
pub(crate) fn entry<'m, V: Default>(map: &'m mut BTreeMap<String, V>, key: &str) -> &'m mut V {
    if !map.contains_key(key) {
        map.insert(key.to_owned(), V::default());
    }
    map.get_mut(key).expect("it is there or was just put there")
}
