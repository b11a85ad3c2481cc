//! Running a program, within limits: check, start, scan by scan, and the values in between.

use super::diagnose::{Checked, nothing_to_run};
use super::located::locate;
use super::observe::Observer;
use super::settings::Settings;
use crate::execution::{Machine, Stop};
use crate::semantics::CheckedProgram;
use stickler_types::{Dialect, Outcome, RunRequest};

/// Runs a program within limits and gives the values asked for, each by its [key](stickler_types::Observation::key), in the order
/// in which they were asked for.
///
/// Where the program faults, values after scans that were not finished are left out, and those after the last scan are the
/// values at the fault. Of the language only the standard timers look at the clock.
///
/// # Errors
/// [`RequestError`] where the request does not fit the program; a program that is not acceptable, or that faults,
/// is an [`Outcome`].
pub fn run(request: &RunRequest<'_>, limits: Limits) -> Result<Outcome, RequestError> {
    let dialect = Dialect::of(request.dialect);
    let mut checked = Checked::new(request.source, dialect);
    if !checked.is_rejected() {
        if let Some(program) = &checked.program {
            let outcome = execute(program, request, limits)?;
            let warnings = locate(checked.diagnostics, request.source, &checked.lines);
            return Ok(outcome.with_warnings(warnings));
        }
        checked.diagnostics.push(nothing_to_run(request.source, dialect));
    }
    let diagnostics = locate(checked.diagnostics, request.source, &checked.lines);
    Ok(Outcome::rejected(diagnostics))
}

/// Runs a program that has been checked, for `request.scans` scans; of the request, the text and the dialect are not looked at.
///
/// # Errors
/// As [`run`].
pub fn execute(
    program: &CheckedProgram,
    request: &RunRequest<'_>,
    limits: Limits,
) -> Result<Outcome, RequestError> {
    let mut observer = Observer::new(program, request.observe, request.scans)?;
    let mut settings = Settings::new(program, request)?;
    let mut machine = Machine::new(&program.program, limits.steps);
    match scan_all(&mut machine, &mut observer, &mut settings, request.scans) {
        Ok(()) => Ok(Outcome::executed(observer.finish(&machine))),
        Err(Stop::Fault(fault)) => {
            let values = observer.finish(&machine);
            Ok(Outcome::Faulted {
                fault: fault.kind,
                line: Some(fault.line),
                values,
                warnings: Vec::new(),
            })
        }
        Err(Stop::Inconsistent(inconsistency)) => {
            debug_assert!(false, "{inconsistency}");
            Err(RequestError::Internal(inconsistency.to_string()))
        }
    }
}

/// The start counts as scan 0.
fn scan_all(
    machine: &mut Machine<'_>,
    observer: &mut Observer<'_>,
    settings: &mut Settings<'_>,
    scans: u32,
) -> Result<(), Stop> {
    machine.startup()?;
    observer.after_scan(0, machine);
    for scan in 1..=scans {
        settings.apply_before(scan, machine);
        machine.scan()?;
        observer.after_scan(scan, machine);
    }
    Ok(())
}

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
