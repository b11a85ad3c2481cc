//! What a sweep found.

use crate::sweep::run::Progress;
use std::fmt;
use stickler_types::Value;

/// How many differences are kept to be shown; all are counted.
pub const KEPT: usize = 10;

/// One input that does not give the exact result.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Its place in the domain.
    pub place: u64,
    /// The operands.
    pub operands: Vec<Value>,
    /// What exact arithmetic gives.
    pub expected: Value,
    /// What came instead.
    pub got: Value,
    /// The document that says so; `None` where no document speaks of this input.
    pub basis: Option<&'static str>,
}

impl fmt::Display for Difference {
    /// `SINT#-1 gives WORD#16#00FF, not WORD#16#FFFF`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, operand) in self.operands.iter().enumerate() {
            write!(f, "{}{operand}", if index == 0 { "" } else { ", " })?;
        }
        write!(f, " gives {}, not {}", self.got, self.expected)
    }
}

/// What a sweep found, and how far it came.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Findings {
    /// All inputs of the domain.
    pub inputs: u64,
    /// Those that were looked at: all up to a place.
    pub done: u64,
    /// How many of them came out wrong.
    pub mismatches: u64,
    /// The first of these, at most [`KEPT`], in the order of the domain.
    pub first: Vec<Difference>,
}

impl Findings {
    /// Nothing found yet.
    #[must_use]
    pub fn new(inputs: u64) -> Findings {
        Findings {
            inputs,
            ..Findings::default()
        }
    }

    /// Whether every input was looked at.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.done == self.inputs
    }

    /// How far the sweep is.
    #[must_use]
    pub const fn progress(&self) -> Progress {
        Progress {
            done: self.done,
            mismatches: self.mismatches,
        }
    }

    /// Adds what was found in another part of the domain.
    pub fn add(&mut self, part: Findings) {
        self.done += part.done;
        self.mismatches += part.mismatches;
        if !part.first.is_empty() {
            self.first.extend(part.first);
            self.first.sort_by_key(|difference| difference.place);
            self.first.truncate(KEPT);
        }
    }
}
