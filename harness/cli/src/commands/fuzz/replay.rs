//! Judges one input, or one finding, again.

use super::{engines_of, finding_place, under_test};
use crate::arguments::FuzzArguments;
use crate::exit::Exit;
use crate::{engines, output, source_file};
use anyhow::bail;
use std::io::{self, Write};
use std::path::Path;
use stickler_campaign::finding::Finding;
use stickler_campaign::{Replayed, load, replay};
use stickler_generate::oracles::{FuzzTarget, InputOutcome, OracleFailure};

/// Judges the finding in a folder or, with targets, the bytes of a file.
///
/// # Errors
/// A finding or file that cannot be read; an engine that cannot be run.
pub fn execute(path: &Path, arguments: &FuzzArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let path = finding_place(path, arguments.findings.as_ref());
    if path.is_dir() {
        return finding(&path, arguments, out);
    }
    if arguments.target.is_empty() {
        if !path.exists() {
            bail!("{} is neither a finding nor a file", path.display());
        }
        bail!(
            "{} is no folder of a finding; to judge the bytes of a file, say by which oracle: --target parse",
            path.display()
        );
    }
    let (bytes, name) = source_file::read(&path)?;
    let mut exit = Exit::AsExpected;
    for target in &arguments.target {
        let judged = target.judge(&bytes);
        exit = exit.max(Exit::Failures.when(judged.is_err()));
        write_judged(&name, *target, &judged, out)?;
    }
    Ok(exit)
}

fn finding(path: &Path, arguments: &FuzzArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let finding = load(path)?;
    if finding.stickler != env!("CARGO_PKG_VERSION") {
        output::note(format!(
            "this was found by Stickler {}; its programs and inputs are judged as they are",
            finding.stickler
        ));
    }
    if !finding.is_as_found() {
        output::note(
            "the program or the input was edited since it was found; what must happen was said of the original",
        );
    }
    let engines = engines_of(&names(&finding, arguments))?;
    let engines: Vec<_> = engines.iter().map(under_test).collect();
    let replayed = replay(&finding, &engines)?;
    write_replayed(&finding, &replayed, out)?;
    Ok(Exit::Failures.when(replayed.shows()))
}

/// Returns the names of the engines on the command line, or else of the engine that disagreed.
fn names(finding: &Finding, arguments: &FuzzArguments) -> Vec<String> {
    match (&arguments.engine[..], &finding.engine) {
        ([], Some(engine)) => vec![engine.asked_for.clone()],
        ([], None) => vec![engines::REFERENCE.to_owned()],
        (named, _) => named.to_vec(),
    }
}

fn write_replayed(finding: &Finding, replayed: &Replayed, out: &mut dyn Write) -> io::Result<()> {
    for (answer, wrong) in &replayed.answers {
        let (engine, outcome) = (&answer.engine, &answer.outcome);
        let wrong = wrong.as_deref().unwrap_or("as it must");
        writeln!(out, "{} {}: {outcome} {wrong}", engine.name, engine.version)?;
    }
    if let (Some(judged), Some(target)) = (&replayed.judged, finding.target()) {
        write_judged("its input", target, judged, out)?;
    }
    if replayed.answers.is_empty() && replayed.judged.is_none() {
        writeln!(
            out,
            "{}: this version of Stickler knows nothing to ask",
            finding.id
        )?;
    }
    match replayed.shows() {
        true => writeln!(out, "it is still there"),
        false => writeln!(out, "it is not there any more"),
    }
}

fn write_judged(
    name: &str,
    target: FuzzTarget,
    judged: &Result<InputOutcome, OracleFailure>,
    out: &mut dyn Write,
) -> io::Result<()> {
    match judged {
        Ok(InputOutcome::Checked) => writeln!(out, "{name}: {} holds", target.as_str()),
        Ok(InputOutcome::Skipped(word)) => {
            writeln!(out, "{name}: {} passed it over: {word}", target.as_str())
        }
        Err(failure) => writeln!(out, "{name}: {} fails: {failure}", target.as_str()),
    }
}
