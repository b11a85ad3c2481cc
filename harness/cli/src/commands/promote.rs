//! `stickler promote`: turns a finding into a case, or a recording into tables of cases.

use super::fuzz::finding_place;
use crate::arguments::PromoteArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::{engines, output, shell};
use anyhow::{Context, bail};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use stickler_campaign::{CaseHead, FOUND, check_name, load, promote};
use stickler_conversions::recording::{RecordedSection, RecordedTables, Recording};
use stickler_suite::RECORDINGS;
use stickler_types::{DialectName, counted};

/// Writes the case or the tables, and shows the command that runs them.
///
/// # Errors
/// No such finding, no folder of cases, a finding that no case can express, or a recording that no case can cite.
pub fn execute(arguments: &PromoteArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    if folder.is_carried {
        bail!(
            "there is no folder of cases here or above to which the case could be added; name one with --cases DIR"
        );
    }
    if is_recording(&arguments.finding) {
        return promote_recording(arguments, &folder, out);
    }
    if arguments.dialect.is_some() {
        bail!("--dialect is for a recording; the case of a finding belongs to the dialects of the finding");
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

/// Returns whether the path names the file of a recording rather than a finding.
fn is_recording(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "toml") && path.is_file()
}

/// Turns a recording into tables of cases whose basis is the recording. Shows what was written, what is no case, and the command that runs them.
///
/// # Errors
/// A file that is no recording, is not among those of the folder of cases, or has no answers in the dialect; a table that is there already.
fn promote_recording(
    arguments: &PromoteArguments,
    folder: &CaseFolder,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let path = &arguments.finding;
    let shown = path.display();
    if arguments.basis.is_some() || arguments.title.is_some() {
        bail!(
            "--basis and --title are for a finding; the cases of a recording have the recording as their basis, and a title for each table"
        );
    }
    let text = fs::read_to_string(path).with_context(|| format!("cannot read {shown}"))?;
    let recording = Recording::parse(&shown.to_string(), &text)?;
    let own = folder
        .path
        .join(RECORDINGS)
        .join(format!("{}.toml", recording.name));
    if own.canonicalize().ok() != path.canonicalize().ok() {
        bail!(
            "cases cite a recording that lies beside them: move {shown} to {} first",
            own.display()
        );
    }
    let owner = owner(arguments, &recording)?;
    let asked = match recording.dialects.contains(&owner) {
        true => owner,
        false => owner.base(),
    };
    let name = arguments.name.as_deref().unwrap_or(&recording.name);
    check_name(name)?;
    let made = recording.case_tables(asked, owner.as_str());
    let place = |section| folder.path.join(area(section)).join(format!("{name}.toml"));
    let places: Vec<PathBuf> = made.tables.iter().map(|table| place(table.section)).collect();
    if let Some(known) = places.iter().find(|path| path.exists()) {
        bail!(
            "{} is there already; the ids of cases never change their meaning, so choose another name with --name",
            known.display()
        );
    }
    if places.is_empty() {
        bail!("no answer of {shown} in {owner} says what a case could expect");
    }
    for (at, (path, table)) in places.iter().zip(&made.tables).enumerate() {
        if let Err(error) = write(path, &table.text) {
            // A part of the tables would be in the way of the next try.
            for written in &places[..at] {
                let _ = fs::remove_file(written);
            }
            return Err(error).with_context(|| format!("cannot write {}", path.display()));
        }
    }
    for (path, table) in places.iter().zip(&made.tables) {
        let cases = counted(table.rows as u64, "case", "cases");
        writeln!(out, "{}  {cases}", path.display())?;
    }
    note_left_out(&made);
    writeln!(out, "  {} lint", shell::program())?;
    writeln!(
        out,
        "  {} run --dialect {owner} --filter /{name}::",
        shell::program()
    )?;
    Ok(Exit::AsExpected)
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent)?;
    }
    fs::write(path, text)
}

/// Returns the dialect to which the cases belong: the one that is named, or the only one of the recording.
fn owner(arguments: &PromoteArguments, recording: &Recording) -> anyhow::Result<DialectName> {
    let names = || engines::listed(&recording.dialects);
    let owner = match (arguments.dialect, &recording.dialects[..]) {
        (Some(named), _) => named,
        (None, [only]) => *only,
        (None, _) => bail!(
            "the recording has answers in {}; name one with --dialect",
            names()
        ),
    };
    if !recording.dialects.contains(&owner) && !recording.dialects.contains(&owner.base()) {
        bail!("the recording has no answers in {owner}, only in {}", names());
    }
    Ok(owner)
}

/// Returns the area of the suite to which a section belongs.
const fn area(section: RecordedSection) -> &'static str {
    match section {
        RecordedSection::Implicit => "widening",
        RecordedSection::Bits => "bit-access",
        RecordedSection::Comparisons => "language",
        RecordedSection::Functions => "conversion",
    }
}

fn note_left_out(made: &RecordedTables) {
    for (reason, count) in &made.left_out {
        output::note(format!("{count} no case: {reason}"));
    }
}
