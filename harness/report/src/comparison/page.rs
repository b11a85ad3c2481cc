//! Writes a comparison on the terminal: what is worse, case by case; all else in numbers; and one line with the result. Writes it as JSON, too.

use super::{Change, ComparedTexts, Comparison, Kind, UnmatchedCase};
use crate::observations::probe;
use crate::overview;
use crate::terminal::failure::write_difference;
use crate::terminal::{BAD, BOLD, DIM, GOOD};
use crate::text::{verdicts, visible};
use anstyle::Style;
use indexmap::IndexMap;
use serde_json::{Value, json};
use std::io::{self, Write};
use stickler_run::{Header, Totals};
use stickler_types::counted;

/// The maximum number of groups of one kind that are shown.
const MAX_SHOWN: usize = 20;

/// The version of the JSON format.
const FORMAT: u32 = 1;

/// Writes the comparison as one JSON object and a line feed, for other programs. All changes are in it, the first
/// [`MAX_DETAILED`](super::MAX_DETAILED) of each kind with their expected and actual texts.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write_json(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    let engines = comparison.engines.iter();
    let engines: Vec<Value> = engines
        .map(|(old, new)| json!({ "old": old, "new": new }))
        .collect();
    let mut counts = json!({
        "added": comparison.added.len(), "gone": comparison.gone.len(), "same": comparison.same,
    });
    for kind in Kind::ALL {
        counts[kind.as_str()] = comparison.of_kind(kind).count().into();
    }
    let document = json!({
        "format": FORMAT,
        "old": comparison.old,
        "new": comparison.new,
        "engines": engines,
        "counts": counts,
        "changes": comparison.changes,
        "added": comparison.added,
        "gone": comparison.gone,
    });
    writeln!(out, "{document:#}")
}

/// Writes the comparison.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    write_runs(out, comparison)?;
    let several = comparison.engines.len() > 1;
    for kind in Kind::ALL {
        let groups = groups(comparison.of_kind(kind));
        for group in groups.iter().take(MAX_SHOWN) {
            match kind {
                Kind::Crashed | Kind::Broken => write_whole(out, group, several)?,
                Kind::Fixed | Kind::Otherwise => write_line(out, group, several)?,
            }
        }
        write_rest(out, kind, &groups)?;
    }
    write_unmatched(out, "new", &comparison.added)?;
    write_unmatched(out, "gone", &comparison.gone)?;
    write_last_line(out, comparison)
}

fn write_runs(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    let Comparison {
        old, new, engines, ..
    } = comparison;
    for (label, header, taken) in [
        ("old", old, engines.iter().map(|(old, _)| old).collect::<Vec<_>>()),
        ("new", new, engines.iter().map(|(_, new)| new).collect()),
    ] {
        let versions: Vec<String> = taken.iter().map(|name| version(header, name)).collect();
        writeln!(
            out,
            "{BOLD}{label}{BOLD:#}  {}; suite {}, {}",
            versions.join(", "),
            visible(&header.suite),
            visible(&header.started)
        )?;
        let compared = |name: &&str| !taken.iter().any(|taken| taken == name);
        let names = header.engines.iter().map(|engine| engine.name.as_str());
        let left: Vec<&str> = names.filter(compared).collect();
        if !left.is_empty() {
            writeln!(
                out,
                "     {DIM}not compared, since the other run lacks it: {}{DIM:#}",
                visible(&left.join(", "))
            )?;
        }
    }
    writeln!(out)
}

fn version(header: &Header, name: &str) -> String {
    let version = overview::named(&header.engines, name).map_or("", |engine| engine.version.as_str());
    visible(format!("{name} {version}").trim_end())
}

/// Groups the cases of one probe in one dialect that changed alike.
fn groups<'c>(changes: impl Iterator<Item = &'c Change>) -> Vec<Vec<&'c Change>> {
    let mut groups: IndexMap<_, Vec<&Change>> = IndexMap::new();
    for change in changes {
        let Change {
            dialect,
            engine,
            old,
            new,
            ..
        } = change;
        let alike = (probe(&change.id), dialect, engine, *old, *new);
        groups.entry(alike).or_default().push(change);
    }
    groups.into_values().collect()
}

fn style(kind: Kind) -> Style {
    match kind {
        Kind::Crashed | Kind::Broken => BAD,
        Kind::Fixed => GOOD,
        Kind::Otherwise => DIM,
    }
}

