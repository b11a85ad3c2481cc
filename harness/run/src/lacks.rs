//! The features of the language that an engine lacks, and the cases that wait for them.
//!
//! A partial compiler refuses each program that uses what it does not have. So before the first case an engine is
//! [asked](survey()) for the minimal programs of the features that the selected cases use, and for the [counterparts](counterparts())
//! of programs that it must reject. A feature whose program is refused is judged once, by what promises it; a refused case that
//! uses it is waiting. Where the engine does something else than to refuse the program of a case, the case is judged like any other,
//! so that waiting hides no wrong value, no crash and no mistake that the engine does not find.

mod report;
mod survey;

use crate::{Fact, Verdict};
pub(crate) use report::WaitingCases;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use stickler_engines::Outcome;
use stickler_suite::{Acceptance, Case, Feature, FeatureKey};
use stickler_types::{DialectName, ElementaryType};
pub(crate) use survey::{Survey, survey};

/// What one engine of a run does not take.
#[derive(Clone, Debug, Default)]
pub struct Lacks<'s> {
    /// By dialect, the features that the engine lacks although it has all that they need, in the order of the list.
    features: BTreeMap<DialectName, Vec<LackedFeature<'s>>>,
    /// The cases that the engine must reject and whose counterpart it refuses too, by id and dialect, with the id of the counterpart.
    refused_counterparts: HashMap<(&'s str, DialectName), &'s str>,
}

/// A feature that an engine lacks in a dialect.
#[derive(Clone, Debug)]
struct LackedFeature<'s> {
    feature: &'s Feature,
    /// The verdict on the minimal program: [`Verdict::Unsupported`] where nobody promises the feature.
    verdict: Verdict,
    /// The basis that promises the feature; empty where nobody does.
    basis: Cow<'s, str>,
    /// What the engine did with the minimal program.
    got: Vec<Fact>,
}

impl Lacks<'_> {
    /// Returns what a case waits for, by what the engine did with its program and the verdict on that; nothing where the case tells
    /// something of the engine. `is_promised` says whether a document promises the engine that it accepts the program.
    pub(crate) fn waits_for(
        &self,
        case: &Case,
        (run, verdict): (&Outcome, Verdict),
        is_promised: impl Fn() -> bool,
    ) -> Vec<Fact> {
        let Some(refusal) = Refusal::of(run) else {
            return Vec::new();
        };
        let features = self.features.get(&case.dialect);
        let used = features.map(|_| case.features()).unwrap_or_default();
        let is_missed = |lacked: &&LackedFeature<'_>| {
            // A crash tells something where the minimal program gives another answer.
            used.contains(&*lacked.feature.key) && (refusal == Refusal::Stated || lacked.verdict == verdict)
        };
        let missed: Vec<&LackedFeature<'_>> = features.into_iter().flatten().filter(is_missed).collect();
        let is_only = |feature: &Feature| {
            let is_its_own =
                |key: &FeatureKey| **key == *feature.key || feature.needs.iter().any(|need| need == key);
            missed.len() == 1 && used.iter().all(|key| is_its_own(key) || is_type(key))
        };
        let fact = |lacked: &&LackedFeature<'_>| Fact::Lacks {
            feature: lacked.feature.key.clone(),
            title: lacked.feature.title.clone(),
            promised_by: (is_only(lacked.feature) && is_promised()).then(|| case.basis.to_string()),
        };
        let mut facts: Vec<Fact> = missed.iter().map(fact).collect();
        let must_be_rejected = case.expectation.accepted == Acceptance::Rejected;
        if facts.is_empty() && must_be_rejected && verdict == Verdict::Pass {
            let counterpart = self.refused_counterparts.get(&(&*case.id, case.dialect));
            facts.extend(counterpart.map(|case| Fact::RejectsAlso {
                case: (*case).to_owned(),
            }));
        }
        facts
    }
}

/// Returns whether a feature is an elementary type.
fn is_type(key: &str) -> bool {
    ElementaryType::from_name(&key.to_ascii_uppercase()).is_some()
}

/// The way in which an engine does not take a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Refusal {
    /// The engine says so.
    Stated,
    /// The engine crashes, gives no answer in time, or answers nonsense.
    Failed,
}

impl Refusal {
    fn of(run: &Outcome) -> Option<Refusal> {
        match run {
            Outcome::Rejected { .. } | Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => {
                Some(Refusal::Stated)
            }
            Outcome::Crashed { .. } | Outcome::TimedOut { .. } | Outcome::Error { .. } => {
                Some(Refusal::Failed)
            }
            Outcome::Accepted { .. }
            | Outcome::Executed { .. }
            | Outcome::Faulted { .. }
            | Outcome::Rendered { .. }
            | Outcome::Unusable { .. } => None,
        }
    }
}

/// The features that programs use, each with the cases that use just these.
type CasesByFeatures<'s> = BTreeMap<BTreeSet<FeatureKey>, Vec<&'s Case>>;

/// A case without a mistake, with the cases whose counterpart it is.
type Counterpart<'s> = (&'s Case, Vec<&'s Case>);

/// Returns the counterparts of those of the `selected` cases that must be rejected: of the cases `beside` them of the same file and dialect,
/// which must be accepted, the one whose constructs differ least, elementary types aside. A case whose file has none has no counterpart.
fn counterparts<'s>(selected: &CasesByFeatures<'s>, beside: &CasesByFeatures<'s>) -> Vec<Counterpart<'s>> {
    let mut accepted: HashMap<FileKey<'_>, BTreeMap<Constructs<'_>, &'s Case>> = HashMap::new();
    for (constructs, case) in by_constructs(beside) {
        let of_file = accepted.entry(file_key(case)).or_default();
        let shortest = of_file.entry(constructs).or_insert(case);
        if case.source.len() < shortest.source.len() {
            *shortest = case;
        }
    }
    let mut rejected: BTreeMap<(FileKey<'_>, Constructs<'_>), Vec<&'s Case>> = BTreeMap::new();
    let must_be = |(_, case): &(_, &Case)| case.expectation.accepted == Acceptance::Rejected;
    for (constructs, case) in by_constructs(selected).filter(must_be) {
        rejected
            .entry((file_key(case), constructs))
            .or_default()
            .push(case);
    }
    let mut found: BTreeMap<(&str, DialectName), Counterpart<'s>> = BTreeMap::new();
    for ((file, constructs), rejected) in rejected {
        let unlikeness = |(of, case): &(&Constructs<'_>, &&Case)| {
            (of.symmetric_difference(&constructs).count(), case.source.len())
        };
        let beside = accepted.get(&file).into_iter().flatten();
        if let Some((_, counterpart)) = beside.min_by_key(unlikeness) {
            let of = found.entry((&counterpart.id, counterpart.dialect));
            of.or_insert((counterpart, Vec::new())).1.extend(rejected);
        }
    }
    found.into_values().collect()
}

/// The case file and the dialect of a case.
type FileKey<'k> = (&'k str, DialectName);

fn file_key(case: &Case) -> FileKey<'_> {
    (&case.file, case.dialect)
}

/// The features that a program uses, but for the elementary types.
type Constructs<'k> = BTreeSet<&'k str>;

fn by_constructs<'k, 's>(cases: &'k CasesByFeatures<'s>) -> impl Iterator<Item = (Constructs<'k>, &'s Case)> {
    cases.iter().flat_map(|(features, cases)| {
        let constructs: Constructs<'k> = features
            .iter()
            .map(|key| &**key)
            .filter(|key| !is_type(key))
            .collect();
        cases.iter().map(move |&case| (constructs.clone(), case))
    })
}
