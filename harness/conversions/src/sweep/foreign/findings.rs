//! The findings of a sweep through programs.

use crate::session::Refusal;
use crate::sweep::findings::{Difference, MAX_DIFFERENCES, SweepProgress};
use stickler_types::Value;

/// The maximum number of reasons that are kept apart, since a message may hold a number that is always another.
const MAX_REASONS: usize = 20;

/// The number of unanswered inputs up to which they are separated from their neighbours; beyond it, programs are given up as
/// a whole.
const MAX_SEPARATE_REFUSALS: u64 = 50;

/// Inputs that an engine did not answer for one reason.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unanswered {
    /// The reason, as the engine gave it for the first of the inputs.
    pub refusal: Refusal,
    /// The number of inputs.
    pub inputs: u64,
    /// The operands of the first of the inputs.
    pub example: Vec<Value>,
}

/// The findings of a sweep through programs, and its progress.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ForeignFindings {
    /// The number of inputs of the domain.
    pub inputs: u64,
    /// The number of inputs that were dealt with: compared, left out or unanswered.
    pub done: u64,
    /// The number of inputs that no program can make: the infinities and NaNs.
    pub left_out: u64,
    /// The number of results, among those that were observed one by one, that contradict a document.
    pub mismatches: u64,
    /// The first mismatches, at most [`MAX_DIFFERENCES`], in the order of the domain.
    pub first: Vec<Difference>,
    /// The number of results, among those that were observed one by one, that differ from exact arithmetic where no document
    /// speaks.
    pub observed: u64,
    /// The first differences where no document speaks, at most [`MAX_DIFFERENCES`], in the order of the domain.
    pub first_observed: Vec<Difference>,
    /// The number of inputs in programs with a wrong sum that were not observed one by one, where a document speaks of some of the
    /// inputs.
    pub unexamined: u64,
    /// The number of inputs in programs with a wrong sum that were not observed one by one, where no document speaks of any of the
    /// inputs.
    pub unexamined_observed: u64,
    /// The number of inputs in programs whose sum was wrong although each result alone was right.
    pub unexplained: u64,
    /// The inputs that the engine did not answer, grouped by reason.
    pub unanswered: Vec<Unanswered>,
    /// The number of programs that the engine was given.
    pub programs: u64,
}

impl ForeignFindings {
    /// Returns whether every input was dealt with.
    pub const fn is_complete(&self) -> bool {
        self.done == self.inputs
    }

    /// Returns the number of inputs that the engine answered.
    pub fn answered(&self) -> u64 {
        let unanswered: u64 = self.unanswered.iter().map(|reason| reason.inputs).sum();
        self.done.saturating_sub(self.left_out).saturating_sub(unanswered)
    }

    /// Returns whether the engine failed: a mismatch, a wrong sum where a document speaks, an unexplained sum, or a failure to
    /// answer.
    pub fn has_failures(&self) -> bool {
        let failed = |reason: &Unanswered| reason.refusal.kind.is_failure();
        self.mismatches > 0
            || self.unexamined > 0
            || self.unexplained > 0
            || self.unanswered.iter().any(failed)
    }

    /// Returns the progress of the sweep.
    pub const fn progress(&self) -> SweepProgress {
        SweepProgress {
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
        kept.truncate(MAX_DIFFERENCES);
    }

    /// Adds inputs that the engine did not answer.
    pub(super) fn refuse(&mut self, refusal: Refusal, inputs: u64, example: Vec<Value>) {
        let full = self.unanswered.len() >= MAX_REASONS;
        let position =
            |is: &dyn Fn(&Refusal) -> bool| self.unanswered.iter().position(|one| is(&one.refusal));
        let known = position(&|known| *known == refusal);
        match known.or_else(|| position(&|known| full && known.kind == refusal.kind)) {
            Some(at) => self.unanswered[at].inputs += inputs,
            None => self.unanswered.push(Unanswered {
                refusal,
                inputs,
                example,
            }),
        }
    }

    /// Returns whether the inputs that the engine does not answer are still separated from others of their program.
    pub(super) fn separates_refusals(&self) -> bool {
        let unanswered: u64 = self.unanswered.iter().map(|reason| reason.inputs).sum();
        unanswered < MAX_SEPARATE_REFUSALS
    }
}
