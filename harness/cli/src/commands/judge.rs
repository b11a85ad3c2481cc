//! `stickler judge`: executes a program, function block or function on traces, and compares what comes out.

mod basis;
mod caller;
mod result;
mod trace;
mod variables;

use crate::arguments::JudgeArguments;
use crate::case_folder::CaseFolder;
use crate::engines::{self, REFERENCE};
use crate::exit::Exit;
use crate::source_file::{Program, files_of};
use crate::{interrupt, output, snippet};
use anyhow::{Context, bail, ensure};
use basis::{Basis, Used};
pub(super) use caller::Judged;
use result::TraceResult;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::slice;
use std::sync::Arc;
use stickler_engines::Session;
use stickler_syntax::features::features;
use stickler_types::{
    Diagnostic, Dialect, DialectName, NamedValue, Observation, Outcome, RunRequest, counted,
};
use trace::{Request, Trace};
use variables::{MAX_VARIABLES, Variables};

/// Judges the traces of a file, or of all files of a folder.
///
/// # Errors
/// A file that cannot be read, a trace that does not fit its program, an engine that cannot be run; in a folder, such a file is
/// told, and the others are judged.
pub fn execute(arguments: &JudgeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let named = arguments.engine.clone().unwrap_or_else(|| REFERENCE.to_owned());
    let engines = engines::by_names(slice::from_ref(&named))?;
    let Some(engine) = engines.first() else {
        bail!("no engine is named");
    };
    engines::spoken(engine.identity(), &[arguments.dialect])?;
    let mut session = engine.engine.session()?;
    let mut judge = Judge {
        arguments,
        session: &mut *session,
        basis: Basis::new(arguments.dialect, CaseFolder::locate_any(None)?),
        traces: 0,
        failed: 0,
    };
    let exit = match (&arguments.batch, &arguments.trace) {
        (Some(folder), _) => judge.folder(folder, out)?,
        (None, Some(trace)) => judge.files(&arguments.files, trace, out)?,
        (None, None) => bail!("name files and their --trace, or a folder with --batch"),
    };
    if !arguments.json {
        let traces = counted(judge.traces, "trace", "traces");
        match judge.failed {
            _ if judge.traces == 0 => writeln!(out, "no trace was judged")?,
            0 => writeln!(out, "{traces}: all as expected")?,
            failed => writeln!(
                out,
                "{traces}: {} as expected, {failed} not",
                judge.traces - failed
            )?,
        }
    }
    Ok(exit)
}

struct Judge<'a, 's> {
    arguments: &'a JudgeArguments,
    session: &'a mut (dyn Session + 's),
    basis: Basis,
    traces: u64,
    failed: u64,
}

impl Judge<'_, '_> {
    fn folder(&mut self, folder: &Path, out: &mut dyn Write) -> anyhow::Result<Exit> {
        ensure!(folder.is_dir(), "{} is no folder", folder.display());
        let mut exit = Exit::AsExpected;
        for file in files_of(folder)? {
            let judged = match trace_of(&file) {
                Some(trace) => self.files(slice::from_ref(&file), &trace, out),
                None => Err(anyhow::anyhow!(
                    "{}: neither a trace of its name nor trace.json or trace.csv is beside it",
                    file.display()
                )),
            };
            match judged {
                Ok(of_file) => exit = exit.max(of_file),
                Err(error) => {
                    out.flush()?;
                    output::error(&error);
                    exit = exit.max(Exit::Usage);
                }
            }
        }
        Ok(exit)
    }

    /// Judges all traces of a program.
    fn files(&mut self, files: &[PathBuf], traces: &Path, out: &mut dyn Write) -> anyhow::Result<Exit> {
        let source = Program::read(files)?;
        let traces = trace::read(traces)?;
        let program = self.program(&source, out)?;
        let engine = self.arguments.engine.as_deref();
        let basis = match &program {
            Ok((judged, _)) if engine.is_none_or(|name| name == REFERENCE) => self.basis.of(&judged.text),
            _ => Vec::new(),
        };
        let mut exit = Exit::AsExpected;
        for (number, trace) in (1..).zip(&traces) {
            let mut result = match &program {
                Ok((judged, variables)) => self.trace(judged, variables, trace).unwrap_or_else(|error| {
                    exit = exit.max(Exit::Usage);
                    TraceResult::without_values("misfit", format!("{error:#}"))
                }),
                Err(reason) => TraceResult::without_values("rejected", reason.clone()),
            };
            result.program = source.name();
            result.uses.clone_from(&basis);
            result.trace = match trace.name.as_str() {
                "" => format!("trace {number}"),
                name => name.to_owned(),
            };
            self.traces += 1;
            if !result.is_pass() {
                self.failed += 1;
                exit = exit.max(Exit::Failures);
            }
            match self.arguments.json {
                true => output::json_line(out, &result)?,
                false => result.write(self.arguments.batch.is_some(), out)?,
            }
        }
        let is_timed = |(judged, _): &(Judged, Variables)| {
            let used = features(&judged.text, Dialect::of(self.arguments.dialect));
            used.iter().any(|key| key.contains("timer"))
        };
        let is_still = self.arguments.cycle.is_none() && traces.iter().any(|trace| trace.clock.is_empty());
        if exit == Exit::Failures && is_still && !self.arguments.json && program.as_ref().is_ok_and(is_timed)
        {
            writeln!(
                out,
                "note: a trace without a clock has no time that passes, so that no timer ends; give it a `clock`, or --cycle"
            )?;
        }
        if !basis.is_empty() && !self.arguments.json {
            let of = |Used { name, stated, open }: &Used| format!("{name} {stated} of {}", stated + open);
            let rests: Vec<String> = basis.iter().map(of).collect();
            writeln!(
                out,
                "note: results that a source states in {}, of those that Stickler knows to ask: {}; the others are choices of the reference",
                self.arguments.dialect,
                rests.join(", ")
            )?;
        }
        Ok(exit)
    }

