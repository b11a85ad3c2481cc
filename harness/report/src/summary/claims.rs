//! Writes the claims as Markdown: each section of each document, and the results of the engines.

use super::BoundedMarkdown;
use crate::claims::{COLUMNS, Row, Standing};
use crate::markdown::{cells, inline, linked};
use crate::overview::Overview;

/// Writes one table: for a single engine with its numbers, for several with one column per engine.
pub(super) fn write(overview: &Overview, page: &mut BoundedMarkdown) {
    page.add("\n## Claims\n\n");
    page.add("A claim is a section of a source. *Open*: no source in Stickler says what must happen, ");
    page.add("so what the engine does is recorded and not judged. ");
    page.add(
        "*Differs*: the engine does something else, but the source does not speak for it, or is a rule of ",
    );
    page.add("Stickler: no failure.\n\n");
    let engines = overview.engines();
    let heads: Vec<String> = match &engines[..] {
        [_] => COLUMNS.iter().map(|(head, _)| (*head).to_owned()).collect(),
        engines => engines.iter().map(|engine| inline(engine)).collect(),
    };
    let rule = "--:|".repeat(heads.len());
    page.add(&format!("| | source | kind | section |{}\n", cells(heads)));
    page.add(&format!("|---|---|---|---|{rule}\n"));
    for row in overview.claims.rows(&engines) {
        let Some(name) = name(overview, &row) else {
            continue;
        };
        let numbers = match &row.standings[..] {
            [standing] => cells(
                COLUMNS
                    .iter()
                    .map(|(head, count)| count_cell(head, count(standing))),
            ),
            standings => cells(standings.iter().map(cell)),
        };
        page.add(&format!("{name}{numbers}\n"));
    }
    if engines.len() != 1 {
        page.add(
            "\nn/m: n of m cases came out as the source says. -: the engine has no case of this claim.\n",
        );
    }
}

/// Returns the first cells of a row: a mark where an engine does not meet the claim, the source with its kind, and the section,
/// which leads to its address. `None` where the row is not shown: a section without a name is the whole source, which has a
/// row already.
fn name(overview: &Overview, row: &Row<'_>) -> Option<String> {
    let source = overview.source(row.source);
    let section = match (row.sum, row.section) {
        (true, _) => "*all*".to_owned(),
        (false, "") => return None,
        (false, section) => match source {
            Some(source) => linked(section, &source.address_of(section)),
            None => inline(section),
        },
    };
    let mark = if row.failed() { "**✗**" } else { "" };
    let kind = source.map(|source| source.relation.with_kind(source.kind.as_str()));
    Some(format!(
        "| {mark} | {} | {} | {section} |",
        inline(row.source),
        inline(kind.as_deref().unwrap_or_default())
    ))
}

/// Formats an engine's results for a claim in a few words.
fn cell(standing: &Standing) -> String {
    let (passed, judged) = (standing.passed, standing.decided());
    let judged = match (judged, standing.failed) {
        (0, _) => None,
        (_, 0) => Some(format!("{passed}/{judged}")),
        _ => Some(format!("**{passed}/{judged}**")),
    };
    let others = [
        (standing.differs, "differ"),
        (standing.open, "open"),
        (standing.unsupported, "unsupported"),
        (standing.waiting, "waiting"),
    ];
    let others = others.into_iter().filter(|(number, _)| *number > 0);
    let others = others.map(|(number, word)| format!("{number} {word}"));
    let words: Vec<String> = judged.into_iter().chain(others).collect();
    match words.is_empty() {
        true => "-".to_owned(),
        false => words.join(", "),
    }
}

/// Formats one number of an engine's results for a claim.
fn count_cell(head: &str, number: u64) -> String {
    match (head, number) {
        ("failed", 1..) => format!("**{number}**"),
        _ => number.to_string(),
    }
}
