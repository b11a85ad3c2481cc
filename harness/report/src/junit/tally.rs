//! The JUnit test of several cases of a probe with one verdict.

use super::case::kind;
use super::suite::{add, problem};
use crate::groups::Group;
use quick_junit::{TestCase, TestCaseStatus, TestSuite};
use stickler_run::{CaseEvent, Fact, Verdict};
use stickler_types::counted;

/// The number of cases with one verdict, and the sums of their observations and times.
#[derive(Default)]
pub(super) struct ProbeTally {
    cases: u64,
    observations: u64,
    microseconds: u64,
    /// The text of the first case's actual facts; empty where the cases passed.
    got: String,
}

impl ProbeTally {
    /// Adds a case.
    pub(super) fn take(&mut self, case: &CaseEvent) {
        self.add(ProbeTally {
            cases: 1,
            observations: case.observations.len() as u64,
            microseconds: case.duration_us,
            got: match case.verdict {
                Verdict::Unsupported | Verdict::Waiting if self.cases == 0 => Fact::text(&case.got),
                _ => String::new(),
            },
        });
    }

    /// Adds the cases of another tally.
    pub(super) fn add(&mut self, other: ProbeTally) {
        if self.cases == 0 {
            self.got = other.got;
        }
        self.cases += other.cases;
        self.observations += other.observations;
        self.microseconds += other.microseconds;
    }

    /// Adds the test of the cases of a probe with this verdict to a suite; nothing where there are none.
    pub(super) fn add_test(&self, suite: &mut TestSuite, group: &Group, verdict: Verdict) {
        if self.cases == 0 {
            return;
        }
        let status = kind(verdict).map(|(status, message)| {
            let cases = counted(self.cases, "case", "cases");
            let message = format!("{message} ({cases}): {}", group.title);
            problem(status, verdict.as_str(), &message, &self.got)
        });
        let mut test = TestCase::new(&*group.id, status.unwrap_or_else(TestCaseStatus::success));
        for (name, number) in [("cases", self.cases), ("observations", self.observations)] {
            if number > 0 {
                test.add_property((name.to_owned(), number.to_string()));
            }
        }
        add(suite, test, self.microseconds);
    }
}
