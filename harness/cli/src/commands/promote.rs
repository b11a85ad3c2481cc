//! `stickler promote`: turns a finding into a case, or a recording into tables of cases.

mod recording;

use super::fuzz::finding_place;
use crate::arguments::PromoteArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::{output, shell};
use std::io::Write;
use stickler_campaign::{CaseHead, FOUND, load, promote};

/// Writes the case or the tables, and shows the command that runs them.
///
/// # Errors
/// No such finding, no folder of cases, a finding that no case can express, or a recording that no case can cite.
pub fn execute(arguments: &PromoteArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    if folder.is_carried {
        anyhow::bail!(
            "there is no folder of cases here or above to which the case could be added; name one with --cases DIR"
        );
    }
    if recording::is_recording(&arguments.finding) {
        return recording::execute(arguments, &folder, out);
    }
    if arguments.dialect.is_some() {
        anyhow::bail!(
            "--dialect is for a recording; the case of a finding belongs to the dialects of the finding"
        );
    }
    let finding = load(&finding_place(&arguments.finding, None))?;
    let words = CaseHead {
        name: arguments.name.as_deref(),
        title: arguments.title.as_deref(),
        basis: arguments.basis.as_deref(),
    };
    let promoted = promote(&finding, &folder.path, &words)?;
    writeln!(out, "{}", promoted.path.display())?;
    if promoted.proposed {
        output::note(format!(
            "its basis is proposed: `{}`; look whether that section says it, or name a better one with --basis",
            promoted.basis
        ));
    }
    if let Some(name) = promoted.path.file_stem() {
        writeln!(
            out,
            "  {} run --filter {FOUND}/{}",
            shell::program(),
            name.to_string_lossy()
        )?;
    }
    Ok(Exit::AsExpected)
}
