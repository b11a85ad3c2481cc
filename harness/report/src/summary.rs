//! `summary.md`: the run as Markdown, small enough for the step summary of a CI service.

mod claims;
mod observed;

use crate::basis::Basis;
use crate::discrepancies::{NAME, titled};
use crate::markdown::{cells, code, fence, inline, linked};
use crate::overview::Overview;
use crate::terminal::causes::said;
use crate::text::{
    MAX_SHOWN_CHARACTERS, clip, judged, lacking, noted, outdated, outdated_entries, took, visible,
};
use crate::{compared, diff, overview};
use stickler_run::{CaseEvent, Cause, DefinedHeader, EngineHeader, Totals};
use stickler_types::{counted, grouped, join};

/// The maximum length of the document, in bytes. A step summary may have 1 MiB; the rest is left to other steps.
const MAX_BYTES: usize = 900_000;

/// The maximum number of causes that are shown.
const MAX_SHOWN_CAUSES: usize = 100;
/// The maximum number of failures that are shown.
const MAX_SHOWN_FAILURES: usize = 100;
/// The maximum number of lines that are shown of each text.
const MAX_SHOWN_LINES: usize = 60;

/// Returns the summary as Markdown, at most `MAX_BYTES` long.
pub fn markdown(overview: &Overview) -> String {
    let mut page = BoundedMarkdown {
        text: String::new(),
        left_out: 0,
    };
    page.add(&heading(overview));
    claims::write(overview, &mut page);
    totals(overview, &mut page);
    lacks(overview, &mut page);
    observed::write(overview, &mut page);
    failures(overview, &mut page);
    page.text
}

/// A Markdown text that grows up to its limit; further sections are only counted.
struct BoundedMarkdown {
    text: String,
    left_out: u64,
}

impl BoundedMarkdown {
    fn add(&mut self, part: &str) {
        if self.left_out > 0 || self.text.len() + part.len() > MAX_BYTES {
            self.left_out += 1;
        } else {
            self.text.push_str(part);
        }
    }
}

fn heading(overview: &Overview) -> String {
    let cases = counted(overview.sum().all(), "case", "cases");
    let verdict = match overview.failed {
        0 => match overview.outdated().count() {
            0 => format!("{cases}, all as expected"),
            number => format!("{cases}, all as expected, but {}", outdated_entries(number)),
        },
        failed => format!("{} of {cases} not as expected", grouped(failed)),
    };
    let lacking = lacking(overview).map_or(String::new(), |lacking| format!(", and {lacking}"));
    let mut text = format!("# Stickler: {verdict}{lacking}\n\n");
    if let Some(header) = &overview.header {
        let described =
            |engine: &EngineHeader| format!("{} {}{}", engine.name, engine.version, judged(engine.strict));
        let engines = join(header.engines.iter().map(described), ", ");
        text += &format!("Suite {} on {engines}, {}", header.suite, header.started);
        if let Some(shard) = &header.shard {
            text += &format!(", part {shard} of the suite");
        }
    }
    if let Some(footer) = &overview.footer {
        text += &format!(", in {}", took(footer));
    }
    text.push_str(".\n\n");
    let dialects = overview.header.iter().flat_map(|header| &header.defined);
    for line in dialects.take(50).flat_map(defined) {
        text += &format!("- {}\n", inline(&line));
    }
    for broken in overview
        .header
        .iter()
        .flat_map(|header| &header.broken_files)
        .take(50)
    {
        text += &format!("- **broken case file** {}\n", inline(broken));
    }
    for entry in overview.outdated().take(50) {
        text += &format!("- **out of date** {}\n", inline(&outdated(entry)));
    }
    text
}

fn totals(overview: &Overview, page: &mut BoundedMarkdown) {
    let areas = overview.areas();
    let heads = cells(areas.iter().map(|area| inline(area)));
    page.add(&format!("\n## Cases\n\n| engine | dialect |{heads} all |\n"));
    page.add(&format!("|---|---|{}--:|\n", "--:|".repeat(areas.len())));
    for (engine, dialects) in &overview.totals {
        for (dialect, totals) in dialects {
            let sum = totals.values().sum();
            let of_areas = areas.iter().map(|area| totals.get(*area));
            let numbers = cells(of_areas.chain([Some(&sum)]).map(total_cell));
            page.add(&format!(
                "| {} | {} |{numbers}\n",
                inline(engine),
                inline(dialect)
            ));
        }
    }
    if overview.failed > 0 {
        page.add("\nn/m: n of m cases are as expected.\n");
    }
}

fn total_cell(totals: Option<&Totals>) -> String {
    match totals.map(|totals| (totals.all(), totals.unexpected())) {
        None | Some((0, _)) => "-".to_owned(),
        Some((all, 0)) => all.to_string(),
        Some((all, unexpected)) => format!("**{}/{all}**", all - unexpected),
    }
}

