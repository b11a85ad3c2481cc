//! Running a program: check, start, scan by scan, and the values in between.

use super::diagnose::{Checked, nothing_to_run};
use super::located::locate;
use super::observe::Observer;
use super::request::{Limits, RequestError};
use super::settings::Settings;
use crate::execution::{Machine, Stop};
use crate::semantics::CheckedProgram;
use stickler_types::dialect::Dialect;
use stickler_types::{Outcome, RunRequest};

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
