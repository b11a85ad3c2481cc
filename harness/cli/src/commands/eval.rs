//! `stickler eval`: executes a program of one file or several on the reference.

use crate::arguments::EvalArguments;
use crate::exit::Exit;
use crate::source_file::{Program, running};
use crate::{output, snippet};
use anyhow::{bail, ensure};
use std::io::{self, Write};
use stickler_reference::Limits;
use stickler_types::{ClockSetting, Diagnostic, Observation, Outcome, RunRequest, Value};

/// The maximum number of values that are shown where no variable is named.
const MAX_VALUES: usize = 1000;
/// The maximum number of scans between which time passes.
const MAX_TIMED_SCANS: u32 = 1_000_000;

/// Prints the final values in the form of a `values` mark. For a rejected program, writes the diagnostics to stderr; for one
/// that faults, prints the values so far and writes the fault to stderr.
///
/// # Errors
/// A file that cannot be read; a name that is no variable.
pub fn execute(arguments: &EvalArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let program = Program::read(&arguments.program.files)?;
    let dialect = arguments.program.dialect;
    let (text, diagnostics) = stickler_reference::check_bytes(&program.bytes, dialect);
    let show = |diagnostics: &[Diagnostic], text: &str| {
        snippet::write(
            diagnostics,
            text,
            |line| program.file_of(line),
            &mut anstream::stderr(),
        )
    };
    show(&diagnostics, &text)?;
    if diagnostics.iter().any(Diagnostic::is_error) {
        return Ok(Exit::Failures);
    }
    let text = match &arguments.runs {
        Some(name) => running(&text, name, dialect)?,
        None => text,
    };
    let names = names(arguments, &text);
    let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
    let clock = clock(arguments)?;
    let request = RunRequest {
        scans: arguments.scans,
        clock: &clock,
        set: &arguments.set,
        ..RunRequest::once(dialect, &text, &observe)
    };
    match stickler_reference::run(&request, Limits::default()) {
        Ok(Outcome::Executed { values, .. }) => {
            write_values(&values, out)?;
            Ok(Exit::AsExpected)
        }
        Ok(Outcome::Faulted {
            fault, line, values, ..
        }) => {
            write_values(&values, out)?;
            out.flush()?;
            let line = line.unwrap_or_default();
            let (path, before) = program.file_of(line);
            let line = line.saturating_sub(before);
            output::error(&anyhow::anyhow!(
                "{path}:{line}: the program stops with the fault {fault}"
            ));
            Ok(Exit::Failures)
        }
        Ok(Outcome::Rejected { diagnostics }) => {
            show(&diagnostics, &text)?;
            Ok(Exit::Failures)
        }
        Ok(other) => bail!("the reference answered {other}"),
        Err(error) => bail!(error),
    }
}

/// Returns the times before scans, where some passes between them.
fn clock(arguments: &EvalArguments) -> anyhow::Result<Vec<ClockSetting>> {
    let Some(cycle) = arguments.cycle else {
        return Ok(arguments.clock.clone());
    };
    ensure!(
        arguments.scans <= MAX_TIMED_SCANS,
        "--cycle goes with at most {MAX_TIMED_SCANS} scans; make --scans smaller"
    );
    Ok(ClockSetting::each(cycle, arguments.scans))
}

/// Returns the names of the variables on the command line, or of all variables where none is named.
fn names(arguments: &EvalArguments, text: &str) -> Vec<String> {
    if !arguments.observe.is_empty() {
        return arguments.observe.clone();
    }
    let names = stickler_reference::variables(text, arguments.program.dialect, MAX_VALUES);
    if names.len() == MAX_VALUES {
        output::note(format!(
            "only the first {MAX_VALUES} values are shown; --observe NAME shows others"
        ));
    }
    names
}

fn write_values(values: &[(String, Value)], out: &mut dyn Write) -> io::Result<()> {
    values
        .iter()
        .try_for_each(|(name, value)| writeln!(out, "{name} = {value}"))
}
