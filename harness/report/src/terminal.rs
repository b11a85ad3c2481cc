//! Writes the summary of a run on the terminal.
//!
//! The most important part comes last, where the reader looks when the run ends: first the causes, or, of an engine whose
//! causes are not known, the cases that are not as expected; then the claims, the totals, one line with the result, and the path
//! of the page. Where all is well the summary fits a screen of 24 lines. It is written with ANSI styles; the caller's stream strips them where
//! they do not belong.

pub(crate) mod causes;
mod claims;
mod ending;
pub(crate) mod failure;
mod totals;

use crate::overview::Overview;
use crate::text::{verdicts, visible};
use anstyle::{AnsiColor, Style};
use std::io::{self, Write};
use stickler_run::{CaseEvent, EngineHeader, Totals};
use stickler_types::{counted, grouped};

pub(crate) const BOLD: Style = Style::new().bold();
pub(crate) const DIM: Style = Style::new().dimmed();
pub(crate) const GOOD: Style = AnsiColor::Green.on_default();
pub(crate) const BAD: Style = AnsiColor::Red.on_default();

/// The number of failures that are shown whole, of engines whose causes are not known, where nothing else is asked for.
const SHOWN_FAILURES: usize = 40;

/// The maximum number of rows of a table of claims or totals in a summary; with more, rows are summed up.
const MAX_ROWS: usize = 6;

/// Amount of detail that the terminal shows of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Detail {
    /// The result and the path of the page.
    Result,
    /// Shows the unexpected cases, and sums up tables that would not fit a screen.
    #[default]
    Summary,
    /// Shows the unexpected cases, and a row for every source and dialect.
    Whole,
}

/// The facts that the summary needs besides the run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Surroundings<'a> {
    /// The path of the folder of reports, where there is one.
    pub reports: Option<&'a str>,
    /// The maximum number of failures that are shown whole; `None` shows some of engines whose causes are not known.
    pub failures: Option<usize>,
    /// Amount of detail that the terminal shows.
    pub detail: Detail,
    /// The number of columns that tables and sentences have room in; `None` where lines may have any length.
    pub width: Option<usize>,
    /// The number of results that come from the cache of earlier runs.
    pub from_cache: u64,
}

/// Writes the summary of a run.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    write_failures(out, overview, around)?;
    if around.detail != Detail::Result {
        causes::write_lacks(out, overview, around.width)?;
        causes::write(out, overview, around.width)?;
        claims::write(out, overview, around)?;
        totals::write(out, overview, around)?;
    }
    ending::write(out, overview, around)
}

fn write_failures(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let shown: Vec<&CaseEvent> = match (around.failures, around.detail) {
        (Some(number), _) => overview.failures().take(number).collect(),
        (None, Detail::Result) => return Ok(()),
        (None, _) => overview.unexplained_failures().take(SHOWN_FAILURES).collect(),
    };
    for case in &shown {
        failure::write(
            out,
            case,
            overview.engine(&case.engine),
            overview.totals.len() > 1,
        )?;
    }
    let rest = overview.failed.saturating_sub(shown.len() as u64);
    if rest > 0 && overview.causes.is_empty() {
        let place = match around.reports {
            Some(folder) => format!("all are in {folder}/events.jsonl.gz"),
            None => "with --report DIR all are written to files".to_owned(),
        };
        writeln!(
            out,
            "{BAD}... and {} more that are not as expected{BAD:#}; {place}.\n",
            grouped(rest)
        )?;
    }
    Ok(())
}

/// The maximum number of failures of a file that are shown whole.
const MAX_RERUN_FAILURES: usize = 10;

/// Writes what came of the cases of one file that were run again, since the file has changed: the cases that are not as expected, and for each engine how many cases had which verdict.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write_rerun(out: &mut dyn Write, overview: &Overview, failures: Option<usize>) -> io::Result<()> {
    let engines: &[EngineHeader] = overview.header.as_ref().map_or(&[], |header| &header.engines);
    for case in overview.failures().take(failures.unwrap_or(MAX_RERUN_FAILURES)) {
        failure::write(out, case, overview.engine(&case.engine), engines.len() > 1)?;
    }
    for engine in engines {
        let dialects = overview.totals.get(&engine.name).into_iter().flatten();
        let sum: Totals = dialects.flat_map(|(_, areas)| areas.values()).sum();
        let style = if sum.unexpected() > 0 { BAD } else { GOOD };
        let cases = counted(sum.all(), "case", "cases");
        let (name, verdicts) = (visible(&engine.name), verdicts(&sum, |_| true));
        writeln!(out, "{style}{cases} on {name}: {verdicts}{style:#}")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
