//! `stickler merge`: merges the parts of a run, or of a campaign.

use crate::arguments::MergeArguments;
use crate::case_folder::CaseFolder;
use crate::documented::of_all_cases;
use crate::exit::{self, Exit};
use crate::{output, shell};
use anyhow::bail;
use std::fs;
use std::io::Write;
use std::path::Path;
use stickler_campaign::{Merged, Record, Store, merge};
use stickler_report::Reports;
use stickler_report::events::{self, LogFile, Reader};
use stickler_report::parts::{self, RunPart};
use stickler_report::terminal::{self, Surroundings};
use stickler_types::counted;

/// Merges the parts of a run or of a campaign, depending on the contents of the folders.
///
/// # Errors
/// Folders of both kinds; a folder that cannot be written.
pub fn execute(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let run = arguments.folders.iter().find(|folder| is_of_run(folder));
    let campaign = arguments
        .folders
        .iter()
        .find(|folder| !is_of_run(folder) && !matches!(Record::read(folder), Ok(None)));
    match (run, campaign) {
        (Some(run), Some(campaign)) => bail!(
            "{} is a part of a run and {} one of a campaign; only parts of one kind can be put together",
            run.display(),
            campaign.display()
        ),
        (Some(_), None) => of_run(arguments, out),
        (None, _) => of_campaign(arguments, out),
    }
}

/// Returns whether a path is a folder of a run's reports, or an event log.
fn is_of_run(path: &Path) -> bool {
    path.is_file() || path.join(events::NAME).exists()
}

/// Merges the findings of all parts into one folder. Names the parts that are missing or were cut short; the exit code is then 2,
/// since the findings are incomplete.
///
/// # Errors
/// A folder that cannot be written.
fn of_campaign(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let Merged {
        findings,
        campaigns,
        missing,
    } = merge(&arguments.folders);
    let store = Store::open(&arguments.output)?;
    for finding in findings.values() {
        store.save(finding)?;
    }
    if let [campaign] = &campaigns[..] {
        campaign.write(store.folder())?;
    }
    for Record {
        asked,
        programs,
        disagreements,
        ..
    } in &campaigns
    {
        writeln!(
            out,
            "seed {}: {programs} programs, {disagreements} disagreements",
            asked.seed
        )?;
    }
    for sentence in &missing {
        output::note(sentence);
    }
    let number = counted(findings.len() as u64, "finding", "findings");
    writeln!(out, "{number} in {}", store.folder().display())?;
    for finding in findings.values() {
        writeln!(
            out,
            "  {}  {} {}: {}",
            finding.id,
            finding.origin.size,
            finding.unit(),
            first_line(&finding.message)
        )?;
    }
    let found = Exit::Failures.when(!findings.is_empty());
    Ok(found.max(Exit::Usage.when(!missing.is_empty())))
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

/// Writes every report of the whole run and shows its summary. Names the parts that are missing or were cut short; then
/// only the event log is written, without a footer, and the exit code is 2.
///
/// # Errors
/// A folder that cannot be written, or that holds one of the parts; a folder of cases that is not there.
fn of_run(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    refuse_to_overwrite(arguments)?;
    let parts = arguments.folders.iter().map(|folder| part(folder)).collect();
    // Without cases the page has no conversions.
    let folder = CaseFolder::locate_any(arguments.cases.as_deref())?;
    let stated = folder.as_ref().map(of_all_cases).unwrap_or_default();
    let mut reports = Reports::create(Some(&arguments.output), stated, false)?;
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
    Ok(exit::of_totals(&overview.sum(), fails).max(partial))
}

/// Opens the event log of one part; returns it with its name.
fn part(folder: &Path) -> RunPart<LogFile<'static>> {
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
