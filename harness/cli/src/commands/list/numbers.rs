//! `stickler list --count`, `--features` and `--places`: how many cases there are by dialect and area, by feature of the language, and in
//! each pair of places.

use super::{BOLD, DIM, json_line};
use serde::Serialize;
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::io::{self, Write};
use stickler_conversions::table::{Cell, Table};
use stickler_suite::{Case, Feature, Features, Placement};
use stickler_types::{DialectName, grouped, join};
use stickler_workers::{SpawnError, WorkerPool};

/// The numbers of a dialect, or of all dialects together.
#[derive(Serialize)]
struct CountLine<'a> {
    /// The dialect; `all` for all of them.
    dialect: &'a str,
    /// The number of cases by area.
    areas: BTreeMap<&'a str, u64>,
    cases: u64,
    /// The number of different programs, each with what it observes.
    questions: u64,
}

impl<'a> CountLine<'a> {
    fn new(dialect: &'a str, cases: &[&'a Case]) -> CountLine<'a> {
        let mut areas: BTreeMap<&str, u64> = BTreeMap::new();
        for case in cases {
            *areas.entry(&case.area).or_default() += 1;
        }
        let questions: HashSet<_> = cases.iter().map(|case| (&case.source, &case.observe)).collect();
        CountLine {
            dialect,
            areas,
            cases: cases.len() as u64,
            questions: questions.len() as u64,
        }
    }
}

/// Writes the number of cases by dialect and area, and of questions: a question is a program with what it observes, a case a question in a
/// dialect.
pub(super) fn write_count(out: &mut dyn Write, cases: &[&Case], json: bool) -> io::Result<()> {
    let mut of_dialect: BTreeMap<DialectName, Vec<&Case>> = BTreeMap::new();
    for case in cases {
        of_dialect.entry(case.dialect).or_default().push(case);
    }
    let lines = of_dialect
        .iter()
        .map(|(dialect, cases)| CountLine::new(dialect.as_str(), cases));
    let all = CountLine::new("all", cases);
    let lines: Vec<CountLine<'_>> = lines.chain([all]).collect();
    if json {
        return lines.iter().try_for_each(|line| json_line(out, line));
    }
    let areas: Vec<&str> = lines
        .last()
        .map(|all| all.areas.keys().copied().collect())
        .unwrap_or_default();
    let mut table = Table::new(vec![Cell::left("Dialect")]);
    let heads = areas.iter().copied().chain(["cases", "questions"]);
    heads.for_each(|head| table.head(Cell::plain(head)));
    for line in &lines {
        let of_areas = areas
            .iter()
            .map(|area| line.areas.get(area).copied().unwrap_or_default());
        let numbers = of_areas.chain([line.cases, line.questions]);
        let cells = numbers.map(|number| Cell::plain(grouped(number)));
        table.row([Cell::left(line.dialect)].into_iter().chain(cells).collect());
    }
    table.write(out, None)
}

/// Writes each feature with the number of cases that use it, in the order of `features.toml`; as JSON with what it needs.
///
/// # Errors
/// Those of writing to `out`, and no threads.
pub(super) fn write_features(
    out: &mut dyn Write,
    features: &Features,
    cases: &[&Case],
    json: bool,
) -> anyhow::Result<()> {
    const CHUNK: usize = 2000;
    let count = |cases: &[&Case]| {
        let mut counted: BTreeMap<String, usize> = BTreeMap::new();
        for key in cases.iter().flat_map(|case| case.features()) {
            *counted.entry(key.into_owned()).or_default() += 1;
        }
        counted
    };
    let counted = WorkerPool::new(0).map(
        cases.chunks(CHUNK),
        || Ok::<_, SpawnError>(()),
        |(), chunk| Ok(count(chunk)),
    )?;
    let number = |key: &str| -> usize { counted.iter().filter_map(|counted| counted.get(key)).sum() };
    let width = features.iter().map(|feature| feature.key.len()).max();
    let width = width.unwrap_or_default();
    for Feature {
        key,
        title,
        tables,
        needs,
        ..
    } in features.iter()
    {
        let cases = number(key);
        if json {
            let line =
                json!({ "key": key, "title": title, "tables": tables, "needs": needs, "cases": cases });
            json_line(out, &line)?;
            continue;
        }
        let rows = tables
            .iter()
            .map(|(edition, rows)| format!("{rows} (edition {edition})"));
        let rows = join(rows, "; ");
        writeln!(
            out,
            "{cases:>8}  {BOLD}{key:width$}{BOLD:#}  {title}  {DIM}{rows}{DIM:#}"
        )?;
    }
    Ok(())
}

/// Writes three tables: sources and targets, sources and surroundings, targets and surroundings. As JSON it writes the combinations of
/// all three. Cases with a program of their own do not count.
///
/// # Errors
/// Those of writing to `out`.
pub(super) fn write_places(out: &mut dyn Write, cases: &[&Case], json: bool) -> io::Result<()> {
    let mut counts: BTreeMap<&Placement, usize> = BTreeMap::new();
    for placement in cases.iter().filter_map(|case| case.placement.as_deref()) {
        *counts.entry(placement).or_default() += 1;
    }
    if json {
        return counts.iter().try_for_each(|(placement, cases)| {
            let Placement {
                source,
                target,
                surrounding,
            } = placement;
            let line =
                json!({ "source": source, "target": target, "surrounding": surrounding, "cases": cases });
            json_line(out, &line)
        });
    }
    type Pair = for<'p> fn(&'p Placement) -> (&'p str, &'p str);
    let tables: [(&str, Pair); 3] = [
        ("sources and targets", |placed| (&placed.source, &placed.target)),
        ("sources and surroundings", |placed| {
            (&placed.source, &placed.surrounding)
        }),
        ("targets and surroundings", |placed| {
            (&placed.target, &placed.surrounding)
        }),
    ];
    for (at, (title, pair)) in tables.into_iter().enumerate() {
        let mut table: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for (placement, cases) in &counts {
            *table.entry(pair(placement)).or_default() += cases;
        }
        if at > 0 {
            writeln!(out)?;
        }
        write_table(out, title, &table)?;
    }
    Ok(())
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
    let names = (1..)
        .zip(&columns)
        .map(|(number, name)| format!("{number} {name}"));
    writeln!(out, "{DIM}{}{DIM:#}", join(names, " · "))
}
