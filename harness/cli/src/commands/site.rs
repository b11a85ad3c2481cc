//! `stickler site`: a static site of several runs.

use crate::arguments::SiteArguments;
use crate::exit::Exit;
use crate::output;
use std::io::Write;
use stickler_report::site;
use stickler_types::counted;

/// Builds the site, and tells where it is.
///
/// # Errors
/// A run that cannot be read or is not whole; a folder that cannot be written.
pub fn execute(arguments: &SiteArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let summary = site::write(&arguments.runs, &arguments.output)?;
    for replaced in &summary.replaced {
        output::note(replaced);
    }
    writeln!(
        out,
        "{} of {}: {}",
        counted(summary.runs as u64, "run", "runs"),
        counted(summary.engines as u64, "engine", "engines"),
        arguments.output.join("index.html").display()
    )?;
    Ok(Exit::AsExpected)
}
