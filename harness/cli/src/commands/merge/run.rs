//! Merges the reports of the parts of a run into those of the whole run.

use crate::arguments::MergeArguments;
use crate::case_folder::CaseFolder;
use crate::documented::of_all_cases;
use crate::exit::{self, Exit};
use crate::{output, shell};
use anyhow::bail;
use std::fs::{self, File};
use std::io::{BufReader, Write};
use std::path::Path;
use stickler_report::Reports;
use stickler_report::events::{self, Reader};
use stickler_report::parts::{self, RunPart};
use stickler_report::terminal::{self, Surroundings};

/// Writes every report of the whole run and shows its summary. Names the parts that are missing or were cut short; then
/// only the event log is written, without a footer, and the exit code is 2.
///
/// # Errors
/// A folder that cannot be written, or that holds one of the parts; a folder of cases that is not there.
pub fn execute(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    refuse_to_overwrite(arguments)?;
    let parts = arguments.folders.iter().map(|folder| part(folder)).collect();
    // Without cases the page has no conversions.
    let folder = CaseFolder::locate_any(arguments.cases.as_deref())?;
    let stated = folder.as_ref().map(of_all_cases).unwrap_or_default();
    let mut reports = Reports::create(Some(&arguments.output), stated)?;
    let missing = parts::merge(parts, &shell::command_line(), &mut |event| {
        reports.take(&event);
    });
    let overview = reports.finish()?;
    let shown = arguments.output.display().to_string();
    terminal::write(
        out,
        &overview,
        Surroundings {
            reports: Some(&shown),
            width: output::width(),
            ..Surroundings::default()
        },
    )?;
    // The list of missing parts follows the summary.
    out.flush()?;
    missing.iter().for_each(output::note);
    let mut headers = overview.header.iter();
    let has_broken_files = headers.any(|header| !header.broken_files.is_empty());
    let fails = overview.outdated().next().is_some() || overview.lacking() > 0;
    let partial = Exit::Usage.when(!missing.is_empty() || has_broken_files);
    Ok(exit::of_totals(&overview.sum(), fails).worst(partial))
}

/// Opens the event log of one part; returns it with its name.
fn part(folder: &Path) -> RunPart<BufReader<File>> {
    RunPart {
        name: folder.display().to_string(),
        log: Reader::open(&events::locate(folder)),
    }
}

/// # Errors
/// Reports that would overwrite one of the parts.
fn refuse_to_overwrite(arguments: &MergeArguments) -> anyhow::Result<()> {
    // A folder that does not exist yet holds no part.
    let Ok(output) = fs::canonicalize(&arguments.output) else {
        return Ok(());
    };
    for folder in &arguments.folders {
        let log = fs::canonicalize(events::locate(folder));
        if log.is_ok_and(|log| log.parent() == Some(&output)) {
            bail!(
                "{} is one of the parts; name another folder with --output",
                arguments.output.display()
            );
        }
    }
    Ok(())
}
