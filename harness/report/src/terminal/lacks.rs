//! Writes the features that engines lack on the terminal, in two lines each: how many cases wait for the feature, and what the
//! compiler said.

use super::{BAD, BOLD, DIM};
use crate::overview::Overview;
use crate::text::visible;
use std::io::{self, Write};
use stickler_run::{Cause, Fact};
use stickler_types::{counted, grouped, shortened};

/// The maximum number of features that are shown; those that nobody promises are the first that are left out.
const MAX_SHOWN: usize = 20;

/// The maximum number of characters of a line, where the terminal has no width.
const MAX_LINE: usize = 120;

/// Writes the features that are lacking, those that somebody promises first; nothing where there is none.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write(out: &mut dyn Write, overview: &Overview, columns: Option<usize>) -> io::Result<()> {
    let mut lacks: Vec<&Cause> = overview.lacks.iter().collect();
    lacks.sort_by_key(|lack| !lack.is_failing_lack());
    if lacks.is_empty() {
        return Ok(());
    }
    let several = overview.engines().len() > 1;
    let width = "Waiting".len();
    let room = columns.map_or(MAX_LINE, |columns| columns.saturating_sub(width + 2).max(20));
    writeln!(
        out,
        "{BOLD}{:>width$}  Feature that is lacking{BOLD:#}",
        "Waiting"
    )?;
    for lack in lacks.iter().take(MAX_SHOWN) {
        let style = if lack.is_failing_lack() { BAD } else { DIM };
        let on = match several {
            true => format!(" on {}", visible(&lack.engine)),
            false => String::new(),
        };
        let number = grouped(lack.number());
        let title = format!("{}{on}", visible(&lack.title));
        writeln!(
            out,
            "{style}{number:>width$}{style:#}  {}",
            shortened(&title, room)
        )?;
        writeln!(
            out,
            "{:>width$}  {DIM}{}{DIM:#}",
            "",
            shortened(&said(lack), room)
        )?;
    }
    let rest = &lacks[lacks.len().min(MAX_SHOWN)..];
    if !rest.is_empty() {
        let cases: u64 = rest.iter().map(|lack| lack.number()).sum();
        let features = counted(rest.len() as u64, "feature more", "features more");
        writeln!(out, "{:>width$}  {features}; summary.md has all", grouped(cases))?;
    }
    writeln!(out)
}

/// Returns what the compiler said of the feature's minimal program, on one line, and who promises the feature.
pub(crate) fn said(lack: &Cause) -> String {
    let said = match &lack.shown.got[..] {
        [Fact::Unsupported { reason }] => reason.clone(),
        got => Fact::text(got),
    };
    let said = visible(&said).replace('\n', "; ");
    match (lack.is_failing_lack(), lack.shown.basis.as_str()) {
        (true, basis) if !basis.is_empty() => format!("promised by {}; {said}", visible(basis)),
        _ => said,
    }
}
