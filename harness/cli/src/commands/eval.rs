//! `stickler eval`: executes a program of one file or several on the reference.

use crate::arguments::EvalArguments;
use crate::exit::Exit;
use crate::source_file::Program;
use crate::{output, snippet};
use anyhow::{bail, ensure};
use std::io::{self, Write};
use stickler_reference::Limits;
use stickler_syntax::tree::PouKind;
use stickler_types::{
    ClockSetting, Diagnostic, Dialect, DialectName, Observation, Outcome, RunRequest, Value,
};

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
    snippet::write(
        &diagnostics,
        &text,
        |line| program.file_of(line),
        &mut anstream::stderr(),
    )?;
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
    let mut set = arguments.set.clone();
    set.sort_by_key(|setting| setting.before);
    let request = RunRequest {
        scans: arguments.scans,
        clock: &clock,
        set: &set,
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
            snippet::write(
                &diagnostics,
                &text,
                |line| program.file_of(line),
                &mut anstream::stderr(),
            )?;
            Ok(Exit::Failures)
        }
        Ok(other) => bail!("the reference answered {other}"),
        Err(error) => bail!(error),
    }
}

/// Returns a text with a configuration that runs a PROGRAM, in place of those that it has; their global variables stay where they are.
fn running(text: &str, name: &str, dialect: DialectName) -> anyhow::Result<String> {
    let (unit, _) = stickler_syntax::parse(text, Dialect::of(dialect));
    let mut programs = unit.pous().filter(|pou| pou.kind == PouKind::Program);
    ensure!(
        programs.any(|pou| pou.name.is(name)),
        "there is no PROGRAM `{name}`"
    );
    let mut running = String::with_capacity(text.len());
    let blank = |text: &str| text.replace(|character| character != '\n', " ");
    let mut at = 0;
    for configuration in unit.configurations() {
        running.push_str(&text[at..configuration.span.start as usize]);
        at = configuration.span.start as usize;
        for globals in &configuration.globals {
            running.push_str(&blank(&text[at..globals.span.start as usize]));
            running.push_str(globals.span.text(text));
            at = globals.span.end as usize;
        }
        running.push_str(&blank(&text[at..configuration.span.end as usize]));
        at = configuration.span.end as usize;
    }
    running.push_str(&text[at..]);
    running.push_str(&format!(
        "\nCONFIGURATION stickler RESOURCE here ON this PROGRAM {name} : {name}; END_RESOURCE END_CONFIGURATION\n"
    ));
    Ok(running)
}

/// Returns the time before each scan, where some passes between them.
fn clock(arguments: &EvalArguments) -> anyhow::Result<Vec<ClockSetting>> {
    let Some(cycle) = arguments.cycle else {
        return Ok(Vec::new());
    };
    ensure!(
        arguments.scans <= MAX_TIMED_SCANS,
        "--cycle goes with at most {MAX_TIMED_SCANS} scans; make --scans smaller"
    );
    let at = |before: u32| ClockSetting {
        before,
        nanoseconds: cycle.saturating_mul(i64::from(before) - 1),
    };
    Ok((1..=arguments.scans).map(at).collect())
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
