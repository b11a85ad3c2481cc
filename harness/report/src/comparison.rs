//! Compares two runs: what a later version of a compiler does better, worse, or differently.
//!
//! Both runs are read as streams. Of each case of the older run its result is kept, and of the newer run only the differences.

mod older_case;
mod page;

pub use page::{write, write_json};

use crate::LogError;
use crate::events::Reader;
use crate::overview;
use older_case::OlderCase;
use serde::Serialize;
use std::collections::{BTreeMap, HashMap};
use std::io::BufRead;
use stickler_run::{CaseEvent, Event, Header, Verdict};
use stickler_types::{join, words};

/// The maximum number of changes of each kind that are kept with their texts. Further ones are kept by name; the logs have
/// all texts.
pub const MAX_DETAILED: usize = 1000;

words! {
    /// The kind of change of a case; the gravest comes first.
    #[derive(Serialize)]
    #[serde(rename_all = "lowercase")]
    Kind {
        /// The engine crashed or gave no answer in time, and did not before.
        Crashed = "crashed",
        /// The engine no longer does what a document states.
        Broken = "broken",
        /// The engine now does what a document states.
        Fixed = "fixed",
        /// The engine does something else, neither better nor worse: another wrong value, or another value where none is
        /// asserted.
        Otherwise = "otherwise",
    }
}

/// A case of both runs with different results.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Change {
    /// The kind of change.
    pub kind: Kind,
    /// The id of the case.
    pub id: String,
    /// The dialect of the case.
    pub dialect: String,
    /// The name of the engine in the newer run.
    pub engine: String,
    /// The verdict in the older run, as if there were no baseline.
    pub old: Verdict,
    /// The verdict in the newer run, as if there were no baseline.
    pub new: Verdict,
    /// Whether the expectation differs from that in the older run: the suite changed, and perhaps the engine did not.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub expectation_changed: bool,
    /// The texts of the change; `None` beyond the first [`MAX_DETAILED`] of each kind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub detail: Option<Box<ComparedTexts>>,
}

/// The texts of a case with different results, with one fact per line.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ComparedTexts {
    /// The title of the case in the newer run.
    pub title: String,
    /// The claim of the case in the newer run: source and section.
    pub basis: String,
    /// The expectation in the newer run; `None` where neither log contains it, as for a case that only records.
    pub expected: Option<String>,
    /// The result and the observations in the older run; `None` where the engine met an expectation that has changed since.
    pub old: Option<String>,
    /// The result and the observations in the newer run.
    pub new: String,
    /// The command that runs the case again.
    pub rerun: String,
    /// The file and line of the case in the newer run.
    #[serde(skip)]
    pub place: String,
}

/// A case that only one of the runs contains.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
pub struct UnmatchedCase {
    /// The id of the case.
    pub id: String,
    /// The dialect of the case.
    pub dialect: String,
    /// The name of the engine in the run that contains the case.
    pub engine: String,
    /// The verdict, as if there were no baseline.
    pub verdict: Verdict,
}

/// The comparison of two runs.
#[derive(Debug, Default)]
pub struct Comparison {
    /// The header of the older run.
    pub old: Header,
    /// The header of the newer run.
    pub new: Header,
    /// The engines that are compared, each by its name in the older run and in the newer one.
    pub engines: Vec<(String, String)>,
    /// The cases with different results, in the order of the newer run.
    pub changes: Vec<Change>,
    /// The cases that only the newer run contains, in its order.
    pub added: Vec<UnmatchedCase>,
    /// The cases that only the older run contains, sorted.
    pub gone: Vec<UnmatchedCase>,
    /// The number of cases with equal results.
    pub same: u64,
}

/// An error that prevents the comparison of two runs.
#[derive(Debug, thiserror::Error)]
pub enum ComparisonError {
    /// The older run cannot be read, or is incomplete.
    #[error("the older run cannot be compared")]
    Old(#[source] LogError),
    /// The newer run cannot be read, or is incomplete.
    #[error("the newer run cannot be compared")]
    New(#[source] LogError),
    /// No engine took part in both.
    #[error("no engine took part in both runs: in the older one there is {old}, in the newer one {new}")]
    NoEngine {
        /// The list of the older run's engines.
        old: String,
        /// The list of the newer run's engines.
        new: String,
    },
    /// The runs are different parts of divided runs, so that they share few cases.
    #[error(
        "the older run is {old} and the newer one {new}; `stickler merge` makes a whole of the parts of a run"
    )]
    Parts {
        /// The description of the older run's part.
        old: String,
        /// The description of the newer run's part.
        new: String,
    },
}

impl Comparison {
    /// Compares two runs. Engines are matched by name; where each run has a single engine, these two are compared, whatever
    /// their names.
    ///
    /// # Errors
    /// [`ComparisonError`] where one of the runs is incomplete, or they have no engine in common.
    pub fn of(mut old: Reader<impl BufRead>, mut new: Reader<impl BufRead>) -> Result<Self, ComparisonError> {
        let headers = (
            old.header().map_err(ComparisonError::Old)?,
            new.header().map_err(ComparisonError::New)?,
        );
        let mut matching = Matching::new(headers)?;
        for event in &mut old {
            matching.take_old(event.map_err(ComparisonError::Old)?);
        }
        old.check_complete().map_err(ComparisonError::Old)?;
        for event in &mut new {
            matching.take_new(event.map_err(ComparisonError::New)?);
        }
        new.check_complete().map_err(ComparisonError::New)?;
        Ok(matching.finish())
    }

