//! `stickler list --count`: how many cases each dialect has in each area, and how many questions they ask.

use super::json_line;
use serde::Serialize;
use std::collections::{BTreeMap, HashSet};
use std::io::{self, Write};
use stickler_conversions::table::{Cell, Table};
use stickler_suite::Case;
use stickler_types::{DialectName, grouped};

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
pub(super) fn write(out: &mut dyn Write, cases: &[&Case], json: bool) -> io::Result<()> {
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
