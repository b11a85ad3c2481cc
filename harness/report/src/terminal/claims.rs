//! Writes the claims on the terminal: each source with its kind, and those of its sections that an engine does not meet; in a
//! summary of many sources their kinds, and the sources that an engine does not meet.

use super::{BAD, DIM, Detail, MAX_ROWS, Surroundings};
use crate::claims::{COLUMNS, Row, Standing, add};
use crate::overview::Overview;
use crate::text::visible;
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_conversions::table::{Cell, Table};
use stickler_types::{counted, shortened};

/// The maximum number of sources and sections that a summary names because they are not met.
const MAX_NAMED: usize = 20;

/// The maximum number of characters of the name of a section.
const MAX_SECTION: usize = 40;

/// Writes one table: for a single engine with its numbers, for several with one column per engine.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let engines = overview.engines();
    let rows = overview.claims.rows(&engines);
    let sources = rows.iter().filter(|row| row.sum).count();
    let has_kinds = !overview.sources().is_empty();
    let is_by_kind = around.detail == Detail::Summary && has_kinds && sources > MAX_ROWS;
    let (lines, left_out) = match is_by_kind {
        true => by_kind(overview, &rows),
        false => (by_source(overview, &rows), 0),
    };
    let second = match (has_kinds, is_by_kind) {
        (false, _) => None,
        (true, false) => Some(Cell::left("kind")),
        (true, true) => Some(Cell::plain("sources")),
    };
    let standings = || lines.iter().flat_map(|(_, standings)| standings);
    // Differences and what is not supported have a column only where some claim has them.
    let is_always_shown = |head| matches!(head, "passed" | "failed" | "open");
    let columns = COLUMNS.into_iter();
    let columns: Vec<_> = columns
        .filter(|(head, count)| is_always_shown(*head) || standings().any(|standing| count(standing) > 0))
        .collect();
    let mut table = Table::new([Cell::left("Claims")].into_iter().chain(second).collect());
    match &engines[..] {
        [_] => columns.iter().for_each(|(head, _)| table.head(Cell::plain(head))),
        _ => engines
            .iter()
            .for_each(|engine| table.head(Cell::plain(visible(engine)))),
    }
    for (names, standings) in &lines {
        let cells: Vec<Cell> = match &standings[..] {
            [standing] => columns
                .iter()
                .map(|(head, count)| count_cell(head, count(standing)))
                .collect(),
            standings => standings.iter().map(standing_cell).collect(),
        };
        table.row(names.iter().cloned().chain(cells).collect());
    }
    table.write(out, around.width)?;
    if engines.len() != 1 && standings().any(|standing| standing.failed > 0) {
        writeln!(out, "  {DIM}n/m: n of m cases came out as the source says{DIM:#}")?;
    }
    if left_out > 0 {
        let rows = counted(left_out as u64, "more row is", "more rows are");
        writeln!(
            out,
            "  {DIM}{rows} not shown; --verbose and summary.md have all{DIM:#}"
        )?;
    }
    writeln!(out)
}

/// A row of the table: the first cells, with the name and what the run tells of its source, and the results of each engine.
type ClaimLine = (Vec<Cell>, Vec<Standing>);

/// Returns a line for each source, and below it those of its sections that an engine does not meet.
fn by_source(overview: &Overview, rows: &[Row<'_>]) -> Vec<ClaimLine> {
    let is_shown = |row: &&Row<'_>| row.sum || (row.failed() && !row.section.is_empty());
    let line = |row: &Row<'_>| {
        let mut names = vec![name(row, "  ")];
        if !overview.sources().is_empty() {
            let source = overview.source(row.source).filter(|_| row.sum);
            names.push(Cell::left(source.map_or("", |source| source.kind.as_str())));
        }
        (names, row.standings.clone())
    };
    rows.iter().filter(is_shown).map(line).collect()
}

/// Returns a line for each kind of source, and below it the first sources and sections that an engine does not meet; and the number of
/// those that have no line.
fn by_kind(overview: &Overview, rows: &[Row<'_>]) -> (Vec<ClaimLine>, usize) {
    let mut kinds: BTreeMap<&str, Vec<&Row<'_>>> = BTreeMap::new();
    for row in rows {
        let kind = overview
            .source(row.source)
            .map_or("other", |source| source.kind.as_str());
        kinds.entry(kind).or_default().push(row);
    }
    let mut lines = Vec::new();
    let mut named = 0;
    for (kind, rows) in kinds {
        let sources: Vec<&&Row<'_>> = rows.iter().filter(|row| row.sum).collect();
        let mut sums = vec![Standing::default(); sources.first().map_or(0, |row| row.standings.len())];
        sources.iter().for_each(|row| add(&mut sums, &row.standings));
        let names = vec![Cell::left(format!("  {kind}")), Cell::plain(sources.len())];
        lines.push((names, sums));
        let failed = rows.iter().filter(|row| row.failed());
        for row in failed.filter(|row| row.sum || !row.section.is_empty()) {
            named += 1;
            if named <= MAX_NAMED {
                lines.push((vec![name(row, "    "), Cell::plain("")], row.standings.clone()));
            }
        }
    }
    (lines, named.saturating_sub(MAX_NAMED))
}

/// Returns the cell with the name of a source, or of a section, which is indented more.
fn name(row: &Row<'_>, indent: &str) -> Cell {
    match row.sum {
        true => Cell::left(format!("{indent}{}", row.source)),
        false => Cell::left(format!(
            "{indent}  {}",
            shortened(&visible(row.section), MAX_SECTION)
        )),
    }
}

/// Formats an engine's results for a claim in one cell.
fn standing_cell(standing: &Standing) -> Cell {
    let Standing { passed, failed, .. } = *standing;
    match (passed + failed, failed) {
        (0, _) if standing.differs > 0 => Cell::styled("differs", DIM),
        (0, _) if standing.open > 0 => Cell::styled("open", DIM),
        (0, _) if standing.waiting > 0 => Cell::styled("waiting", DIM),
        (0, _) if standing.unsupported > 0 => Cell::styled("unsupported", DIM),
        (0, _) => Cell::styled("-", DIM),
        (_, 0) => Cell::plain(passed),
        (judged, _) => Cell::styled(format!("{passed}/{judged}"), BAD),
    }
}

/// Formats one number of an engine's results for a claim.
fn count_cell(head: &str, number: u64) -> Cell {
    match (head, number) {
        ("failed", 0) => Cell::styled("0", DIM),
        ("failed", failed) => Cell::styled(failed, BAD),
        (_, number) => Cell::plain(number),
    }
}
