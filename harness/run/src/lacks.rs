//! The features of the language that an engine lacks, and the cases that wait for them.
//!
//! A partial compiler refuses each program that uses what it does not have. So before the first case an engine is
//! [asked](survey()) for the minimal programs of the features that the selected cases use, and for the [counterparts](counterparts)
//! of programs that it must reject. A feature whose program is refused is judged once, by what promises it; a refused case that
//! uses it is waiting. Where the engine does something else than to refuse the program of a case, the case is judged like any other,
//! so that waiting hides no wrong value, no crash and no mistake that the engine does not find.

mod counterparts;
mod report;
mod survey;

pub(crate) use report::WaitingCases;
pub(crate) use survey::{Survey, survey};

use crate::{Fact, Verdict};
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use stickler_engines::Outcome;
use stickler_suite::{Acceptance, Case, Feature, FeatureKey};
use stickler_types::{DialectName, ElementaryType};

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
