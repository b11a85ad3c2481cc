//! What the sweep of a foreign engine found.

use crate::session::Refusal;
use crate::sweep::findings::{Difference, KEPT};
use crate::sweep::run::Progress;
use stickler_types::Value;

/// How many reasons are told apart; a message may hold a number that is always another.
const REASONS: usize = 20;

/// So many inputs without an answer are told from their neighbours; after that, whole programs are given up.
const PATIENCE: u64 = 50;

/// Inputs that an engine did not answer for one reason.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unanswered {
    /// The reason, of the first of them.
    pub refusal: Refusal,
    /// How many they are.
    pub inputs: u64,
    /// The operands of the first of them.
    pub example: Vec<Value>,
}

/// What was found, and how far the sweep came.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ForeignFindings {
    /// All inputs of the domain.
    pub inputs: u64,
    /// Those that were dealt with, in whatever way.
    pub done: u64,
    /// Those of them that no program can make: the infinities and NaNs.
    pub left_out: u64,
    /// Results that are not what a document says; of those looked at one by one.
    pub mismatches: u64,
    /// The first of these, at most [`KEPT`], in the order of the domain.
    pub first: Vec<Difference>,
    /// Results that differ from those of exact arithmetic where no document speaks; of those looked at one by one.
    pub observed: u64,
    /// The first of these, likewise.
    pub first_observed: Vec<Difference>,
    /// Inputs of programs whose sum was wrong and that nobody looked into any more, where a document speaks of some.
    pub unopened: u64,
    /// The same, where no document speaks of any of them.
    pub unopened_observed: u64,
    /// Inputs of programs whose sum was wrong although each result alone was right.
    pub unexplained: u64,
    /// What the engine did not answer, by reason.
    pub unanswered: Vec<Unanswered>,
    /// How many programs the engine was given.
    pub programs: u64,
}

impl ForeignFindings {
    /// Whether every input was dealt with.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.done == self.inputs
    }

    /// Inputs that the engine answered.
    #[must_use]
    pub fn answered(&self) -> u64 {
        let unanswered: u64 = self.unanswered.iter().map(|reason| reason.inputs).sum();
        self.done.saturating_sub(self.left_out).saturating_sub(unanswered)
    }

    /// Whether the engine did something that no document lets it do: a mismatch, a wrong sum, a crash.
    #[must_use]
    pub fn has_failures(&self) -> bool {
        let failed = |reason: &Unanswered| reason.refusal.kind.is_failure();
        self.mismatches > 0 || self.unopened > 0 || self.unexplained > 0 || self.unanswered.iter().any(failed)
    }

    /// How far the sweep is.
    #[must_use]
    pub const fn progress(&self) -> Progress {
        Progress {
            done: self.done,
            mismatches: self.mismatches,
        }
    }

    /// Adds a difference, which is a mismatch where it has a basis.
    pub(super) fn differ(&mut self, difference: Difference) {
        let (count, kept) = match difference.basis {
            Some(_) => (&mut self.mismatches, &mut self.first),
            None => (&mut self.observed, &mut self.first_observed),
        };
        *count += 1;
        let at = kept.partition_point(|earlier| earlier.place <= difference.place);
        kept.insert(at, difference);
        kept.truncate(KEPT);
    }

    /// Adds inputs that were not answered.
    pub(super) fn refuse(&mut self, refusal: Refusal, inputs: u64, example: Vec<Value>) {
        let known = |reason: &&mut Unanswered| reason.refusal == refusal;
        let full = self.unanswered.len() >= REASONS;
        let same = |reason: &&mut Unanswered| full && reason.refusal.kind == refusal.kind;
        if let Some(reason) = self.unanswered.iter_mut().find(known) {
            reason.inputs += inputs;
        } else if let Some(reason) = self.unanswered.iter_mut().find(same) {
            reason.inputs += inputs;
        } else {
            self.unanswered.push(Unanswered {
                refusal,
                inputs,
                example,
            });
        }
    }

    /// Whether it is still worth while to find out which inputs of a program the engine does not answer.
    pub(super) fn is_patient(&self) -> bool {
        let unanswered: u64 = self.unanswered.iter().map(|reason| reason.inputs).sum();
        unanswered < PATIENCE
    }
}
