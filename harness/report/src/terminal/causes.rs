//! Writes the largest causes of failing cases on the terminal, in two lines each.

use super::{BAD, BOLD, DIM};
use crate::overview::Overview;
use crate::text::visible;
use std::collections::BTreeSet;
use std::io::{self, Write};
use stickler_run::Cause;
use stickler_types::{counted, grouped, shortened};

/// The maximum number of causes that are shown.
const MAX_SHOWN_CAUSES: usize = 20;
/// The maximum number of characters of a title that are shown.
const MAX_TITLE: usize = 120;
/// The minimum number of characters of a title that are shown, however narrow the terminal is.
const MIN_TITLE: usize = 20;

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
    let several = overview.engines().len() > 1;
    let causes = small.iter().chain(&unreduced);
    let widths = causes.map(|cause| cause.cases_shown().len());
    let width = widths.max().unwrap_or_default().max("Cases".len());
    let room = columns.map_or(usize::MAX, |columns| {
        columns.saturating_sub(width + 2).max(MIN_TITLE)
    });
    writeln!(out, "{BOLD}{:>width$}  Cause{BOLD:#}", "Cases")?;
    for cause in small.iter().take(MAX_SHOWN_CAUSES) {
        let on = if several {
            format!(" on {}", visible(&cause.engine))
        } else {
            String::new()
        };
        let of_title = room
            .saturating_sub(on.chars().count())
            .clamp(MIN_TITLE, MAX_TITLE);
        let title = shortened(&visible(&cause.title), of_title);
        writeln!(out, "{BAD}{:>width$}{BAD:#}  {title}{on}", cause.cases_shown())?;
        writeln!(
            out,
            "{:>width$}  {DIM}{}{DIM:#}",
            "",
            shortened(&about(cause), room)
        )?;
    }
    let mut count = |causes: &[&Cause], one: &str, several: &str| match causes {
        [] => Ok(()),
        causes => {
            let cases: u64 = causes.iter().map(|cause| cause.unexpected()).sum();
            let causes = counted(causes.len() as u64, one, several);
            writeln!(out, "{:>width$}  {causes}", grouped(cases))
        }
    };
    count(
        &small[small.len().min(MAX_SHOWN_CAUSES)..],
        "cause more",
        "causes more",
    )?;
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
        text.push_str(&format!(
            ", and {}",
            counted(claims.len() as u64 - 1, "other claim", "other claims")
        ));
    }
    if let Some(repeats) = &cause.flaky {
        text.push_str(&format!(
            "; by chance, in {} of {} runs",
            repeats.seen, repeats.of
        ));
    }
    text
}
