//! Writes the totals on the terminal, by dialect and area.

use super::{BAD, DIM, Detail, MAX_ROWS, Surroundings};
use crate::overview::Overview;
use crate::text::visible;
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_conversions::table::{Cell, Table};
use stickler_run::Totals;

/// Writes the totals: a row for each dialect and a column for each area, or, in a summary of many dialects, a row for each area and
/// a column for each engine.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let dialects: usize = overview.totals.values().map(BTreeMap::len).sum();
    let table = match around.detail {
        Detail::Summary if dialects > MAX_ROWS => by_area(overview),
        _ => by_dialect(overview),
    };
    table.write(out, around.width)?;
    if overview.failed > 0 {
        writeln!(out, "  {DIM}n/m: n of m cases are as expected{DIM:#}")?;
    }
    writeln!(out)
}

fn by_area(overview: &Overview) -> Table {
    let mut table = Table::new(vec![Cell::left("Cases")]);
    let engines = overview.totals.keys();
    engines.for_each(|engine| table.head(Cell::plain(visible(engine))));
    let mut areas: Vec<Option<&str>> = overview.areas().into_iter().map(Some).collect();
    areas.push(None);
    for area in areas {
        let name = Cell::left(format!("  {}", area.unwrap_or("all")));
        let of_engine = |dialects: &BTreeMap<String, BTreeMap<String, Totals>>| {
            let all = dialects.values().flatten();
            let counted = all.filter(|(name, _)| area.is_none_or(|area| area == *name));
            total_cell(Some(&counted.map(|(_, totals)| totals).sum()))
        };
        let cells = overview.totals.values().map(of_engine);
        table.row([name].into_iter().chain(cells).collect());
    }
    table
}

/// Returns the table of dialects. A variant of a dialect, whose name begins with that of the dialect, stands under it by what it
/// adds, so that the table stays narrow.
fn by_dialect(overview: &Overview) -> Table {
    let areas = overview.areas();
    let mut table = Table::new(vec![Cell::left("Cases")]);
    areas.iter().for_each(|area| table.head(Cell::plain(area)));
    table.head(Cell::plain("all"));
    for (engine, dialects) in &overview.totals {
        let mut above = None;
        for (dialect, totals) in dialects {
            let label = match above.and_then(|base| added(dialect, base)) {
                Some(added) => format!("  {added}"),
                None => {
                    above = Some(dialect);
                    dialect.clone()
                }
            };
            let name = match overview.totals.len() {
                1 => format!("  {label}"),
                _ => format!("  {engine} {label}"),
            };
            let mut cells = vec![Cell::left(name)];
            cells.extend(areas.iter().map(|area| total_cell(totals.get(*area))));
            cells.push(total_cell(Some(&totals.values().sum())));
            table.row(cells);
        }
    }
    table
}

/// Returns what the name of a variant adds to that of its base, such as `+partial-access`; `None` for any other dialect.
fn added<'d>(dialect: &'d str, base: &str) -> Option<&'d str> {
    let rest = dialect.strip_prefix(base)?;
    match rest.strip_prefix('-') {
        Some(without) => without.starts_with("without-").then_some(without),
        None => rest.starts_with('+').then_some(rest),
    }
}

fn total_cell(totals: Option<&Totals>) -> Cell {
    match totals.map(|totals| (totals.all(), totals.unexpected())) {
        None | Some((0, _)) => Cell::styled("-", DIM),
        Some((all, 0)) => Cell::plain(all),
        Some((all, unexpected)) => Cell::styled(format!("{}/{all}", all - unexpected), BAD),
    }
}
