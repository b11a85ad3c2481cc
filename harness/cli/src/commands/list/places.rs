//! `stickler list --places`: how many cases stand in each pair of places.

use super::{BOLD, DIM, json_line};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use stickler_suite::{Case, Placement};

/// Writes three tables: sources and targets, sources and surroundings, targets and surroundings. As JSON it writes the combinations of
/// all three. Cases with a program of their own do not count.
///
/// # Errors
/// Those of writing to `out`.
pub(super) fn write(out: &mut dyn Write, cases: &[&Case], json: bool) -> io::Result<()> {
    let mut counts: BTreeMap<&Placement, usize> = BTreeMap::new();
    for placement in cases.iter().filter_map(|case| case.placement.as_deref()) {
        *counts.entry(placement).or_default() += 1;
    }
    if json {
        return counts.iter().try_for_each(|(placement, cases)| {
            json_line(
                out,
                &json!({
                    "source": placement.source,
                    "target": placement.target,
                    "surrounding": placement.surrounding,
                    "cases": cases,
                }),
            )
        });
    }
    let pairs = |pair: fn(&Placement) -> (&str, &str)| {
        let mut table: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for (placement, cases) in &counts {
            *table.entry(pair(placement)).or_default() += cases;
        }
        table
    };
    write_table(
        out,
        "sources and targets",
        &pairs(|placed| (&placed.source, &placed.target)),
    )?;
    writeln!(out)?;
    write_table(
        out,
        "sources and surroundings",
        &pairs(|placed| (&placed.source, &placed.surrounding)),
    )?;
    writeln!(out)?;
    write_table(
        out,
        "targets and surroundings",
        &pairs(|placed| (&placed.target, &placed.surrounding)),
    )
}

/// Writes a table of the number of cases in each pair, with the columns numbered and named below.
fn write_table(out: &mut dyn Write, title: &str, table: &BTreeMap<(&str, &str), usize>) -> io::Result<()> {
    let rows: BTreeSet<&str> = table.keys().map(|(row, _)| *row).collect();
    let columns: BTreeSet<&str> = table.keys().map(|(_, column)| *column).collect();
    let most = table.values().max().copied().unwrap_or_default();
    let width = most.to_string().len().max(2) + 1;
    let indent = rows.iter().map(|row| row.len()).max().unwrap_or_default();
    writeln!(out, "{BOLD}{title}{BOLD:#}")?;
    write!(out, "{:indent$}", "")?;
    (1..=columns.len()).try_for_each(|number| write!(out, "{DIM}{number:>width$}{DIM:#}"))?;
    writeln!(out)?;
    for row in rows {
        write!(out, "{row:indent$}")?;
        for column in &columns {
            match table.get(&(row, *column)) {
                Some(cases) => write!(out, "{cases:>width$}")?,
                None => write!(out, "{:>width$}", "-")?,
            }
        }
        writeln!(out)?;
    }
    let names: Vec<String> = (1..)
        .zip(&columns)
        .map(|(number, name)| format!("{number} {name}"))
        .collect();
    writeln!(out, "{DIM}{}{DIM:#}", names.join(" · "))
}
