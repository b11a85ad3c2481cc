//! Compares expected values with actual ones, exactly.

use super::findings::Findings;
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
        findings.require(found == Some(&expected.value));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;

    fn expect(name: &str, after: Option<u32>, literal: &str) -> ExpectedValue {
        ExpectedValue {
            name: name.into(),
            after,
            value: Value::parse(literal).unwrap(),
            line: 1,
        }
    }

    fn judged(expected: &[ExpectedValue], values: &[(&str, &str)]) -> (Verdict, String) {
        let values: Vec<NamedValue> = values
            .iter()
            .map(|&(name, literal)| (name.to_owned(), Value::parse(literal).unwrap()))
            .collect();
        let mut findings = Findings::default();
        compare(expected, &values, &mut findings);
        let (verdict, got) = findings.finish();
        (verdict, Fact::text(&got))
    }

    #[test]
    fn values_are_found_by_name_and_scan_in_any_order() {
        let expected = [
            expect("q", None, "INT#1"),
            expect("q", Some(3), "INT#2"),
            expect("a[1]", None, "INT#3"),
        ];
        let found = [("a[1]", "INT#3"), ("q@3", "INT#2"), ("q", "INT#1")];
        let (verdict, got) = judged(&expected, &found);
        assert_eq!(
            (verdict, got.as_str()),
            (Verdict::Pass, "q = INT#1\nq@3 = INT#2\na[1] = INT#3")
        );
    }

    #[test]
    fn a_value_of_another_type_or_another_sign_of_zero_is_another_value() {
        assert_eq!(
            judged(&[expect("q", None, "INT#1")], &[("q", "DINT#1")]).0,
            Verdict::Fail
        );
        assert_eq!(
            judged(&[expect("q", None, "REAL#0.0")], &[("q", "REAL#-0.0")]).0,
            Verdict::Fail
        );
        assert_eq!(
            judged(&[expect("q", None, "REAL#NaN")], &[("q", "REAL#NaN")]).0,
            Verdict::Pass
        );
    }

    #[test]
    fn a_value_that_did_not_come_fails() {
        for found in [&[][..], &[("q@3", "INT#1")], &[("q2", "INT#1")]] {
            let (verdict, got) = judged(&[expect("q", None, "INT#1")], found);
            assert_eq!((verdict, got.as_str()), (Verdict::Fail, "q is missing"));
        }
        assert_eq!(
            judged(&[expect("q", Some(3), "INT#1")], &[("q", "INT#1")]).0,
            Verdict::Fail
        );
    }
}
