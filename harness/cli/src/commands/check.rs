//! `stickler check`: the diagnostics of the reference for one file.

use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::{snippet, source_file};
use std::io::{self, Write};
use stickler_engines::protocol::Reply;
use stickler_types::{Diagnostic, Outcome};

/// Shows the diagnostics of a program, or one line where there are none.
///
/// # Errors
/// A file that cannot be read.
pub fn execute(arguments: &CheckArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let (bytes, path) = source_file::read(&arguments.source.file)?;
    let dialect = arguments.source.dialect;
    let (text, diagnostics) = stickler_reference::check_bytes(&bytes, dialect);
    let exit = if diagnostics.is_empty() {
        Exit::AsExpected
    } else {
        Exit::Failures
    };
    match (arguments.json, exit) {
        (true, _) => write_json(diagnostics, out)?,
        (false, Exit::AsExpected) => writeln!(out, "{path}: accepted in {dialect}")?,
        (false, _) => snippet::write(&diagnostics, &text, &path, out)?,
    }
    Ok(exit)
}

/// Writes the diagnostics as a reply of the wire protocol.
fn write_json(diagnostics: Vec<Diagnostic>, out: &mut dyn Write) -> io::Result<()> {
    let outcome = if diagnostics.is_empty() {
        Outcome::Accepted
    } else {
        Outcome::Rejected { diagnostics }
    };
    serde_json::to_writer(&mut *out, &Reply::from_outcome(0, outcome))?;
    writeln!(out)
}