    /// Returns the changes of one kind.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Change> {
        self.changes.iter().filter(move |change| change.kind == kind)
    }

    /// Returns whether any case is worse in the newer run.
    pub fn is_worse(&self) -> bool {
        self.changes
            .iter()
            .any(|change| matches!(change.kind, Kind::Crashed | Kind::Broken))
    }
}

/// The state of a comparison while the runs are read: first the whole of the older one, then the newer one.
struct Matching {
    found: Comparison,
    /// The cases of the older run, by the engine's name in the newer run, then by the case's key, `id@dialect`.
    known: HashMap<String, HashMap<String, OlderCase>>,
    detailed: BTreeMap<Kind, usize>,
}

impl Matching {
    fn new((old, new): (Header, Header)) -> Result<Matching, ComparisonError> {
        if old.shard != new.shard {
            let part = |shard: &Option<String>| match shard {
                Some(shard) => format!("part {shard}"),
                None => "whole".to_owned(),
            };
            return Err(ComparisonError::Parts {
                old: part(&old.shard),
                new: part(&new.shard),
            });
        }
        let engines = pairs(&old, &new)?;
        Ok(Matching {
            found: Comparison {
                old,
                new,
                engines,
                ..Comparison::default()
            },
            known: HashMap::new(),
            detailed: BTreeMap::new(),
        })
    }

    fn take_old(&mut self, event: Event) {
        let Event::Case(case) = event else { return };
        let pair = self.found.engines.iter().find(|(old, _)| *old == case.engine);
        if let Some((_, engine)) = pair {
            let known = OlderCase::of(&case);
            let cases = self.known.entry(engine.clone()).or_default();
            cases.insert(key(&case), known);
        }
    }

    fn take_new(&mut self, event: Event) {
        let Event::Case(case) = event else { return };
        if !self.found.engines.iter().any(|(_, new)| *new == case.engine) {
            return;
        }
        let verdict = case.actual_verdict();
        let cases = self.known.get_mut(&case.engine);
        let Some(known) = cases.and_then(|cases| cases.remove(&key(&case))) else {
            return self.found.added.push(UnmatchedCase {
                id: case.id,
                dialect: case.dialect,
                engine: case.engine,
                verdict,
            });
        };
        match known.change(&case) {
            None => self.found.same += 1,
            Some(kind) => self.change(kind, known, case),
        }
    }

    fn change(&mut self, kind: Kind, known: OlderCase, case: CaseEvent) {
        let detailed = self.detailed.entry(kind).or_default();
        *detailed += 1;
        let expectation_changed = known.expects_otherwise(&case);
        let old = known.verdict;
        self.found.changes.push(Change {
            kind,
            id: case.id.clone(),
            dialect: case.dialect.clone(),
            engine: case.engine.clone(),
            old,
            new: case.actual_verdict(),
            expectation_changed,
            detail: (*detailed <= MAX_DETAILED).then(|| {
                let expected = known.expected_now(&case);
                Box::new(ComparedTexts {
                    new: older_case::said(&case, expected.as_deref()),
                    old: known.said(expected.as_deref(), expectation_changed),
                    rerun: overview::rerun(overview::named(&self.found.new.engines, &case.engine), &case),
                    expected,
                    place: case.place(),
                    title: case.title,
                    basis: case.basis,
                })
            }),
        });
    }

    fn finish(self) -> Comparison {
        let Matching { mut found, known, .. } = self;
        for (engine, cases) in known {
            let pair = found.engines.iter().find(|(_, new)| *new == engine);
            let name = pair.map_or(engine.as_str(), |(old, _)| old.as_str());
            for (key, known) in cases {
                let (id, dialect) = key.rsplit_once('@').unwrap_or((&key, ""));
                found.gone.push(UnmatchedCase {
                    id: id.to_owned(),
                    dialect: dialect.to_owned(),
                    engine: name.to_owned(),
                    verdict: known.verdict,
                });
            }
        }
        found.gone.sort_unstable();
        found
    }
}

fn key(case: &CaseEvent) -> String {
    format!("{}@{}", case.id, case.dialect)
}

/// Pairs the engines of the older run with those of the newer one: by name, or the only ones of both runs whatever their names.
fn pairs(old: &Header, new: &Header) -> Result<Vec<(String, String)>, ComparisonError> {
    if let ([old], [new]) = (&old.engines[..], &new.engines[..]) {
        return Ok(vec![(old.name.clone(), new.name.clone())]);
    }
    let in_both = |name: &&String| new.engines.iter().any(|engine| engine.name == **name);
    let names = old.engines.iter().map(|engine| &engine.name);
    let pairs: Vec<(String, String)> = names
        .filter(in_both)
        .map(|name| (name.clone(), name.clone()))
        .collect();
    if pairs.is_empty() {
        let list = |header: &Header| join(header.engines.iter().map(|engine| &engine.name), ", ");
        return Err(ComparisonError::NoEngine {
            old: list(old),
            new: list(new),
        });
    }
    Ok(pairs)
}
