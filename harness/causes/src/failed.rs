//! Gathers the failing cases of a run in groups that most probably have one cause.

use crate::failure_sign::Sign;
use std::collections::{BTreeMap, BTreeSet};
use stickler_engines::{Engine, Identity, Reference};
use stickler_run::{CaseEvent, Event, ExplainedCases, Plan};

/// The maximum number of groups; cases of further kinds are not explained.
const MAX_GROUPS: usize = 12_000;

/// The failing cases of a run, in groups with the same symptom and programs of the same shape.
///
/// Of each group only the smallest program is kept, so that memory does not grow with the number of cases. The cases of the reference are
/// left out: it must meet every case, and no maker of it waits for pages.
#[derive(Debug)]
pub struct FailedCases<'r> {
    plan: &'r Plan,
    /// The engines of the run that are compilers, by name.
    engines: BTreeMap<&'r str, &'r Identity>,
    pub(crate) groups: BTreeMap<(String, Sign, String), FailureGroup>,
    /// The features that engines lack.
    pub(crate) lacked: LackedFeatures,
}

/// The keys of the features that engines lack in one of their dialects, by engine. In another dialect no case may have asked for them.
pub(crate) type LackedFeatures = BTreeMap<String, BTreeSet<String>>;

/// A group of failing cases.
#[derive(Clone, Debug)]
pub(crate) struct FailureGroup {
    pub(crate) shown: CaseEvent,
    pub(crate) cases: Vec<ExplainedCases>,
    /// The arguments that the ids of all cases have, such as the names of places.
    pub(crate) shared: BTreeSet<String>,
}

impl<'r> FailedCases<'r> {
    /// Creates groups without cases, for the run of this plan on these engines.
    pub fn new(plan: &'r Plan, engines: &[&'r dyn Engine]) -> FailedCases<'r> {
        let identities = engines.iter().map(|engine| engine.identity());
        let compilers = identities.filter(|identity| identity.name != Reference::NAME);
        FailedCases {
            plan,
            engines: compilers
                .map(|identity| (identity.name.as_str(), identity))
                .collect(),
            groups: BTreeMap::new(),
            lacked: BTreeMap::new(),
        }
    }

    /// Adds an event of the run: a failing case, or a feature that an engine lacks. Others add nothing.
    pub fn take(&mut self, event: &Event) {
        match event {
            Event::Case(case) => self.take_case(case),
            Event::Cause(cause) if cause.is_lack() => {
                let lacked = self.lacked.entry(cause.engine.clone()).or_default();
                lacked.insert(cause.construct.clone());
            }
            _ => {}
        }
    }

    /// Returns whether no failing case came.
    pub fn is_empty(&self) -> bool {
        self.groups.is_empty()
    }

    fn take_case(&mut self, case: &CaseEvent) {
        // Only a case that did not come out as expected has a program.
        let engine = self.engines.get(case.engine.as_str());
        let (Some(program), Some(engine)) = (&case.program, engine) else {
            return;
        };
        let verdict = case.actual_verdict();
        if !verdict.is_discrepancy() {
            return;
        }
        let codes = case
            .expected
            .iter()
            .filter_map(|fact| fact.diagnostic()?.registered_code());
        let strict = self.plan.needed_for(engine, &case.basis, codes);
        let sign = Sign::of(program, verdict, (&case.expected, &case.got), strict);
        let shape = sign.shape(program);
        let key = (case.engine.clone(), sign, shape);
        if self.groups.len() >= MAX_GROUPS && !self.groups.contains_key(&key) {
            return;
        }
        let group = self.groups.entry(key).or_insert_with(|| FailureGroup {
            shown: case.clone(),
            cases: Vec::new(),
            shared: arguments(&case.id),
        });
        group.take(case);
    }
}

impl FailureGroup {
    fn take(&mut self, case: &CaseEvent) {
        let some = ExplainedCases {
            probe: case.id.split('(').next().unwrap_or_default().to_owned(),
            dialect: case.dialect.clone(),
            basis: case.basis.clone(),
            verdict: case.verdict,
            cases: 1,
        };
        ExplainedCases::add(&mut self.cases, some);
        let of_case = arguments(&case.id);
        self.shared.retain(|argument| of_case.contains(argument));
        if rank(case) < rank(&self.shown) {
            self.shown = case.clone();
        }
    }

    /// Returns the number of cases in the group.
    pub(crate) fn number(&self) -> u64 {
        self.cases.iter().map(|some| some.cases).sum()
    }
}

/// Returns the rank of a case as the one that is shown: a failure before a difference that no document forbids, then the
/// smaller program.
fn rank(case: &CaseEvent) -> (bool, usize) {
    let program = case.program.as_deref().unwrap_or_default();
    (case.verdict.is_as_expected(), program.len())
}

/// Returns the arguments of a case's id: `a` and `b` of `folder/file::probe(a,b)`.
fn arguments(id: &str) -> BTreeSet<String> {
    let inside = id
        .split_once('(')
        .and_then(|(_, behind)| behind.strip_suffix(')'));
    inside
        .into_iter()
        .flat_map(|all| all.split(','))
        .map(str::to_owned)
        .collect()
}
