//! Gathers the findings while a case is judged.

use crate::{Fact, Verdict};

/// The actual facts of a case, and whether they meet the expectation.
pub(super) struct Findings {
    got: Vec<Fact>,
    met: bool,
    supported: bool,
}

impl Default for Findings {
    fn default() -> Findings {
        Findings {
            got: Vec::new(),
            met: true,
            supported: true,
        }
    }
}

impl Findings {
    /// Adds an actual fact.
    pub(super) fn add(&mut self, fact: Fact) {
        self.got.push(fact);
    }

    /// Fails the case unless the condition holds.
    pub(super) fn require(&mut self, holds: bool) {
        self.met &= holds;
    }

    /// Records that the engine does not support a part of the case.
    pub(super) fn unsupported(&mut self) {
        self.supported = false;
    }

    /// Returns the verdict and the actual facts.
    pub(super) fn finish(self) -> (Verdict, Vec<Fact>) {
        let verdict = match (self.met, self.supported) {
            (false, _) => Verdict::Fail,
            (true, false) => Verdict::Unsupported,
            (true, true) => Verdict::Pass,
        };
        (verdict, self.got)
    }
}
