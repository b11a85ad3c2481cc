//! The first page of the site: a row an engine, a column an area, and the changes, newest first.

use super::feed;
use super::functions::Functions;
use super::history::History;
use super::html::{escaped, page_with, share};
use std::collections::BTreeSet;

/// Returns the page.
pub(super) fn page(histories: &[History<'_>], functions: &Functions<'_>) -> String {
    let conversions = match functions.names().is_empty() {
        true => "",
        false => {
            "<p><a href=\"functions/index.html\">Conversion functions</a>: what each gives for which value, by documents, on engines and \
             on recorded compilers.</p>\n<p><a href=\"functions/index.html#contradictions\">Contradictions</a>: where sources give different \
             answers to one question.</p>\n"
        }
    };
    let body = format!(
        "<p>Each number is of the newest run of an engine: passed cases of those that a document decides and the engine \
         supports.</p>\n{}{conversions}<h2>Changes</h2>\n<p><a href=\"feed.xml\">As an Atom feed</a></p>\n{}<h2>Hand in results</h2>\n<p>A row is made of the \
         <code>events.jsonl.gz</code> of any run of <code>stickler run --engine …</code>; <a href=\"events.schema.json\">the JSON \
         Schema</a> of its lines is beside this page.</p>\n",
        table(histories),
        changes(histories)
    );
    let alternate = format!(
        "<link rel=\"alternate\" type=\"application/atom+xml\" title=\"{}\" href=\"{}\">\n",
        feed::TITLE,
        feed::NAME
    );
    page_with(
        &alternate,
        "Stickler: conformance of IEC 61131-3 compilers",
        &body,
    )
}

fn table(histories: &[History<'_>]) -> String {
    let newest = histories.iter().filter_map(|history| {
        let standings = &history.newest().run.standings;
        standings.get(history.name)
    });
    let areas: BTreeSet<&str> = newest
        .flat_map(|areas| areas.keys().map(String::as_str))
        .collect();
    let heads: String = areas
        .iter()
        .map(|area| format!("<th scope=\"col\">{}</th>", escaped(area)))
        .collect();
    let rows: String = histories.iter().map(|history| row(history, &areas)).collect();
    format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Engines\"><table>\n<thead><tr><th scope=\"col\">Engine</th><th \
         scope=\"col\">Version</th><th scope=\"col\">Date</th><th scope=\"col\">All</th>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

fn row(history: &History<'_>, areas: &BTreeSet<&str>) -> String {
    let newest = history.newest();
    let standings = newest.run.standings.get(history.name);
    let cells: String = areas
        .iter()
        .map(|area| {
            share(
                standings
                    .and_then(|areas| areas.get(*area))
                    .copied()
                    .unwrap_or_default(),
            )
        })
        .collect();
    format!(
        "<tr><th scope=\"row\"><a href=\"engines/{}\">{}</a></th><td>{}</td><td>{}</td>{}{cells}</tr>\n",
        history.file,
        escaped(history.name),
        escaped(newest.version),
        newest.run.date(),
        share(newest.run.sum(history.name)),
    )
}

fn changes(histories: &[History<'_>]) -> String {
    let steps = History::newest_steps(histories);
    if steps.is_empty() {
        return "<p>No engine has runs of two versions yet.</p>\n".to_owned();
    }
    let mut list = "<ul>\n".to_owned();
    for (history, step) in steps {
        list.push_str(&format!(
            "<li>{}: <a href=\"engines/{}\">{}</a> from {} to {}: {}</li>\n",
            step.new.run.date(),
            history.file,
            escaped(history.name),
            escaped(step.old.version),
            escaped(step.new.version),
            escaped(&step.numbers())
        ));
    }
    list + "</ul>\n"
}
