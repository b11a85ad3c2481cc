//! The findings of a sweep over the reference: the counts and the first differences.

use std::fmt;
use stickler_types::Value;

/// The progress of a sweep.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SweepProgress {
    /// The number of inputs that were compared so far.
    pub done: u64,
    /// The number of compared inputs that gave a wrong result.
    pub mismatches: u64,
}

/// The maximum number of differences that are kept; all are counted.
pub const MAX_DIFFERENCES: usize = 10;

/// An input whose result differs from the exact one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The place of the input in the domain.
    pub place: u64,
    /// The operands.
    pub operands: Vec<Value>,
    /// The result of exact arithmetic.
    pub expected: Value,
    /// The result of the engine.
    pub got: Value,
    /// The document that demands the expected result; `None` where no document speaks of this input.
    pub basis: Option<&'static str>,
}

impl fmt::Display for Difference {
    /// Writes `SINT#-1 gives WORD#16#00FF, not WORD#16#FFFF`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, operand) in self.operands.iter().enumerate() {
            write!(f, "{}{operand}", if index == 0 { "" } else { ", " })?;
        }
        write!(f, " gives {}, not {}", self.got, self.expected)
    }
}

/// The differences that a sweep found, and its progress.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct SweepFindings {
    /// The number of inputs of the domain.
    pub inputs: u64,
    /// The number of inputs that were compared, from the first on without a gap.
    pub done: u64,
    /// The number of inputs that gave a wrong result.
    pub mismatches: u64,
    /// The first wrong results, at most [`MAX_DIFFERENCES`], in the order of the domain.
    pub first: Vec<Difference>,
}

impl SweepFindings {
    /// Returns findings with no input compared yet.
    pub fn new(inputs: u64) -> SweepFindings {
        SweepFindings {
            inputs,
            ..SweepFindings::default()
        }
    }

    /// Returns whether every input was compared.
    pub const fn is_complete(&self) -> bool {
        self.done == self.inputs
    }

    /// Returns the progress of the sweep.
    pub const fn progress(&self) -> SweepProgress {
        SweepProgress {
            done: self.done,
            mismatches: self.mismatches,
        }
    }

    /// Counts a wrong result, and keeps it if it is one of the first.
    pub(super) fn differ(&mut self, difference: impl FnOnce() -> Difference) {
        self.mismatches += 1;
        if self.first.len() < MAX_DIFFERENCES {
            self.first.push(difference());
        }
    }

    /// Adds the findings of another part of the domain.
    pub fn add(&mut self, part: SweepFindings) {
        self.done += part.done;
        self.mismatches += part.mismatches;
        if !part.first.is_empty() {
            self.first.extend(part.first);
            self.first.sort_by_key(|difference| difference.place);
            self.first.truncate(MAX_DIFFERENCES);
        }
    }
}
