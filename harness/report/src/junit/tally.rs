//! The JUnit test of several cases of a probe with one verdict.

use super::case::kind;
use super::suite::{JunitTest, Problem};
use crate::groups::Group;
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

    /// Returns the test of the cases of a probe with this verdict; `None` where there are none.
    pub(super) fn tests<'g>(&self, group: &'g Group, verdict: Verdict) -> Option<JunitTest<'g>> {
        let problem = kind(verdict).map(|(kind, message)| {
            let cases = counted(self.cases, "case", "cases");
            Problem {
                kind,
                type_name: verdict.as_str(),
                message: format!("{message} ({cases}): {}", group.title),
                text: self.got.clone(),
            }
        });
        let properties = [("cases", self.cases), ("observations", self.observations)];
        (self.cases > 0).then(|| JunitTest {
            name: &group.id,
            microseconds: self.microseconds,
            problem,
            properties: properties.into_iter().filter(|(_, number)| *number > 0).collect(),
            ..JunitTest::default()
        })
    }
}
