//! `stickler reduce`: reduces one file to a small program on which an engine still shows the same wrong behaviour.

use crate::arguments::ReduceArguments;
use crate::exit::Exit;
use crate::progress::bar;
use crate::reduction_engine::ReductionEngine;
use crate::{engines, interrupt, output, source_file};
use anyhow::{Context, bail};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::time::Instant;
use stickler_engines::{Engine, ProcessEngine, ProcessLimits};
use stickler_generate::reduce::OutcomeSymptom;
use stickler_reduce::{Interestingness, Reduction, ReductionBudget, StopReason};
use stickler_syntax::decoding::decode;
use stickler_types::DialectName;

/// Prints the smallest program that shows the symptom, or writes it to the named file; writes a summary to stderr.
///
/// # Errors
/// A file that cannot be read or written; an engine that cannot be run.
pub fn execute(arguments: &ReduceArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let (bytes, path) = source_file::read(&arguments.file)?;
    let (text, broken) = decode(&bytes);
    if !broken.is_empty() {
        output::note(format!(
            "{path} has {}, which stand as U+FFFD from here on",
            broken[0].message
        ));
    }
    let engine = engine(arguments)?;
    let stop = interrupt::cancellation()?;
    let mut subject = ReductionEngine::new(engine.as_ref(), arguments.engine == engines::REFERENCE)?;
    let Some((dialect, symptom)) = shown(&mut subject, arguments, &text, &path)? else {
        return Ok(Exit::Failures);
    };
    let started = Instant::now();
    let bar = bar(None, "{spinner} {prefix}: {pos} tries, {elapsed}{msg}");
    bar.set_prefix(symptom.to_string());
    let stopped = || stop.is_requested();
    let budget = ReductionBudget {
        tries: arguments.tries,
        stop: &stopped,
    };
    let mut trouble = None;
    let found = stickler_reduce::text(
        &text,
        dialect,
        |candidate| {
            let answer = subject.answer(dialect, candidate, &symptom);
            let answer = answer.unwrap_or_else(|error| {
                trouble.get_or_insert(error);
                Interestingness::Uninteresting
            });
            if answer != Interestingness::Invalid {
                bar.inc(1);
            }
            if answer == Interestingness::Interesting {
                bar.set_message(format!(", {} lines", candidate.lines().count()));
            }
            answer
        },
        &budget,
    );
    bar.finish_and_clear();
    let again = found.ended != StopReason::NotInteresting
        && subject
            .answer(dialect, &found.value, &symptom)
            .is_ok_and(|answer| answer == Interestingness::Interesting);
    write(arguments.output.as_deref(), &found.value, out)?;
    // The summary follows the program.
    out.flush()?;
    let name = &engine.identity().name;
    output::note(format!(
        "{symptom} on {name} in {dialect}: {}, in {:.1} s",
        summary(&text, &found),
        started.elapsed().as_secs_f64()
    ));
    if let Some(error) = trouble {
        return Err(
            error.context("the engine could not be started again; this is the smallest program up to then")
        );
    }
    Ok(exit(&found, again))
}

/// Returns the summary of a reduction: the sizes before and after, and the number of attempts.
fn summary(before: &str, found: &Reduction<String>) -> String {
    let lines = |text: &str| text.lines().count();
    let tries = if found.tries == 1 { "try" } else { "tries" };
    format!(
        "{} → {} lines, {} {tries}",
        lines(before),
        lines(&found.value),
        found.tries
    )
}

fn exit(found: &Reduction<String>, again: bool) -> Exit {
    match found.ended {
        StopReason::Stopped => {
            output::note("stopped: this is the smallest program so far");
            return Exit::Interrupted;
        }
        StopReason::OutOfTries => output::note("no more tries are allowed; --tries N allows more"),
        StopReason::Smallest | StopReason::NotInteresting => {}
    }
    if again {
        return Exit::AsExpected;
    }
    output::note("the symptom is flaky: the same program was run again and did not show it");
    Exit::Failures
}

/// Finds the dialect and the symptom to keep; reports on stderr where the program shows none.
fn shown(
    subject: &mut ReductionEngine<'_>,
    arguments: &ReduceArguments,
    text: &str,
    path: &str,
) -> anyhow::Result<Option<(DialectName, OutcomeSymptom)>> {
    let identity = subject.identity();
    let dialects = match arguments.dialect {
        Some(dialect) => engines::spoken(identity, &[dialect])?,
        None => identity.dialects.clone(),
    };
    let name = identity.name.clone();
    let mut others = Vec::new();
    for &dialect in &dialects {
        let symptoms = subject.symptoms(dialect, text)?;
        let wanted = match &arguments.symptom {
            Some(wanted) => symptoms.iter().find(|symptom| symptom.is_meant_by(wanted)),
            None => symptoms.first(),
        };
        if let Some(symptom) = wanted {
            return Ok(Some((dialect, symptom.clone())));
        }
        others.extend(symptoms.iter().map(|symptom| format!("{symptom} in {dialect}")));
    }
    let dialects = engines::listed(&dialects);
    output::error(&match &arguments.symptom {
        Some(wanted) if others.is_empty() => {
            anyhow::anyhow!("{path} shows no {wanted} on {name} in {dialects}, and nothing else")
        }
        Some(wanted) => anyhow::anyhow!("{path} shows no {wanted} on {name}, but {}", others.join(", ")),
        None if arguments.engine == engines::REFERENCE => anyhow::anyhow!(
            "{path} shows nothing to keep: the reference runs it to its end in {dialects}; --engine names another"
        ),
        None => {
            anyhow::anyhow!("{path} shows no symptom: in {dialects}, {name} does what the reference does")
        }
    });
    Ok(None)
}

/// Returns the named engine, with the time limit of the command line.
fn engine(arguments: &ReduceArguments) -> anyhow::Result<Box<dyn Engine>> {
    let Some(reply) = arguments.hang else {
        return engines::by_name(&arguments.engine);
    };
    let Some(line) = arguments.engine.strip_prefix(engines::COMMAND) else {
        bail!("--hang is for engines that are named with `{}`", engines::COMMAND);
    };
    let limits = ProcessLimits {
        reply,
        ..ProcessLimits::default()
    };
    Ok(Box::new(ProcessEngine::start(line, limits)?))
}

/// Writes the program to the named file or to `out`; prints it also where the file cannot be written, so that the work is not
/// lost.
fn write(file: Option<&Path>, program: &str, out: &mut dyn Write) -> anyhow::Result<()> {
    let end = if program.ends_with('\n') { "" } else { "\n" };
    let Some(file) = file else {
        return Ok(write!(out, "{program}{end}")?);
    };
    let written = fs::write(file, format!("{program}{end}"));
    if written.is_err() {
        write!(out, "{program}{end}")?;
    }
    written.with_context(|| format!("cannot write {}; the program is printed instead", file.display()))
}
