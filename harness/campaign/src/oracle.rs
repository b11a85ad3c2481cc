//! The trait [`Oracle`], which a campaign asks to judge inputs and to reduce what it finds.

use crate::finding::{Finding, kind};
use stickler_engines::EngineError;

/// A judge of inputs, which are named by their places in the row of a seed. It is shared by all workers.
pub trait Oracle: Sync {
    /// Returns a worker with engine sessions of its own. Called once on each thread.
    ///
    /// # Errors
    /// [`EngineError`] where an engine cannot be started.
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError>;
}

/// A worker of an [`Oracle`], which judges inputs one after the other.
pub trait Worker {
    /// Judges the inputs at these places, in order. When `going` becomes false, the rest is left: then the answer is shorter.
    ///
    /// The verdict on a place depends on nothing but the place and what the engines do: not on the places before it, nor on
    /// how many are asked for at a time.
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<InputVerdict>;

    /// Reduces a mismatch and runs it once more. When `going` becomes false, the smallest so far is given.
    fn reduce(&mut self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding;

    /// Returns which engine can no longer be used, and why; asked after each task.
    fn lost(&self) -> Option<String> {
        None
    }
}

/// The verdict on one input.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct InputVerdict {
    /// The place of the input in the row of the seed.
    pub place: u64,
    /// The reason for which the input was not judged, where it was not.
    pub passed_over: Option<&'static str>,
    /// The disagreements over the input, one for each subject.
    pub mismatches: Vec<Mismatch>,
    /// The number of times that an engine died or hung over the input and was started anew.
    pub deaths: u64,
}

/// A disagreement over an input, before it is reduced.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Mismatch {
    /// The place of the input.
    pub place: u64,
    /// The name of the engine that disagrees, or of the target that asked the reference.
    pub subject: String,
    /// The symptom in a word, such as `value:INT` or `crash`.
    pub symptom: String,
    /// The features of the language that the input uses, as [`Finding::rule`] has them; none where the input is no program.
    pub rule: Vec<String>,
    /// The number of bytes of the input, or of its text where it is a program.
    pub size: usize,
}

impl Mismatch {
    /// Returns whether a finding probably has the same cause: the program contains all that is wrong in that one.
    pub(crate) fn is_explained_by(&self, finding: &Finding) -> bool {
        finding.subject() == self.subject
            && finding.kind() == kind(&self.symptom)
            && !finding.rule.is_empty()
            && finding.rule.iter().all(|part| self.rule.contains(part))
    }
}
