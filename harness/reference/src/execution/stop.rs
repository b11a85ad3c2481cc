//! Why the machine stops before its program ends.

use crate::instruction::FaultKind;
use std::fmt;

/// A fault of the running program, and where it happened.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RaisedFault {
    /// The kind of fault.
    pub kind: FaultKind,
    /// The 1-based line of the source text; 0 where the program names none.
    pub line: u32,
}

/// The program contradicts itself: an empty stack popped, an address outside the memory, a label outside the
/// code. The checker builds no such program, so this is a defect of the reference and never of a source text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Inconsistency {
    /// The thing that the machine found missing.
    pub what: &'static str,
    /// The index of the instruction.
    pub at: u32,
}

impl fmt::Display for Inconsistency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "instruction {} of the checked program has no {}",
            self.at, self.what
        )
    }
}

impl std::error::Error for Inconsistency {}

/// Why a run stopped.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// The running program is at fault.
    Fault(RaisedFault),
    /// The reference is at fault.
    Inconsistent(Inconsistency),
}

/// A [`Stop`] before it is known where.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Halt {
    /// See [`Stop::Fault`].
    Fault(FaultKind),
    /// See [`Stop::Inconsistent`]: what is missing.
    Missing(&'static str),
}

impl From<FaultKind> for Halt {
    fn from(kind: FaultKind) -> Halt {
        Halt::Fault(kind)
    }
}
