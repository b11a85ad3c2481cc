//! Writes the claims as Markdown: each section of each document, and the results of the engines.

use super::BoundedMarkdown;
use crate::claims::{Row, Standing};
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
    let rows = overview.claims.rows(&engines);
    match &engines[..] {
        [_] => of_one_engine(overview, &rows, page),
        _ => of_several_engines(overview, &rows, &engines, page),
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
    let kind = source.map(|source| source.relation.with_kind(&source.kind));
    Some(format!(
        "| {mark} | {} | {} | {section} |",
        inline(row.source),
        inline(kind.as_deref().unwrap_or_default())
    ))
}

/// Writes a table with engines as columns and claims as rows.
fn of_several_engines(overview: &Overview, rows: &[Row<'_>], engines: &[&str], page: &mut BoundedMarkdown) {
    let names = engines.iter().map(|engine| inline(engine));
    page.add(&format!("| | source | kind | section |{}\n", cells(names)));
    page.add(&format!("|---|---|---|---|{}\n", "--:|".repeat(engines.len())));
    for row in rows {
        if let Some(name) = name(overview, row) {
            page.add(&format!("{name}{}\n", cells(row.standings.iter().map(cell))));
        }
    }
    page.add("\nn/m: n of m cases came out as the source says. -: the engine has no case of this claim.\n");
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

fn of_one_engine(overview: &Overview, rows: &[Row<'_>], page: &mut BoundedMarkdown) {
    page.add("| | source | kind | section | passed | failed | differs | open | unsupported | waiting |\n");
    page.add("|---|---|---|---|--:|--:|--:|--:|--:|--:|\n");
    for row in rows {
        if let (Some(name), [standing]) = (name(overview, row), &row.standings[..]) {
            let failed = match standing.failed {
                0 => "0".to_owned(),
                failed => format!("**{failed}**"),
            };
            let [passed, differs, open, unsupported, waiting] = [
                standing.passed,
                standing.differs,
                standing.open,
                standing.unsupported,
                standing.waiting,
            ]
            .map(|number| number.to_string());
            let numbers = cells([passed, failed, differs, open, unsupported, waiting]);
            page.add(&format!("{name}{numbers}\n"));
        }
    }
}
