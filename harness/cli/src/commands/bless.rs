//! `stickler bless`: rewrites baselines from the results of a run.

use crate::arguments::BlessArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::{baselines, output, run_plan};
use anyhow::{Context, bail};
use jiff::civil::Date;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use stickler_engines::Reference;
use stickler_report::events::{self, Reader};
use stickler_run::{Baseline, Blessing, ChangeKind, EngineRun, EntryChange, Event, Verdict, bless};
use stickler_suite::Suite;
use stickler_types::{DialectName, counted, join};

/// The maximum number of changes of a baseline that are shown one by one.
const MAX_CHANGES: usize = 40;

/// Rewrites the baselines of the engines of a run.
///
/// # Errors
/// A report that cannot be read or is of no complete run, an engine that is not in it, case files with mistakes, a baseline
/// with a mistake, or one that cannot be written.
pub fn execute(arguments: &BlessArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let report = run_plan::report_folder(arguments.report.as_deref(), &folder.root);
    let (dialects, runs) = read(&report)?;
    let (day, runs) = chosen(runs, &arguments.engine)?;
    if arguments.baseline.is_some() && runs.len() > 1 {
        bail!("one file is the baseline of one engine; say by --engine of which");
    }
    let suite = folder.load_with(dialects);
    if !suite.errors.is_empty() {
        bail!("what fits no case can only be told of a whole suite; mend its files first");
    }
    for run in &runs {
        let engine = run.engine().name.as_str();
        let path = match &arguments.baseline {
            Some(path) => path.clone(),
            None => baselines::place(&folder.root, engine),
        };
        rewrite(&path, run, &suite, day, arguments.dry_run, out)?;
    }
    Ok(Exit::AsExpected)
}

/// The date of a run and the results of each of its engines, from its event log.
type Runs = (Date, Vec<EngineRun>);

/// Reads the event log of a run; returns the dialects of stickler.toml that take part, and the run.
fn read(report: &Path) -> anyhow::Result<(Vec<DialectName>, Runs)> {
    let path = match report.is_file() {
        true => report.to_owned(),
        false => report.join(events::NAME),
    };
    let shown = path.display();
    let mut log = Reader::open(&path).with_context(|| format!("{shown}, which a run writes"))?;
    let mut day = None;
    let mut runs: Vec<EngineRun> = Vec::new();
    let mut dialects: Vec<DialectName> = Vec::new();
    for event in &mut log {
        match event.with_context(|| format!("cannot read {shown}"))? {
            Event::Header(header) => {
                day = header.started.get(..10).and_then(|day| day.parse::<Date>().ok());
                runs = header.engines.into_iter().map(EngineRun::new).collect();
                let defined = header.defined.iter();
                dialects = defined.filter_map(|defined| defined.name.parse().ok()).collect();
            }
            Event::Case(case) => runs.iter_mut().for_each(|run| run.take(&case)),
            Event::Cause(cause) => runs.iter_mut().for_each(|run| run.take_cause(cause.clone())),
            Event::Footer(_) => {}
        }
    }
    if let Err(truncated) = log.check_complete() {
        bail!("{shown}: {truncated}; a baseline is rewritten from a whole run, so run it again");
    }
    let day = day.with_context(|| format!("{shown} does not say when its run began"))?;
    Ok((dialects, (day, runs)))
}

/// Selects the engines of a run whose baselines are to be rewritten.
fn chosen((day, mut runs): Runs, names: &[String]) -> anyhow::Result<Runs> {
    let engines: Vec<String> = runs.iter().map(|run| run.engine().name.clone()).collect();
    if let Some(name) = names.iter().find(|name| !engines.contains(name)) {
        bail!(
            "the report tells nothing of `{name}`; it is about {}",
            engines.join(", ")
        );
    }
    if names.iter().any(|name| name == Reference::NAME) || engines == [Reference::NAME] {
        bail!(
            "the reference has no baseline: it must pass every case; `stickler run --engine E` tells of another engine"
        );
    }
    runs.retain(|run| match run.engine().name.as_str() {
        Reference::NAME => false,
        name => names.is_empty() || names.iter().any(|meant| meant == name),
    });
    Ok((day, runs))
}

fn rewrite(
    path: &Path,
    run: &EngineRun,
    suite: &Suite,
    day: Date,
    dry_run: bool,
    out: &mut dyn Write,
) -> anyhow::Result<()> {
    let engine = run.engine().name.as_str();
    let shown = path.display();
    let (text, baseline) = match baselines::read(path)? {
        Some((text, baseline)) => {
            baselines::check_engine(&baseline, engine)?;
            (text, baseline)
        }
        None => (
            String::new(),
            Baseline {
                engine: engine.to_owned(),
                file: shown.to_string(),
                entries: Vec::new(),
            },
        ),
    };
    let blessing = bless(&text, &baseline, run, suite, day);
    if blessing.strangers > 0 {
        output::note(format!(
            "{} of the run that the suite no longer has: nothing is said about them",
            counted(blessing.strangers as u64, "case", "cases")
        ));
    }
    show(&blessing, out)?;
    let entries = counted(blessing.entries as u64, "entry", "entries");
    if blessing.changes.is_empty() {
        writeln!(out, "{shown}: nothing is different, {entries}")?;
    } else if dry_run {
        writeln!(out, "{shown}: would have {entries}: {}", summary(&blessing))?;
    } else {
        write(path, &blessing.text).with_context(|| format!("cannot write {shown}"))?;
        writeln!(out, "{shown}: {entries}: {}", summary(&blessing))?;
    }
    Ok(())
}

fn show(blessing: &Blessing, out: &mut dyn Write) -> std::io::Result<()> {
    for EntryChange {
        kind,
        verdicts,
        case,
        why,
    } in blessing.changes.iter().take(MAX_CHANGES)
    {
        let verdict = Verdict::any_of(verdicts);
        writeln!(out, "  {} {verdict} {case}  {why}", sign(*kind))?;
    }
    match blessing.changes.len().saturating_sub(MAX_CHANGES) {
        0 => Ok(()),
        rest => writeln!(out, "  ... and {rest} more"),
    }
}

const fn sign(kind: ChangeKind) -> char {
    match kind {
        ChangeKind::Added => '+',
        ChangeKind::Removed => '-',
        ChangeKind::Narrowed | ChangeKind::Widened | ChangeKind::Undated => '~',
    }
}

/// Returns the number of entries for each kind of change, such as `3 added, 1 removed`.
fn summary(blessing: &Blessing) -> String {
    let kinds = [
        (ChangeKind::Added, "added"),
        (ChangeKind::Widened, "widened"),
        (ChangeKind::Removed, "removed"),
        (ChangeKind::Narrowed, "narrowed"),
        (ChangeKind::Undated, "without a day now"),
    ];
    let number = |kind| {
        blessing
            .changes
            .iter()
            .filter(|change| change.kind == kind)
            .count()
    };
    let reported = kinds.map(|(kind, word)| (number(kind), word));
    let reported = reported.iter().filter(|(number, _)| *number > 0);
    join(reported.map(|(number, word)| format!("{number} {word}")), ", ")
}

/// Writes the file atomically, since it holds reasons that people wrote.
fn write(path: &Path, text: &str) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    let beside = PathBuf::from(beside);
    fs::write(&beside, text)?;
    fs::rename(&beside, path)
}
