//! `stickler check`: the diagnostics of the reference for a program.

use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::source_file::Program;
use crate::{output, snippet};
use serde::Serialize;
use std::io::Write;
use stickler_engines::protocol::Reply;
use stickler_types::{Diagnostic, Outcome};

/// The reply about one of several files.
#[derive(Serialize)]
struct FileReply<'a> {
    file: &'a str,
    #[serde(flatten)]
    reply: Reply,
}

/// Shows the diagnostics of a program, and where it is accepted a line that says so.
///
/// # Errors
/// A file that cannot be read.
pub fn execute(arguments: &CheckArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let program = Program::read(&arguments.program.files)?;
    let dialect = arguments.program.dialect;
    let (text, diagnostics) = stickler_reference::check_bytes(&program.bytes, dialect);
    let exit = Exit::Failures.when(diagnostics.iter().any(Diagnostic::is_error));
    if arguments.json {
        let files = program.by_file(diagnostics);
        let is_one = files.len() == 1;
        for (file, diagnostics) in files {
            let reply = Reply::from_outcome(0, Outcome::of_check(diagnostics));
            match is_one {
                true => output::json_line(out, &reply)?,
                false => output::json_line(out, &FileReply { file, reply })?,
            }
        }
        return Ok(exit);
    }
    snippet::write(&diagnostics, &text, |line| program.file_of(line), out)?;
    if exit == Exit::AsExpected {
        let outcome = Outcome::of_check(diagnostics);
        writeln!(out, "{}: {outcome} in {dialect}", program.name())?;
    }
    Ok(exit)
}
