//! Gathers the failing cases of a run in groups that most probably have one cause.

use crate::shape::types_of;
use crate::sign::Sign;
use std::collections::BTreeMap;
use stickler_engines::Reference;
use stickler_run::{CaseEvent, Event, ExplainedCases, Grade};

/// The maximum number of groups; cases of further kinds are not explained.
const MAX_GROUPS: usize = 4000;

/// The failing cases of a run, in groups with the same symptom and programs of the same shape.
///
/// Of each group only the smallest program is kept, and one with other types, so that memory does not grow with the number
/// of cases. The cases of the reference are left out: it must meet every case, and no maker of it waits for pages.
#[derive(Debug, Default)]
pub struct FailedCases {
    /// How strictly each engine is judged.
    strict: BTreeMap<String, Grade>,
    pub(crate) groups: BTreeMap<(String, Sign, String), Group>,
}

/// A group of failing cases.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub(crate) shown: CaseEvent,
    /// The case with the smallest program that has other types than the shown one.
    pub(crate) second: Option<CaseEvent>,
    pub(crate) cases: Vec<ExplainedCases>,
}

impl FailedCases {
    /// Adds an event of the run; those that are no failing cases add nothing.
    pub fn take(&mut self, event: &Event) {
        match event {
            Event::Header(header) => {
                let engines = header.engines.iter();
                let foreign = engines.filter(|engine| engine.name != Reference::NAME);
                self.strict = foreign
                    .map(|engine| (engine.name.clone(), engine.strict))
                    .collect();
            }
            Event::Case(case) => self.take_case(case),
            Event::Cause(_) | Event::Footer(_) => {}
        }
    }

    /// Returns whether no failing case came.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.groups.is_empty()
    }

    fn take_case(&mut self, case: &CaseEvent) {
        // Only a case that did not come out as expected has a program.
        let (Some(program), Some(&strict)) = (&case.program, self.strict.get(&case.engine)) else {
            return;
        };
        let verdict = case.actual_verdict();
        if !verdict.is_discrepancy() {
            return;
        }
        let sign = Sign::of(program, verdict, (&case.expected, &case.got), strict);
        let shape = sign.shape(program);
        let key = (case.engine.clone(), sign, shape);
        if self.groups.len() >= MAX_GROUPS && !self.groups.contains_key(&key) {
            return;
        }
        let group = self.groups.entry(key).or_insert_with(|| Group {
            shown: case.clone(),
            second: None,
            cases: Vec::new(),
        });
        group.take(case);
    }
}

impl Group {
    fn take(&mut self, case: &CaseEvent) {
        let some = ExplainedCases {
            probe: case.id.split('(').next().unwrap_or_default().to_owned(),
            dialect: case.dialect.clone(),
            basis: case.basis.clone(),
            verdict: case.verdict,
            cases: 1,
        };
        ExplainedCases::add(&mut self.cases, some);
        let mut other = case;
        let former;
        if rank(case) < rank(&self.shown) {
            former = std::mem::replace(&mut self.shown, case.clone());
            other = &former;
        }
        let is_second = match &self.second {
            Some(second) => rank(other) < rank(second) || types(second) == types(&self.shown),
            None => true,
        };
        if is_second && types(other) != types(&self.shown) {
            self.second = Some(other.clone());
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

fn types(case: &CaseEvent) -> Vec<&'static str> {
    types_of(case.program.as_deref().unwrap_or_default())
}
