//! What can be asked of the reference, and what it answers.

use super::LocatedDiagnostic;
use stickler_types::{DialectName, Fault, Value};

/// A program to run and what to observe of it.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// The language rules.
    pub dialect: DialectName,
    /// The whole source text.
    pub source: &'a str,
    /// How many scans to run; 0 gives the variables their initial values and runs nothing.
    pub scans: u32,
    /// The variables whose values are wanted.
    pub observe: &'a [Observation<'a>],
    /// The simulated clock. No function of the reference reads it yet.
    pub clock: &'a [ClockSetting],
    /// Variables that the environment writes before a scan, in this order.
    pub set: &'a [ValueSetting<'a>],
    /// What the run may take.
    pub limits: Limits,
}

impl<'a> Request<'a> {
    /// A program that runs one scan, to which nothing happens from outside, within the usual limits.
    #[must_use]
    pub fn once(dialect: DialectName, source: &'a str, observe: &'a [Observation<'a>]) -> Request<'a> {
        Request {
            dialect,
            source,
            scans: 1,
            observe,
            clock: &[],
            set: &[],
            limits: Limits::default(),
        }
    }
}

/// One value that is wanted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Observation<'a> {
    /// The variable, or a path to an elementary value: `a[1]`, `rec.field[2].x`.
    pub name: &'a str,
    /// The scan, counted from 1, after which to look, 0 standing for the start; `None` is after the last.
    pub after: Option<u32>,
}

/// Where the clock stands before a scan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ClockSetting {
    /// The scan, counted from 1.
    pub before: u32,
    /// Nanoseconds since the start.
    pub nanoseconds: i64,
}

/// A variable that is written before a scan.
#[derive(Clone, Copy, Debug)]
pub struct ValueSetting<'a> {
    /// The scan, counted from 1.
    pub before: u32,
    /// The variable, or a path to an elementary value.
    pub name: &'a str,
    /// What it becomes; of exactly the variable's type.
    pub value: &'a Value,
}

/// What a run may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// The steps of the whole run, its start included; a step is an instruction of the stack machine, of which
    /// a simple assignment takes two. Past them the run ends with the fault `step-limit`.
    pub steps: u64,
}

impl Default for Limits {
    /// Ten million steps, some tens of milliseconds.
    fn default() -> Limits {
        Limits { steps: 10_000_000 }
    }
}

/// What came of a request. Values come in the order in which they were asked for, each by the name it was
/// asked for, with `@` and the scan behind it where it was asked for after a scan: `q@3`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// All scans ran.
    Executed {
        /// The values observed.
        values: Vec<(String, Value)>,
    },
    /// The source text is not acceptable, or has nothing to run.
    Rejected(Vec<LocatedDiagnostic>),
    /// A fault ended the run.
    Faulted {
        /// Which fault.
        fault: Fault,
        /// The 1-based line on which it happened.
        line: u32,
        /// The values up to then: those after scans that were not finished are left out, and those after the
        /// last are the values at the fault.
        values: Vec<(String, Value)>,
    },
}

/// A request that cannot be answered, whatever the program does.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum RequestError {
    /// A name to observe or to set names no elementary value of the program.
    UnknownName {
        /// The name.
        name: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A value to set is not of the variable's type.
    WrongType {
        /// The variable.
        name: String,
        /// Its type.
        expected: String,
        /// The value as it was given.
        value: String,
    },
    /// A value is wanted after, or set before, a scan that is not run.
    NoSuchScan {
        /// The variable.
        name: String,
        /// The scan.
        scan: u32,
    },
    /// The reference contradicts itself; its own defect, and never that of the program.
    Internal(String),
}

impl std::fmt::Display for RequestError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            RequestError::UnknownName { name, reason } => write!(f, "no value is named `{name}`: {reason}"),
            RequestError::WrongType {
                name,
                expected,
                value,
            } => {
                write!(f, "`{name}` is of type {expected} and cannot be set to {value}")
            }
            RequestError::NoSuchScan { name, scan } => {
                write!(f, "scan {scan}, named for `{name}`, is not run")
            }
            RequestError::Internal(reason) => write!(f, "defect of the reference: {reason}"),
        }
    }
}

impl std::error::Error for RequestError {}
