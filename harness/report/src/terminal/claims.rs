//! Writes the claims on the terminal: each source with its kind, and those of its sections that an engine does not meet; in a
//! summary of many sources their kinds, and the sources that an engine does not meet.

use super::{BAD, DIM, Detail, MAX_ROWS, Surroundings};
use crate::claims::{Row, Standing};
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
    let mut table = Table::new([Cell::left("Claims")].into_iter().chain(second).collect());
    match &engines[..] {
        [_] => of_one_engine(&mut table, &lines),
        _ => of_several_engines(&mut table, &lines, &engines),
    }
    table.write(out, around.width)?;
    let mut standings = lines.iter().flat_map(|line| &line.standings);
    if engines.len() != 1 && standings.any(|standing| standing.failed > 0) {
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

/// A row of the table.
struct DocumentRow {
    /// The first cells: the name, and what the run tells of its source.
    names: Vec<Cell>,
    /// The results of each engine.
    standings: Vec<Standing>,
}

/// Returns a line for each source, and below it those of its sections that an engine does not meet.
fn by_source(overview: &Overview, rows: &[Row<'_>]) -> Vec<DocumentRow> {
    let is_shown = |row: &&Row<'_>| row.sum || (row.failed() && !row.section.is_empty());
    let line = |row: &Row<'_>| {
        let mut names = vec![name(row, "  ")];
        if !overview.sources().is_empty() {
            let source = overview.source(row.source).filter(|_| row.sum);
            names.push(Cell::left(source.map_or("", |source| &source.kind)));
        }
        DocumentRow {
            names,
            standings: row.standings.clone(),
        }
    };
    rows.iter().filter(is_shown).map(line).collect()
}

/// Returns a line for each kind of source, and below it the first sources and sections that an engine does not meet; and the number of
/// those that have no line.
fn by_kind(overview: &Overview, rows: &[Row<'_>]) -> (Vec<DocumentRow>, usize) {
    let kind = |row: &Row<'_>| overview.source(row.source).map_or("other", |source| &source.kind);
    let mut kinds: BTreeMap<&str, Vec<&Row<'_>>> = BTreeMap::new();
    rows.iter()
        .for_each(|row| kinds.entry(kind(row)).or_default().push(row));
    let mut lines = Vec::new();
    let mut named = 0;
    for (kind, rows) in kinds {
        let sources: Vec<&&Row<'_>> = rows.iter().filter(|row| row.sum).collect();
        let mut standings = vec![Standing::default(); sources.first().map_or(0, |row| row.standings.len())];
        for row in &sources {
            let sums = standings.iter_mut();
            sums.zip(&row.standings)
                .for_each(|(sum, standing)| *sum += *standing);
        }
        lines.push(DocumentRow {
            names: vec![Cell::left(format!("  {kind}")), Cell::plain(sources.len())],
            standings,
        });
        let failed = rows.iter().filter(|row| row.failed());
        for row in failed.filter(|row| row.sum || !row.section.is_empty()) {
            named += 1;
            if named <= MAX_NAMED {
                lines.push(DocumentRow {
                    names: vec![name(row, "    "), Cell::plain("")],
                    standings: row.standings.clone(),
                });
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

/// Adds engines as columns.
fn of_several_engines(table: &mut Table, lines: &[DocumentRow], engines: &[&str]) {
    engines
        .iter()
        .for_each(|engine| table.head(Cell::plain(visible(engine))));
    for line in lines {
        let standings = line.standings.iter();
        let cells = standings.map(|standing| standing_cell(*standing));
        table.row(line.names.iter().cloned().chain(cells).collect());
    }
}

/// Formats an engine's results for a claim in one cell.
fn standing_cell(standing: Standing) -> Cell {
    let Standing { passed, failed, .. } = standing;
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

/// Adds a column for each result; differences and what is not supported only where some claim has them.
fn of_one_engine(table: &mut Table, lines: &[DocumentRow]) {
    type Count = fn(&Standing) -> u64;
    let columns: [(&str, Count); 6] = [
        ("passed", |standing| standing.passed),
        ("failed", |standing| standing.failed),
        ("differs", |standing| standing.differs),
        ("open", |standing| standing.open),
        ("unsupported", |standing| standing.unsupported),
        ("waiting", |standing| standing.waiting),
    ];
    let is_shown = |(head, count): &(&str, Count)| {
        let mut standings = lines.iter().flat_map(|line| &line.standings);
        !matches!(*head, "differs" | "unsupported" | "waiting")
            || standings.any(|standing| count(standing) > 0)
    };
    let columns: Vec<(&str, Count)> = columns.into_iter().filter(is_shown).collect();
    columns.iter().for_each(|(head, _)| table.head(Cell::plain(head)));
    for line in lines {
        if let [standing] = &line.standings[..] {
            let cell = |(head, count): &(&str, Count)| match (*head, count(standing)) {
                ("failed", 0) => Cell::styled("0", DIM),
                ("failed", failed) => Cell::styled(failed, BAD),
                (_, number) => Cell::plain(number),
            };
            let cells = columns.iter().map(cell);
            table.row(line.names.iter().cloned().chain(cells).collect());
        }
    }
}
