//! Writes the end of the summary: what is to be known of the run, its result in one line, and the path of the page.

use super::{BAD, Detail, GOOD, Surroundings};
use crate::discrepancies::NAME;
use crate::events;
use crate::overview::Overview;
use crate::text::{judged, lacking, outdated, outdated_entries, took, verdicts, visible, wrapped};
use anstyle::Style;
use std::io::{self, Write};
use stickler_run::{EngineHeader, Totals, Verdict};
use stickler_types::{counted, grouped};

/// The maximum number of baseline entries out of date that are named.
const MAX_SHOWN_OUTDATED: usize = 20;

/// Writes the end of the summary. Its last line is the path of the page, or of the log of a run that was cut short.
///
/// # Errors
/// Returns the error of writing to `out`.
pub(super) fn write(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    if around.detail != Detail::Result {
        for sentence in sentences(overview, around) {
            writeln!(out, "{}", wrapped(&sentence, around.width))?;
        }
        write_discrepancies(out, overview, around)?;
        write_outdated(out, overview)?;
    }
    let broken = overview.header.iter().map(|header| header.broken_files.len());
    let broken: u64 = broken.map(|number| number as u64).sum();
    if broken > 0 {
        let mistakes = counted(broken, "mistake", "mistakes");
        writeln!(
            out,
            "{BAD}{mistakes} in case files: some cases were not run.{BAD:#}"
        )?;
    }
    let (style, result) = result(overview, broken > 0);
    writeln!(out, "{style}{}{style:#}", wrapped(&result, around.width))?;
    match (around.reports, &overview.footer) {
        (None, _) => Ok(()),
        (Some(folder), Some(_)) => writeln!(out, "Page: {folder}/index.html"),
        // A run that was cut short leaves its log and nothing else.
        (Some(folder), None) => writeln!(out, "Log: {folder}/{}, as far as the run came", events::NAME),
    }
}

/// Returns the notes on a run, a sentence each.
fn sentences(overview: &Overview, around: Surroundings<'_>) -> Vec<String> {
    let sum = overview.sum();
    let mut sentences = Vec::new();
    if overview.observations > 0 {
        let observations = counted(overview.observations, "observation", "observations");
        sentences.push(format!(
            "{observations} where no source in Stickler says what must be."
        ));
    }
    sentences.extend(disagreements(overview));
    if sum.of(Verdict::Differs) > 0 {
        let cases = counted(sum.of(Verdict::Differs), "case differs", "cases differ");
        sentences.push(format!("{cases} from a source that does not bind the engine."));
    }
    if let Some(header) = &overview.header {
        let engines: Vec<String> = header.engines.iter().map(engine).collect();
        let label = if engines.len() == 1 { "Engine" } else { "Engines" };
        sentences.push(format!("{label}: {}.", engines.join(", ")));
    }
    if around.from_cache > 0 {
        sentences.push(format!(
            "{} of {} results come from the cache; see --no-cache.",
            grouped(around.from_cache),
            grouped(sum.all())
        ));
    }
    sentences
}

/// Returns the number of observations in which the engines disagree; nothing where there is none.
fn disagreements(overview: &Overview) -> Option<String> {
    let disagreements = overview.observed.disagreements(&overview.engines());
    let cases: u64 = disagreements.iter().map(|disagreement| disagreement.cases).sum();
    let differing = counted(cases, "observation differs", "observations differ");
    (cases > 0).then(|| format!("{differing} between the engines: see summary.md."))
}

/// Returns the result of a run in one line, and its style.
fn result(overview: &Overview, is_broken: bool) -> (Style, String) {
    let sum = overview.sum();
    let cases = counted(sum.all(), "case", "cases");
    let Some(footer) = &overview.footer else {
        return (BAD, format!("Cut short after {cases}."));
    };
    let time = took(footer);
    if sum.all() > 0 && sum.of(Verdict::Unsupported) + sum.of(Verdict::Waiting) == sum.all() {
        let waiting = match sum.of(Verdict::Waiting) {
            0 => "",
            _ => " or wait for a feature",
        };
        let nothing = format!("{cases} in {time}: nothing was tested, since all are unsupported{waiting}.");
        return (BAD, nothing);
    }
    let kinds = kinds(&sum, overview.failed == 0);
    let failed = overview.failed;
    let lacking = lacking(overview).map_or(String::new(), |lacking| format!("{lacking}, and "));
    if failed > 0 {
        let failed = grouped(failed);
        return (
            BAD,
            format!("{lacking}{failed} of {cases} not as expected{kinds}, in {time}."),
        );
    }
    if !lacking.is_empty() {
        return (BAD, format!("{lacking}{cases} as expected{kinds}, in {time}."));
    }
    let (style, but) = match overview.outdated().count() {
        0 if is_broken => (BAD, String::new()),
        0 => (GOOD, String::new()),
        number => (BAD, format!(", but {}", outdated_entries(number))),
    };
    (style, format!("{cases} in {time}: all as expected{kinds}{but}."))
}

/// Writes the path of the pages that can be sent to the authors of a compiler, where there are any.
fn write_discrepancies(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let failed: u64 = overview.claims.iter().map(|claim| claim.standing.failed).sum();
    let (Some(folder), Some(_), 1..) = (around.reports, &overview.footer, failed) else {
        return Ok(());
    };
    let cases = counted(failed, "case is", "cases are");
    let sentence = format!("{cases} otherwise than documents say, with a page for each cause:");
    writeln!(out, "{}\n{folder}/{NAME}", wrapped(&sentence, around.width))
}

/// Names the entries of baselines that are out of date.
fn write_outdated(out: &mut dyn Write, overview: &Overview) -> io::Result<()> {
    let number = overview.outdated().count();
    for entry in overview.outdated().take(MAX_SHOWN_OUTDATED) {
        writeln!(out, "{BAD}OUTDATED{BAD:#} {}", outdated(entry))?;
    }
    if number > MAX_SHOWN_OUTDATED {
        writeln!(out, "{BAD}... and {} more.{BAD:#}", number - MAX_SHOWN_OUTDATED)?;
    }
    Ok(())
}

/// Formats an engine's name and version, and how it was judged where that was not by code and line.
fn engine(header: &EngineHeader) -> String {
    let named = format!("{} {}", header.name, header.version);
    format!("{}{}", visible(named.trim_end()), judged(header.strict))
}

/// Formats the counts of those verdicts beside `pass` that are as expected, or of those that are not.
fn kinds(totals: &Totals, as_expected: bool) -> String {
    let is_meant = |verdict: Verdict| verdict != Verdict::Pass && verdict.is_as_expected() == as_expected;
    match verdicts(totals, is_meant) {
        kinds if kinds.is_empty() => kinds,
        kinds => format!(" ({kinds})"),
    }
}
