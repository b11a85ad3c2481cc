//! Writes a case that is not as expected on the terminal, with everything that is needed to investigate it.

use super::{BAD, BOLD, DIM, GOOD};
use crate::diff::{self, DiffLine, Side};
use crate::text::{MAX_SHOWN_CHARACTERS, clip, noted, visible};
use crate::{compared, overview};
use anstyle::{AnsiColor, Style};
use std::io::{self, Write};
use stickler_run::{CaseEvent, EngineHeader, Verdict};

const BAD_PIECE: Style = AnsiColor::Red.on_default().bold().underline();
const GOOD_PIECE: Style = AnsiColor::Green.on_default().bold().underline();

/// The maximum number of lines that are shown of each text.
const MAX_SHOWN_LINES: usize = 40;

/// Writes one case that is not as expected, and how to run it again.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(
    out: &mut dyn Write,
    case: &CaseEvent,
    engine: Option<&EngineHeader>,
    name_engine: bool,
) -> io::Result<()> {
    let verdict = case.verdict.as_str().to_uppercase();
    write!(
        out,
        "{BAD}{verdict}{BAD:#} {BOLD}{}@{}{BOLD:#}",
        case.id, case.dialect
    )?;
    if name_engine {
        write!(out, " on {}", case.engine)?;
    }
    writeln!(out, "\n     {}", visible(&case.title))?;
    writeln!(out, "     {DIM}basis   {DIM:#} {}", visible(&case.basis))?;
    writeln!(out, "     {DIM}at      {DIM:#} {}", case.place())?;
    if let Some(note) = &case.baseline {
        writeln!(out, "     {DIM}baseline{DIM:#} {}", noted(note))?;
    }
    // A pass has no difference to show, even where it is not expected.
    if case.verdict != Verdict::Xpass {
        let (expected, got) = compared::texts(case, overview::strictness(engine));
        write_difference(out, ("expected", &expected), ("got", &got))?;
    }
    writeln!(
        out,
        "     {DIM}rerun   {DIM:#} {}\n",
        visible(&overview::rerun(engine, case))
    )
}

/// Writes two texts with their labels: one-line texts below each other, longer ones as a diff.
pub(crate) fn write_difference(
    out: &mut dyn Write,
    (before, expected): (&str, &str),
    (after, got): (&str, &str),
) -> io::Result<()> {
    let expected = clip(&visible(expected), MAX_SHOWN_LINES, MAX_SHOWN_CHARACTERS);
    let got = clip(&visible(got), MAX_SHOWN_LINES, MAX_SHOWN_CHARACTERS);
    let lines = diff::lines(&expected, &got);
    if expected.lines().count() > 1 || got.lines().count() > 1 || lines.is_empty() {
        writeln!(
            out,
            "     {DIM}diff    {DIM:#} {GOOD}+ {before}{GOOD:#} {BAD}- {after}{BAD:#}"
        )?;
        for line in &lines {
            write!(out, "              ")?;
            write_diff_line(out, line)?;
        }
        return Ok(());
    }
    for (label, side) in [(before, Side::Expected), (after, Side::Got)] {
        write!(out, "     {DIM}{label:<8}{DIM:#} ")?;
        match lines.iter().find(|line| line.side == side) {
            Some(line) => write_diff_line(out, line)?,
            None => writeln!(out, "{} (nothing)", side.sign())?,
        }
    }
    Ok(())
}

fn write_diff_line(out: &mut dyn Write, line: &DiffLine) -> io::Result<()> {
    let (plain, marked) = match line.side {
        Side::Gap => return writeln!(out, "  {DIM}...{DIM:#}"),
        Side::Both => (DIM, DIM),
        Side::Expected => (GOOD, GOOD_PIECE),
        Side::Got => (BAD, BAD_PIECE),
    };
    write!(out, "{plain}{}{plain:#} ", line.side.sign())?;
    for (differs, piece) in &line.pieces {
        let style = if *differs { marked } else { plain };
        write!(out, "{style}{piece}{style:#}")?;
    }
    writeln!(out)
}
