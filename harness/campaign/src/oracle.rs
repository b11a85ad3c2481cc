//! What a campaign asks: something that judges inputs by their places, and makes small what it finds.

use crate::finding::Finding;
use stickler_engines::EngineError;

/// What inputs are held against; shared by all workers.
pub trait Oracle: Sync {
    /// Someone who judges, with conversations of their own. Called once a worker.
    ///
    /// # Errors
    /// [`EngineError`] where an engine cannot be started.
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError>;
}

/// Someone who judges inputs, one after the other.
pub trait Worker {
    /// Judges the inputs at these places, in order. When `going` becomes false, the rest is left: then the answer is shorter.
    ///
    /// What is said of a place depends on nothing but the place and what the engines do: not on the places before it, nor on
    /// how many are asked for at a time.
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<Verdict>;

    /// Makes a mismatch small and runs it once more. When `going` becomes false, the smallest so far is given.
    fn reduce(&mut self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding;

    /// An engine that can no longer be used, and why; asked after each judgement.
    fn lost(&self) -> Option<String> {
        None
    }
}

/// What was said of one input.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verdict {
    /// Its place in the row of the seed.
    pub place: u64,
    /// Why it was not judged, where it was not.
    pub passed_over: Option<&'static str>,
    /// Who disagreed, each once.
    pub mismatches: Vec<Mismatch>,
    /// How often an engine died or hung over it and was started anew.
    pub deaths: u64,
}

/// A disagreement, before it is made small.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Mismatch {
    /// The place of the input.
    pub place: u64,
    /// Who: an engine, or the target that asked the reference.
    pub subject: String,
    /// How, in a word.
    pub symptom: String,
}

impl Verdict {
    /// Nothing is wrong with this input.
    #[must_use]
    pub const fn agreed(place: u64) -> Verdict {
        Verdict {
            place,
            passed_over: None,
            mismatches: Vec::new(),
            deaths: 0,
        }
    }
}
