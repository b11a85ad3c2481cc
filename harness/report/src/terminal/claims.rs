//! Writes the claims on the terminal: each source with its kind, and those of its sections that an engine does not meet.

use super::{BAD, DIM};
use crate::claims::{Row, Standing};
use crate::overview::Overview;
use crate::table::{AlignedTable, Cell};
use crate::text::{shortened, visible};
use std::io::{self, Write};

/// Writes one table: for a single engine with its numbers, for several with one column per engine.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(out: &mut dyn Write, overview: &Overview) -> io::Result<()> {
    let engines = overview.engines();
    let rows = overview.claims.rows(&engines);
    match &engines[..] {
        [_] => of_one_engine(out, overview, &rows),
        _ => of_several_engines(out, overview, &rows, &engines),
    }
}

/// Returns the head of the table with its first cells: the kinds of the sources stand there where the run names them.
fn head(overview: &Overview) -> Vec<Cell> {
    let kind = (!overview.sources().is_empty()).then(|| Cell::left("kind"));
    [Cell::left("Claims")].into_iter().chain(kind).collect()
}

/// Returns the first cells of a row; `None` where the row is not shown, such as a section that every engine meets.
fn names(overview: &Overview, row: &Row<'_>) -> Option<Vec<Cell>> {
    let name = match row.sum {
        true => Some(format!("  {}", row.source)),
        false if row.failed() && !row.section.is_empty() => {
            Some(format!("    {}", shortened(&visible(row.section), 40)))
        }
        false => None,
    };
    let mut cells = vec![Cell::left(name?)];
    if !overview.sources().is_empty() {
        let source = overview.source(row.source).filter(|_| row.sum);
        cells.push(Cell::left(source.map_or("", |source| &source.kind)));
    }
    Some(cells)
}

/// Writes a table with engines as columns and claims as rows.
fn of_several_engines(
    out: &mut dyn Write,
    overview: &Overview,
    rows: &[Row<'_>],
    engines: &[&str],
) -> io::Result<()> {
    let mut table = AlignedTable::new(head(overview));
    engines
        .iter()
        .for_each(|engine| table.head(Cell::plain(visible(engine))));
    for row in rows {
        let Some(mut cells) = names(overview, row) else {
            continue;
        };
        cells.extend(row.standings.iter().map(|standing| standing_cell(*standing)));
        table.row(cells);
    }
    table.write(out)?;
    writeln!(
        out,
        "  {DIM}n/m: n of m cases came out as the source says{DIM:#}\n"
    )
}

/// Formats an engine's results for a claim in one cell.
fn standing_cell(standing: Standing) -> Cell {
    let Standing { passed, failed, .. } = standing;
    match (passed + failed, failed) {
        (0, _) if standing.differs > 0 => Cell::styled("differs", DIM),
        (0, _) if standing.open > 0 => Cell::styled("open", DIM),
        (0, _) if standing.unsupported > 0 => Cell::styled("unsupported", DIM),
        (0, _) => Cell::styled("-", DIM),
        (judged, 0) => Cell::plain(format!("{passed}/{judged}")),
        (judged, _) => Cell::styled(format!("{passed}/{judged}"), BAD),
    }
}

fn of_one_engine(out: &mut dyn Write, overview: &Overview, rows: &[Row<'_>]) -> io::Result<()> {
    let any =
        |count: fn(&Standing) -> u64| rows.iter().flat_map(|row| &row.standings).any(|of| count(of) > 0);
    let differs = any(|standing| standing.differs);
    let unsupported = any(|standing| standing.unsupported);
    let mut table = AlignedTable::new(head(overview));
    table.head(Cell::plain("passed"));
    table.head(Cell::plain("failed"));
    if differs {
        table.head(Cell::plain("differs"));
    }
    table.head(Cell::plain("open"));
    if unsupported {
        table.head(Cell::plain("unsupported"));
    }
    for row in rows {
        if let (Some(names), [standing]) = (names(overview, row), &row.standings[..]) {
            table.row(claim_cells(names, *standing, differs, unsupported));
        }
    }
    table.write(out)?;
    writeln!(out)
}

fn claim_cells(mut cells: Vec<Cell>, standing: Standing, differs: bool, unsupported: bool) -> Vec<Cell> {
    let failed = match standing.failed {
        0 => Cell::styled("0", DIM),
        failed => Cell::styled(failed, BAD),
    };
    cells.extend([Cell::plain(standing.passed), failed]);
    if differs {
        cells.push(Cell::plain(standing.differs));
    }
    cells.push(Cell::plain(standing.open));
    if unsupported {
        cells.push(Cell::plain(standing.unsupported));
    }
    cells
}
