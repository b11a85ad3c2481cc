//! The verdict on a case, and how often each verdict came.

use serde::{Deserialize, Serialize};
use std::iter::Sum;
use std::ops::AddAssign;
use stickler_types::{join, words};

words! {
    /// The verdict on the result of a case on an engine. Basis: reports/README.md (the words).
    #[derive(Default, Serialize, Deserialize)]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[serde(rename_all = "lowercase")]
    Verdict {
        /// The engine met the expectation.
        #[default]
        Pass = "pass",
        /// The engine did not meet an expectation that binds it.
        Fail = "fail",
        /// The engine did not meet an expectation that does not bind it: it comes from a rule of Stickler, or from a source that
        /// speaks for other engines.
        Differs = "differs",
        /// The case did not pass, as a baseline expects.
        Xfail = "xfail",
        /// The case passed, although a baseline expects that it does not.
        Xpass = "xpass",
        /// The engine states that it does not support what the case needs.
        Unsupported = "unsupported",
        /// The case says nothing of the engine, which lacks a feature of the language that the program uses.
        Waiting = "waiting",
        /// The engine crashed or panicked.
        Crash = "crash",
        /// The engine gave no answer in time.
        Timeout = "timeout",
        /// The engine did not understand a request, or its answer is invalid.
        Error = "error",
    }
}

impl Verdict {
    /// Joins alternative verdicts for people: `fail or crash`.
    pub fn any_of(verdicts: &[Verdict]) -> String {
        join(verdicts, " or ")
    }

    /// Returns whether a run with this verdict in it is still as expected. An unexpected pass is not: its baseline is stale.
    pub const fn is_as_expected(self) -> bool {
        matches!(
            self,
            Verdict::Pass | Verdict::Differs | Verdict::Xfail | Verdict::Unsupported | Verdict::Waiting
        )
    }

    /// Returns whether the engine did something else than the case expects. An engine that does not support a case did nothing.
    pub const fn is_discrepancy(self) -> bool {
        matches!(
            self,
            Verdict::Fail
                | Verdict::Differs
                | Verdict::Xfail
                | Verdict::Crash
                | Verdict::Timeout
                | Verdict::Error
        )
    }
}

/// The number of times that each verdict came.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Totals {
    /// The number of [`Verdict::Pass`].
    pub pass: u64,
    /// The number of [`Verdict::Fail`].
    pub fail: u64,
    /// The number of [`Verdict::Differs`].
    #[serde(default)]
    pub differs: u64,
    /// The number of [`Verdict::Xfail`].
    pub xfail: u64,
    /// The number of [`Verdict::Xpass`].
    pub xpass: u64,
    /// The number of [`Verdict::Unsupported`].
    pub unsupported: u64,
    /// The number of [`Verdict::Waiting`].
    #[serde(default)]
    pub waiting: u64,
    /// The number of [`Verdict::Crash`].
    pub crash: u64,
    /// The number of [`Verdict::Timeout`].
    pub timeout: u64,
    /// The number of [`Verdict::Error`].
    pub error: u64,
}

impl Totals {
    /// Adds one verdict to the counts.
    pub fn count(&mut self, verdict: Verdict) {
        *self.counter(verdict) += 1;
    }

    /// Returns the number of times that this verdict came.
    pub fn of(mut self, verdict: Verdict) -> u64 {
        *self.counter(verdict)
    }

    /// Returns the number of all verdicts.
    pub fn all(&self) -> u64 {
        Verdict::ALL.iter().map(|&verdict| self.of(verdict)).sum()
    }

    /// Returns the number of verdicts that are not as expected.
    pub fn unexpected(&self) -> u64 {
        let unexpected = Verdict::ALL.iter().filter(|verdict| !verdict.is_as_expected());
        unexpected.map(|&verdict| self.of(verdict)).sum()
    }

    fn counter(&mut self, verdict: Verdict) -> &mut u64 {
        match verdict {
            Verdict::Pass => &mut self.pass,
            Verdict::Fail => &mut self.fail,
            Verdict::Differs => &mut self.differs,
            Verdict::Xfail => &mut self.xfail,
            Verdict::Xpass => &mut self.xpass,
            Verdict::Unsupported => &mut self.unsupported,
            Verdict::Waiting => &mut self.waiting,
            Verdict::Crash => &mut self.crash,
            Verdict::Timeout => &mut self.timeout,
            Verdict::Error => &mut self.error,
        }
    }
}

impl AddAssign for Totals {
    fn add_assign(&mut self, other: Totals) {
        for verdict in Verdict::ALL {
            *self.counter(verdict) += other.of(verdict);
        }
    }
}

impl<'a> Sum<&'a Totals> for Totals {
    fn sum<I: Iterator<Item = &'a Totals>>(all: I) -> Totals {
        all.fold(Totals::default(), |mut sum, totals| {
            sum += *totals;
            sum
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_have_one_spelling() {
        for verdict in Verdict::ALL {
            assert_eq!(serde_json::to_string(&verdict).unwrap(), format!("\"{verdict}\""));
        }
    }

    #[test]
    fn totals_count_each_verdict_apart_and_know_what_is_unexpected() {
        let mut totals = Totals::default();
        for (times, verdict) in Verdict::ALL.into_iter().enumerate() {
            (0..=times).for_each(|_| totals.count(verdict));
        }
        assert_eq!((totals.pass, totals.fail, totals.error), (1, 2, 10));
        assert_eq!(totals.all(), 55);
        assert_eq!(totals.unexpected(), 55 - 1 - 3 - 4 - 6 - 7);
        let mut twice = totals;
        twice += totals;
        assert_eq!(twice.all(), 110);
    }
}
