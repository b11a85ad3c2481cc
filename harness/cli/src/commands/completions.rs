//! `stickler completions`: the script by which a shell completes commands and options.

use crate::arguments::{Arguments, CompletionsArguments};
use crate::exit::Exit;
use clap::CommandFactory;
use std::io::Write;

/// Prints the script of a shell.
///
/// # Errors
/// Errors of writing to `out`.
pub fn execute(arguments: &CompletionsArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let mut command = Arguments::command();
    let name = command.get_name().to_owned();
    // The generator panics where its output cannot be written.
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    out.write_all(&script)?;
    Ok(Exit::AsExpected)
}
