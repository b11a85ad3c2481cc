//! Writes what came of the cases of one file that were run again, since the file has changed.

use super::{BAD, GOOD, failure};
use crate::overview::Overview;
use crate::text::{verdicts, visible};
use std::io::{self, Write};
use stickler_run::{EngineHeader, Totals};
use stickler_types::counted;

/// The maximum number of failures of a file that are shown whole.
const MAX_SHOWN: usize = 10;

/// Writes the cases that are not as expected, and for each engine how many cases had which verdict.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(out: &mut dyn Write, overview: &Overview, failures: Option<usize>) -> io::Result<()> {
    let engines: &[EngineHeader] = overview.header.as_ref().map_or(&[], |header| &header.engines);
    for case in overview.failures().take(failures.unwrap_or(MAX_SHOWN)) {
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