/// Writes the first line of a group: `BROKEN 12 cases of widening/integer::assignment in ironplc-ed2: pass → fail`
fn write_head(out: &mut dyn Write, group: &[&Change], several: bool) -> io::Result<()> {
    let Some(first) = group.first() else {
        return Ok(());
    };
    let style = style(first.kind);
    write!(out, "{style}{}{style:#} ", first.kind.as_str().to_uppercase())?;
    match group.len() {
        1 => write!(out, "{BOLD}{}@{}{BOLD:#}", first.id, first.dialect)?,
        number => write!(
            out,
            "{BOLD}{number} cases of {}{BOLD:#} in {}",
            probe(&first.id),
            first.dialect
        )?,
    }
    if several {
        write!(out, " on {}", visible(&first.engine))?;
    }
    match first.old == first.new {
        true => writeln!(out, ": {} as before, and not the same", first.new),
        false => writeln!(out, ": {} → {}", first.old, first.new),
    }
}

fn write_whole(out: &mut dyn Write, group: &[&Change], several: bool) -> io::Result<()> {
    write_head(out, group, several)?;
    let detailed = group
        .iter()
        .find_map(|change| change.detail.as_deref().map(|detail| (change, detail)));
    let Some((change, detail)) = detailed else {
        return writeln!(out);
    };
    if group.len() > 1 {
        writeln!(out, "     {DIM}such as{DIM:#}  {}", change.id)?;
    }
    writeln!(out, "     {}", visible(&detail.title))?;
    writeln!(out, "     {DIM}basis   {DIM:#} {}", visible(&detail.basis))?;
    writeln!(out, "     {DIM}at      {DIM:#} {}", detail.place)?;
    write_texts(out, change, detail)?;
    writeln!(out, "     {DIM}rerun   {DIM:#} {}\n", visible(&detail.rerun))
}

fn write_texts(out: &mut dyn Write, change: &Change, detail: &ComparedTexts) -> io::Result<()> {
    let then = detail.old.as_deref().unwrap_or("what was expected then");
    if let Some(expected) = detail.expected.as_deref().filter(|expected| *expected != then) {
        let changed = match change.expectation_changed {
            true => " (it was something else in the older run)",
            false => "",
        };
        let expected = visible(expected).replace('\n', "\n                ");
        writeln!(out, "     {DIM}expected{DIM:#}   {expected}{DIM}{changed}{DIM:#}")?;
    }
    write_difference(out, ("new", &detail.new), ("old", then))
}

/// Writes a group in one line, and the results of its first case in a second one.
fn write_line(out: &mut dyn Write, group: &[&Change], several: bool) -> io::Result<()> {
    write_head(out, group, several)?;
    let Some(first) = group.first().filter(|first| first.kind == Kind::Otherwise) else {
        return Ok(());
    };
    let Some(detail) = first.detail.as_deref() else {
        return Ok(());
    };
    if group.len() > 1 {
        writeln!(out, "     {DIM}such as{DIM:#}  {}", first.id)?;
    }
    write_texts(out, first, detail)
}

fn write_rest(out: &mut dyn Write, kind: Kind, groups: &[Vec<&Change>]) -> io::Result<()> {
    let rest = groups.get(MAX_SHOWN..).unwrap_or_default();
    let cases: usize = rest.iter().map(|group| group.len()).sum();
    if cases > 0 {
        let style = style(kind);
        let cases = counted(cases as u64, "case", "cases");
        writeln!(
            out,
            "{style}... and {cases} more{style:#} {}; --json has them all",
            kind.as_str()
        )?;
    }
    match groups.is_empty() {
        true => Ok(()),
        false => writeln!(out),
    }
}

/// Writes the number of cases that only one run has: `5 cases are new: 4 pass, 1 fail`
fn write_unmatched(out: &mut dyn Write, word: &str, cases: &[UnmatchedCase]) -> io::Result<()> {
    if cases.is_empty() {
        return Ok(());
    }
    let mut totals = Totals::default();
    cases.iter().for_each(|case| totals.count(case.verdict));
    let number = counted(cases.len() as u64, "case is", "cases are");
    writeln!(out, "{number} {word}: {}", verdicts(&totals, |_| true))
}

fn write_last_line(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    let compared = comparison.changes.len() as u64 + comparison.same;
    let numbers: Vec<String> = Kind::ALL
        .into_iter()
        .map(|kind| (kind, comparison.of_kind(kind).count()))
        .filter(|(_, number)| *number > 0)
        .map(|(kind, number)| format!("{number} {}", kind.as_str()))
        .collect();
    let cases = counted(compared, "case", "cases");
    if compared == 0 {
        return writeln!(out, "{BAD}No case is in both runs.{BAD:#}");
    }
    if numbers.is_empty() {
        return writeln!(out, "{GOOD}{cases}: all as before.{GOOD:#}");
    }
    let style = if comparison.is_worse() { BAD } else { GOOD };
    writeln!(
        out,
        "{style}{cases}: {}{style:#}; {} as before.",
        numbers.join(", "),
        comparison.same
    )
}
