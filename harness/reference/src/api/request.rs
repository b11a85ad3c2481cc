//! The limits of a run, and the errors of a request.

/// The limits of a run.
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

/// A request that cannot be answered, whatever the program does.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum RequestError {
    /// A name to observe or to set names no elementary value of the program.
    UnknownName {
        /// The name.
        name: String,
        /// The reason why it names none.
        reason: String,
    },
    /// A value to set is not of the variable's type.
    WrongType {
        /// The variable.
        name: String,
        /// The type of the variable.
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
