//! The page of an engine: its history, what each version fixed and broke, and the causes of the newest run's failures.

use super::functions::{Functions, address};
use super::history::{History, VersionStep};
use super::html::{chart, escaped, page as whole, share};
use super::versions::VersionRun;
use crate::comparison::{Change, Kind};
use std::collections::BTreeMap;
use stickler_types::counted;

/// The maximum number of cases that are listed of each claim.
const MAX_LISTED: usize = 20;

/// Returns the page.
pub(super) fn page(history: &History<'_>, functions: &Functions<'_>) -> String {
    let shares = history
        .counted
        .iter()
        .filter_map(|run| run.run.sum(history.name).per_mille());
    let shares: Vec<u64> = shares.collect();
    let steps: String = history.steps.iter().rev().map(write_step).collect();
    let body = format!(
        "<p><a href=\"../index.html\">All engines</a></p>\n<h2>History</h2>\n{}{}{steps}{}{}",
        chart(&shares),
        runs(history),
        causes(history),
        departures(history, functions)
    );
    whole(history.name, &body)
}

fn runs(history: &History<'_>) -> String {
    let rows: String = history
        .runs
        .iter()
        .rev()
        .map(|run| run_row(history.name, run))
        .collect();
    format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Runs\"><table>\n<thead><tr><th scope=\"col\">Date</th><th \
         scope=\"col\">Version</th><th scope=\"col\">Passed of decided</th><th scope=\"col\">Run</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

fn run_row(engine: &str, run: &VersionRun<'_>) -> String {
    let header = &run.run.header;
    let page = match run.run.page {
        Some(_) => format!("<a href=\"../runs/{}\">its page</a>", run.run.page_name()),
        None => "without a page".to_owned(),
    };
    let part = header.shard.iter().map(|shard| format!("; part {shard}"));
    let replaced = run
        .reason(engine)
        .map(|reason| format!("; does not count: {reason}"));
    let notes: String = part.chain(replaced).collect();
    format!(
        "<tr><td>{}</td><td>{}</td>{}<td>{page}; suite {}{}</td></tr>\n",
        run.run.date(),
        escaped(run.version),
        share(run.run.sum(engine)),
        escaped(&header.suite),
        escaped(&notes)
    )
}

fn write_step(step: &VersionStep<'_>) -> String {
    let kinds = [
        (Kind::Crashed, "Crashed"),
        (Kind::Broken, "Broken"),
        (Kind::Fixed, "Fixed"),
    ];
    let lists: String = kinds
        .iter()
        .map(|(kind, title)| changes(title, step.of_kind(*kind).collect()))
        .collect();
    format!(
        "<h2>From {} to {}</h2>\n<p>{}</p>\n{lists}",
        escaped(step.old.version),
        escaped(step.new.version),
        escaped(&step.numbers())
    )
}

/// Returns the changes of one kind by claim, the claims with most cases first.
fn changes(title: &str, changes: Vec<&Change>) -> String {
    if changes.is_empty() {
        return String::new();
    }
    let mut claims: BTreeMap<&str, Vec<&Change>> = BTreeMap::new();
    for change in changes {
        let basis = change.detail.as_deref().map(|detail| detail.basis.as_str());
        let claim = basis.unwrap_or("Further cases, whose claims are in the comparison of the two runs");
        claims.entry(claim).or_default().push(change);
    }
    let mut claims: Vec<(&str, Vec<&Change>)> = claims.into_iter().collect();
    claims.sort_by_key(|(_, changes)| std::cmp::Reverse(changes.len()));
    let mut html = format!("<h3>{title}</h3>\n");
    for (claim, changes) in claims {
        let cases = counted(changes.len() as u64, "case", "cases");
        html.push_str(&format!(
            "<details><summary>{}: {cases}</summary><ul>\n{}</ul></details>\n",
            escaped(claim),
            listed(&changes)
        ));
    }
    html
}

fn listed(changes: &[&Change]) -> String {
    let item = |change: &&Change| {
        let changed = match change.expectation_changed {
            true => " (the suite expects something else now)",
            false => "",
        };
        let name = escaped(&format!("{}@{}", change.id, change.dialect));
        format!(
            "<li><code>{name}</code>: {} → {}{changed}</li>\n",
            change.old, change.new
        )
    };
    let mut items: String = changes.iter().take(MAX_LISTED).map(item).collect();
    if let Some(rest) = changes.len().checked_sub(MAX_LISTED).filter(|rest| *rest > 0) {
        items.push_str(&format!("<li>and {rest} more, which are not listed here</li>\n"));
    }
    items
}

/// Returns the causes of the newest run, those that explain most cases first, as the run has them.
fn causes(history: &History<'_>) -> String {
    let causes = history.newest().run.causes.iter();
    let of_engine = causes.filter(|cause| cause.engine == history.name);
    let item = |cause: &stickler_run::Cause| {
        let cases: u64 = cause.cases.iter().map(|explained| explained.cases).sum();
        format!(
            "<li>{}: {}</li>\n",
            escaped(&cause.title),
            counted(cases, "case", "cases")
        )
    };
    let items: String = of_engine.map(item).collect();
    match items.is_empty() {
        true => String::new(),
        false => format!("<h2>Causes in the newest run</h2>\n<ol>\n{items}</ol>\n"),
    }
}

/// Returns the conversion functions for which the newest run has other results than its sources.
fn departures(history: &History<'_>, functions: &Functions<'_>) -> String {
    let item = |(name, calls): &(&str, usize)| {
        let values = counted(*calls as u64, "value", "values");
        format!(
            "<li><a href=\"../functions/{}\">{}</a>: {values}</li>\n",
            address(name),
            escaped(name)
        )
    };
    let departing = functions.departures(history.name);
    if departing.is_empty() {
        return String::new();
    }
    let items: String = departing.iter().map(item).collect();
    format!(
        "<h2>Conversion functions that give something else</h2>\n<details><summary>{}</summary><ul>\n{items}</ul></details>\n",
        counted(departing.len() as u64, "function", "functions")
    )
}
