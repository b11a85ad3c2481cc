//! Compares expected values with actual ones: exactly, but where the expectation allows for units in the last place.

use super::Findings;
use crate::{Fact, Observed};
use stickler_engines::NamedValue;
use stickler_suite::{Case, ExpectedValue};
use stickler_types::{ObservationKey, Value};

/// A search for values by key. Engines answer in the order of the requested values, so each search continues where the last
/// one ended, and all of them together take linear time.
struct ValueFinder<'a> {
    values: &'a [NamedValue],
    next: usize,
}

impl<'a> ValueFinder<'a> {
    fn new(values: &'a [NamedValue]) -> ValueFinder<'a> {
        ValueFinder { values, next: 0 }
    }

    fn find(&mut self, key: ObservationKey<'_>) -> Option<&'a Value> {
        let (before, after) = self.values.split_at(self.next);
        let at = after.iter().chain(before).position(|(name, _)| key.is(name))?;
        let at = (self.next + at) % self.values.len();
        self.next = (at + 1) % self.values.len();
        Some(&self.values[at].1)
    }
}

/// Returns an expected value as a fact.
pub(super) fn expected(expected: &ExpectedValue) -> Fact {
    Fact::Value {
        name: expected.key().to_string(),
        value: expected.value.clone(),
    }
}

/// Compares each expected value with the engine's, and adds the latter to the findings.
pub(super) fn compare(expected: &[ExpectedValue], values: &[NamedValue], findings: &mut Findings) {
    let mut finder = ValueFinder::new(values);
    for expected in expected {
        let key = expected.key();
        let name = key.to_string();
        let found = finder.find(key);
        findings.require(found.is_some_and(|found| expected.value.admits(found)));
        findings.add(match found.cloned() {
            Some(value) => Fact::Value { name, value },
            None => Fact::MissingValue { name },
        });
    }
}

/// Adds the requested values that the case does not assert to the observations.
pub(super) fn unasserted(case: &Case, values: &[NamedValue], observations: &mut Vec<Observed>) {
    let asserted = |key| case.expectation.values.iter().any(|value| value.key() == key);
    let mut finder = ValueFinder::new(values);
    for observe in case.observe.iter() {
        let key = observe.key();
        if asserted(key) {
            continue;
        }
        if let Some(value) = finder.find(key) {
            observations.push(Observed {
                name: key.to_string(),
                value: value.to_string(),
            });
        }
    }
}
