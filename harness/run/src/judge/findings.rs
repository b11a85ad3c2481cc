//! The findings of a judgement while it is made.

use crate::{Fact, Verdict};

/// Gathers what an engine did, and whether that meets the expectation.
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
    /// Adds something that the engine did.
    pub(super) fn add(&mut self, fact: Fact) {
        self.got.push(fact);
    }

    /// Fails the case unless the condition holds.
    pub(super) fn require(&mut self, holds: bool) {
        self.met &= holds;
    }

    /// Notes that the engine could not answer a part of the case.
    pub(super) fn unsupported(&mut self) {
        self.supported = false;
    }

    /// Returns the verdict, and what the engine did.
    pub(super) fn finish(self) -> (Verdict, Vec<Fact>) {
        let verdict = match (self.met, self.supported) {
            (false, _) => Verdict::Fail,
            (true, false) => Verdict::Unsupported,
            (true, true) => Verdict::Pass,
        };
        (verdict, self.got)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_met_fails_whatever_else_was_unsupported() {
        let mut findings = Findings::default();
        findings.unsupported();
        findings.require(true);
        assert_eq!(findings.finish().0, Verdict::Unsupported);
        let mut findings = Findings::default();
        findings.unsupported();
        findings.require(false);
        assert_eq!(findings.finish().0, Verdict::Fail);
    }
}
