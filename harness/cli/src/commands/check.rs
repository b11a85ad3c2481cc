//! `stickler check`: the diagnostics of the reference for one file.

use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::{output, snippet, source_file};
use std::io::Write;
use stickler_engines::protocol::Reply;
use stickler_types::Outcome;

/// Shows the diagnostics of a program, and where it is accepted a line that says so.
///
/// # Errors
/// A file that cannot be read.
pub fn execute(arguments: &CheckArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let (bytes, path) = source_file::read(&arguments.source.file)?;
    let dialect = arguments.source.dialect;
    let (text, diagnostics) = stickler_reference::check_bytes(&bytes, dialect);
    if !arguments.json {
        snippet::write(&diagnostics, &text, &path, out)?;
    }
    let outcome = Outcome::of_check(diagnostics);
    let exit = match outcome {
        Outcome::Rejected { .. } => Exit::Failures,
        _ => Exit::AsExpected,
    };
    if arguments.json {
        output::json_line(out, &Reply::from_outcome(0, outcome))?;
    } else if exit == Exit::AsExpected {
        writeln!(out, "{path}: {outcome} in {dialect}")?;
    }
    Ok(exit)
}
