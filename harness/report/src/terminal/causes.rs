//! Writes the features that engines lack and the largest causes of failing cases on the terminal, in two lines each.

use super::{BAD, BOLD, DIM};
use crate::overview::Overview;
use crate::text::visible;
use anstyle::Style;
use std::collections::BTreeSet;
use std::io::{self, Write};
use stickler_run::{Cause, Fact};
use stickler_types::{counted, grouped, shortened};

/// The maximum number of features and of causes that are shown; of features, those that nobody promises are the first that are left out.
const MAX_SHOWN: usize = 20;
/// The maximum number of characters of a title, and of what a compiler said where the terminal has no width.
const MAX_TITLE: usize = 120;
/// The minimum number of characters of a title that are shown, however narrow the terminal is.
const MIN_TITLE: usize = 20;

/// A list of causes behind the numbers of their cases.
struct CauseList {
    /// The width of the numbers.
    width: usize,
    /// The number of characters behind them.
    room: usize,
    /// Whether titles name their engines.
    names_engines: bool,
}

impl CauseList {
    fn new(overview: &Overview, columns: Option<usize>, width: usize) -> CauseList {
        let room = |columns: usize| columns.saturating_sub(width + 2).max(MIN_TITLE);
        CauseList {
            width,
            room: columns.map_or(usize::MAX, room),
            names_engines: overview.engines().len() > 1,
        }
    }

    /// Writes a number with the title of a cause, and on a second line what else is known of it.
    fn write(
        &self,
        out: &mut dyn Write,
        (number, style): (String, Style),
        cause: &Cause,
        about: &str,
    ) -> io::Result<()> {
        let CauseList { width, room, .. } = *self;
        let on = match self.names_engines {
            true => format!(" on {}", visible(&cause.engine)),
            false => String::new(),
        };
        let of_title = room.saturating_sub(on.chars().count());
        let title = shortened(&visible(&cause.title), of_title.clamp(MIN_TITLE, MAX_TITLE));
        writeln!(out, "{style}{number:>width$}{style:#}  {title}{on}")?;
        let about = shortened(about, room);
        writeln!(out, "{:>width$}  {DIM}{about}{DIM:#}", "")
    }
}

/// Writes the features that are lacking, those that somebody promises first; nothing where there is none.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write_lacks(
    out: &mut dyn Write,
    overview: &Overview,
    columns: Option<usize>,
) -> io::Result<()> {
    let mut lacks: Vec<&Cause> = overview.lacks.iter().collect();
    lacks.sort_by_key(|lack| !lack.is_failing_lack());
    if lacks.is_empty() {
        return Ok(());
    }
    let width = "Waiting".len();
    writeln!(out, "{BOLD}Waiting  Feature that is lacking{BOLD:#}")?;
    let list = CauseList::new(overview, columns, width);
    for lack in lacks.iter().take(MAX_SHOWN) {
        let style = if lack.is_failing_lack() { BAD } else { DIM };
        let said = shortened(&said(lack), columns.unwrap_or(MAX_TITLE));
        list.write(out, (grouped(lack.number()), style), lack, &said)?;
    }
    let rest = &lacks[lacks.len().min(MAX_SHOWN)..];
    if !rest.is_empty() {
        let cases: u64 = rest.iter().map(|lack| lack.number()).sum();
        let features = counted(rest.len() as u64, "feature more", "features more");
        writeln!(out, "{:>width$}  {features}; summary.md has all", grouped(cases))?;
    }
    writeln!(out)
}

/// Writes the causes that explain most of the cases that are not as expected, with titles that fit the columns of the terminal;
/// nothing where there is none.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write(out: &mut dyn Write, overview: &Overview, columns: Option<usize>) -> io::Result<()> {
    let (small, unreduced) = overview.unexpected_causes();
    if small.is_empty() && unreduced.is_empty() {
        return Ok(());
    }
    let causes = small.iter().chain(&unreduced);
    let widths = causes.map(|cause| cause.cases_shown().len());
    let width = widths.max().unwrap_or_default().max("Cases".len());
    writeln!(out, "{BOLD}{:>width$}  Cause{BOLD:#}", "Cases")?;
    let list = CauseList::new(overview, columns, width);
    for cause in small.iter().take(MAX_SHOWN) {
        list.write(out, (cause.cases_shown(), BAD), cause, &about(cause))?;
    }
    let mut count = |causes: &[&Cause], one: &str, several: &str| match causes {
        [] => Ok(()),
        causes => {
            let cases: u64 = causes.iter().map(|cause| cause.unexpected()).sum();
            let causes = counted(causes.len() as u64, one, several);
            writeln!(out, "{:>width$}  {causes}", grouped(cases))
        }
    };
    count(&small[small.len().min(MAX_SHOWN)..], "cause more", "causes more")?;
    let [one, several] = ["program", "programs"].map(|programs| {
        format!("{programs} not made small, which may show a cause of the list: the search ended before")
    });
    count(&unreduced, &one, &several)?;
    writeln!(out)
}

/// Returns the claim that a cause contradicts, and what else is known of it.
fn about(cause: &Cause) -> String {
    let mut text = visible(&cause.shown.basis);
    let claims: BTreeSet<&str> = cause.cases.iter().map(|some| some.basis.as_str()).collect();
    if claims.len() > 1 {
        text += &format!(
            ", and {}",
            counted(claims.len() as u64 - 1, "other claim", "other claims")
        );
    }
    if let Some(repeats) = &cause.flaky {
        text += &format!("; by chance, in {} of {} runs", repeats.seen, repeats.of);
    }
    text
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
