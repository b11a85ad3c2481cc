//! The claims: what each section of each document says, and how the engines stand to it.

use super::{Page, inline};
use crate::claims::{Claim, Standing};
use crate::overview::Overview;

/// Writes one table: with a single engine its numbers, with several an engine a column.
pub(super) fn write(overview: &Overview, page: &mut Page) {
    page.add("\n## Claims\n\n");
    page.add("A claim is a section of a document. *Open*: the document does not say what must happen, ");
    page.add("so what the engine does is recorded and not judged.\n\n");
    match &overview.engines()[..] {
        [_] | [] => of_one_engine(overview, page),
        engines => of_several_engines(overview, engines, page),
    }
}

/// Engines as columns, claims as rows.
fn of_several_engines(overview: &Overview, engines: &[&str], page: &mut Page) {
    page.add("| | document | section |");
    engines
        .iter()
        .for_each(|engine| page.add(&format!(" {} |", inline(engine))));
    page.add("\n|---|---|---|");
    engines.iter().for_each(|_| page.add("--:|"));
    page.add("\n");
    for row in overview.claims.rows(engines) {
        let section = match (row.sum, row.section) {
            (true, _) => "*all*".to_owned(),
            // The whole document has a row already.
            (false, "") => continue,
            (false, section) => inline(section),
        };
        let mark = if row.failed() { "**✗**" } else { "" };
        let mut line = format!("| {mark} | {} | {section} |", inline(row.source));
        row.standings
            .iter()
            .for_each(|standing| line.push_str(&format!(" {} |", cell(*standing))));
        line.push('\n');
        page.add(&line);
    }
    page.add("\nn/m: n of m cases came out as the document says. -: the engine has no case of this claim.\n");
}

/// How an engine stands to a claim, in a few words.
fn cell(standing: Standing) -> String {
    let Standing {
        passed,
        failed,
        open,
        unsupported,
        ..
    } = standing;
    let mut words = Vec::new();
    match (passed + failed, failed) {
        (0, _) => {}
        (judged, 0) => words.push(format!("{passed}/{judged}")),
        (judged, _) => words.push(format!("**{passed}/{judged}**")),
    }
    if open > 0 {
        words.push(format!("{open} open"));
    }
    if unsupported > 0 {
        words.push(format!("{unsupported} unsupported"));
    }
    match words.is_empty() {
        true => "-".to_owned(),
        false => words.join(", "),
    }
}

fn of_one_engine(overview: &Overview, page: &mut Page) {
    page.add("| | document | section | passed | failed | open | unsupported |\n");
    page.add("|---|---|---|--:|--:|--:|--:|\n");
    for document in overview.claims.documents() {
        page.add(&claim_row(&document, "*all*"));
        let sections = overview
            .claims
            .iter()
            .filter(|claim| (claim.engine, claim.source) == (document.engine, document.source));
        for section in sections.filter(|claim| !claim.section.is_empty()) {
            page.add(&claim_row(&section, &inline(section.section)));
        }
    }
}

fn claim_row(claim: &Claim<'_>, section: &str) -> String {
    let Standing {
        passed,
        failed,
        open,
        unsupported,
        ..
    } = claim.standing;
    let mark = if failed == 0 { "" } else { "**✗**" };
    let failed = if failed == 0 {
        "0".to_owned()
    } else {
        format!("**{failed}**")
    };
    let source = inline(claim.source);
    format!("| {mark} | {source} | {section} | {passed} | {failed} | {open} | {unsupported} |\n")
}