/// Adds the table of the features that engines lack.
fn lacks(overview: &Overview, page: &mut BoundedMarkdown) {
    if overview.lacks.is_empty() {
        return;
    }
    page.add(
        "\n## Features that are lacking\n\nEach is judged once, by its minimal program; **bold** is what somebody promises. The cases \
         that use it are refused, and wait for it.\n\n| feature | engine | what the compiler said | waiting |\n|---|---|---|--:|\n",
    );
    for lack in &overview.lacks {
        let feature = match lack.is_failing_lack() {
            true => format!("**{}**", titled(&lack.title)),
            false => titled(&lack.title),
        };
        let (engine, said) = (inline(&lack.engine), inline(&said(lack)));
        page.add(&format!(
            "| {feature} | {engine} | {said} | {} |\n",
            lack.number()
        ));
    }
}

fn failures(overview: &Overview, page: &mut BoundedMarkdown) {
    if overview.failed == 0 {
        return;
    }
    page.add(&format!(
        "\n## Not as expected\n\nA page for each cause is in `{NAME}/`, beside this file.\n"
    ));
    causes(overview, page);
    let shown: Vec<&CaseEvent> = overview.failures().take(MAX_SHOWN_FAILURES).collect();
    let tried = shown.len() as u64;
    page.left_out = 0;
    shown.iter().for_each(|case| page.add(&failure(case, overview)));
    let rest = overview.failed - tried + page.left_out;
    if rest > 0 {
        // The note is short, and the limit leaves room for it.
        page.text += &format!("\n... and {rest} more; `events.jsonl.gz` has them all.\n");
    }
}

/// Adds the causes that explain most of the cases that are not as expected, where causes were searched for.
fn causes(overview: &Overview, page: &mut BoundedMarkdown) {
    let (small, unreduced) = overview.unexpected_causes();
    if !small.is_empty() {
        page.add("\n| cases | cause | engine | claim |\n|--:|---|---|---|\n");
    }
    for cause in small.iter().take(MAX_SHOWN_CAUSES) {
        page.add(&format!(
            "| {} | {} | {} | {} |\n",
            cause.cases_shown(),
            inline(&cause.title),
            inline(&cause.engine),
            inline(&cause.shown.basis)
        ));
    }
    let explained = |causes: &[&Cause]| {
        counted(
            causes.iter().map(|cause| cause.unexpected()).sum(),
            "case",
            "cases",
        )
    };
    let rest = &small[small.len().min(MAX_SHOWN_CAUSES)..];
    if !rest.is_empty() {
        page.add(&format!(
            "\n{} more, of {}.\n",
            counted(rest.len() as u64, "cause", "causes"),
            explained(rest)
        ));
    }
    if !unreduced.is_empty() {
        page.add(&format!(
            "\nThe search ended before {}, of {}, could be made as small as possible; most of them may show a cause of the list.\n",
            counted(unreduced.len() as u64, "program", "programs"),
            explained(&unreduced)
        ));
    }
}

fn failure(case: &CaseEvent, overview: &Overview) -> String {
    let engine = overview.engine(&case.engine);
    let (expected, got) = compared::texts(case, overview::strictness(engine));
    let expected = clip(&visible(&expected), MAX_SHOWN_LINES, MAX_SHOWN_CHARACTERS);
    let got = clip(&visible(&got), MAX_SHOWN_LINES, MAX_SHOWN_CHARACTERS);
    let difference = diff::text(&expected, &got);
    let difference = match difference.as_str() {
        // A pass that is not expected.
        "" => String::new(),
        text => format!("\n{fence}diff\n{text}{fence}\n", fence = fence(text)),
    };
    let baseline = case.baseline.as_ref().map_or(String::new(), |note| {
        format!("- baseline: {}\n", inline(&noted(note)))
    });
    format!(
        "\n### {verdict}: {id}@{dialect} on {engine}\n\n{title}\n\n- basis: {basis}\n- at: {place}\n\
         {baseline}- rerun: {rerun}\n{difference}",
        verdict = case.verdict,
        id = inline(&case.id),
        dialect = inline(&case.dialect),
        engine = inline(&case.engine),
        title = inline(&case.title),
        basis = basis(case, overview),
        place = inline(&case.place()),
        rerun = code(&overview::rerun(engine, case)),
    )
}

/// Returns the basis of a case, which leads to the address of its section.
fn basis(case: &CaseEvent, overview: &Overview) -> String {
    let Basis { source, section } = Basis::of(&case.basis);
    match overview.source(source) {
        Some(source) => linked(&case.basis, &source.address_of(section)),
        None => inline(&case.basis),
    }
}

/// Describes a custom dialect and the cases that are not run in it, one line each.
fn defined(dialect: &DefinedHeader) -> Vec<String> {
    let DefinedHeader { name, extends, .. } = dialect;
    let about: String = dialect.about.iter().map(|about| format!(" ({about})")).collect();
    let but = match &dialect.overrides[..] {
        [] => "with nothing overridden".to_owned(),
        overrides => format!("but for {}", overrides.join(", ")),
    };
    let mut lines = vec![format!("{name}{about} is {extends}, {but}")];
    if dialect.left_out > 0 {
        let cases = counted(dialect.left_out, "case", "cases");
        lines.push(format!(
            "{cases} of {extends} left out of {name}: what it overrides changes that, and no source in Stickler says how"
        ));
    }
    lines
}

#[cfg(test)]
mod tests;
