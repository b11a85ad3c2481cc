//! `stickler site`: a static site of several runs.

use crate::arguments::SiteArguments;
use crate::case_folder::CaseFolder;
use crate::documented::of_all_cases;
use crate::exit::Exit;
use crate::output;
use std::io::Write;
use stickler_report::site;
use stickler_types::counted;

/// Builds the site, and tells where it is.
///
/// # Errors
/// A run that cannot be read or is not whole, unless such runs are to be skipped and another can be read; a folder that cannot be written.
pub fn execute(arguments: &SiteArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let summary = site::write(
        &arguments.runs,
        arguments.skip_unreadable,
        &arguments.output,
        &of_all_cases(&folder),
    )?;
    for note in summary.skipped.iter().chain(&summary.replaced) {
        output::note(note);
    }
    writeln!(
        out,
        "{} of {}, {}: {}",
        counted(summary.runs as u64, "run", "runs"),
        counted(summary.engines as u64, "engine", "engines"),
        counted(
            summary.functions as u64,
            "conversion function",
            "conversion functions"
        ),
        arguments.output.join("index.html").display()
    )?;
    Ok(Exit::AsExpected)
}