    /// Returns a text with the program to execute and its variables, or the first diagnostic where the reference rejects it.
    fn program(
        &self,
        source: &Program,
        out: &mut dyn Write,
    ) -> anyhow::Result<Result<(Judged, Variables), String>> {
        let dialect = self.arguments.dialect;
        let (text, diagnostics) = stickler_reference::check_bytes(&source.bytes, dialect);
        let unit = self.arguments.block.as_ref().or(self.arguments.function.as_ref());
        let (text, diagnostics) = match diagnostics.iter().any(Diagnostic::is_error) {
            true => (text, diagnostics),
            false => {
                let judged = Judged::of(&text, dialect, unit.map(String::as_str));
                let judged = judged.with_context(|| source.name())?;
                match start_values(&judged.text, dialect, MAX_VARIABLES)? {
                    Ok(values) => return Ok(Ok((judged, Variables::new(values)))),
                    Err(diagnostics) => (judged.text, diagnostics),
                }
            }
        };
        if !self.arguments.json {
            snippet::write(&diagnostics, &text, |line| source.file_of(line), out)?;
        }
        let first = diagnostics.iter().find(|one| one.is_error());
        let reason = first.map(|one| {
            let line = one.line.unwrap_or_default();
            format!(
                "line {}: {}",
                line.saturating_sub(source.file_of(line).1),
                one.message
            )
        });
        Ok(Err(reason.unwrap_or_default()))
    }

    /// Executes the program on a trace and compares what comes out.
    fn trace(
        &mut self,
        judged: &Judged,
        variables: &Variables,
        trace: &Trace,
    ) -> anyhow::Result<TraceResult> {
        let Request {
            scans,
            clock,
            set,
            expected,
        } = trace.request(judged, variables, self.arguments.cycle)?;
        let observe: Vec<Observation> = expected
            .iter()
            .map(|expected| Observation {
                name: Arc::clone(&expected.path),
                type_name: expected.value.type_name().into(),
                after: Some(expected.scan),
            })
            .collect();
        let outcome = self.session.run(&RunRequest {
            dialect: self.arguments.dialect,
            source: &judged.text,
            scans,
            observe: &observe,
            clock: &clock,
            set: &set,
        });
        Ok(TraceResult::of(
            outcome,
            &expected,
            trace.tolerance.unwrap_or(self.arguments.tolerance),
        ))
    }
}

/// Returns the trace of a file: that of its name, or else that of its folder.
fn trace_of(file: &Path) -> Option<PathBuf> {
    let of_file = ["json", "csv"].map(|ending| file.with_extension(ending));
    let of_folder = ["trace.json", "trace.csv"].map(|name| file.with_file_name(name));
    of_file.into_iter().chain(of_folder).find(|path| path.is_file())
}

/// Returns at most `most` elementary variables of a program with their values at its start, or the diagnostics of the reference.
///
/// # Errors
/// A program that stops before the first scan.
pub(super) fn start_values(
    text: &str,
    dialect: DialectName,
    most: usize,
) -> anyhow::Result<Result<Vec<NamedValue>, Vec<Diagnostic>>> {
    let names = stickler_reference::variables(text, dialect, most);
    let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
    let request = RunRequest {
        scans: 0,
        ..RunRequest::once(dialect, text, &observe)
    };
    match stickler_reference::run(&request, stickler_reference::Limits::default()) {
        Ok(Outcome::Executed { values, .. }) => Ok(Ok(values)),
        Ok(Outcome::Rejected { diagnostics }) => Ok(Err(diagnostics)),
        Ok(other) => bail!("the reference answered {other} before the first scan"),
        Err(error) => bail!(error),
    }
}
