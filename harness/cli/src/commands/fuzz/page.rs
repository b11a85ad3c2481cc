//! The page of a campaign: its request, its findings and its summary.

use super::bar::rate;
use super::keeper::Unsaved;
use super::known::KnownCauses;
use crate::output::{BAD, BOLD, DIM, GOOD};
use anstyle::Style;
use indicatif::HumanCount;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use stickler_campaign::finding::Confirmation;
use stickler_campaign::{CampaignEnd, CampaignRequest, CampaignSummary, Finding, Survey};
use stickler_types::counted;
use stickler_workers::Shard;

/// The maximum number of findings that are shown with their programs; the folder has all.
const MAX_FINDINGS: usize = 10;
/// The maximum number of features that are shown of a finding's rule; a program that could not be reduced has very many.
const MAX_FEATURES: usize = 12;
/// The maximum number of lines of a message or program that are shown.
const MAX_LINES: usize = 25;

/// Writes the request: inputs, engines and dialects.
///
/// # Errors
/// Errors of writing to the stream.
pub fn begin(out: &mut dyn Write, request: &CampaignRequest, shard: Shard) -> io::Result<()> {
    write!(out, "seed {}", request.seed)?;
    if shard != Shard::WHOLE {
        write!(out, ", part {shard}")?;
    }
    if request.engines.is_empty() {
        writeln!(out, ", reference: {}", request.targets.join(", "))?;
        return out.flush();
    }
    let (engines, dialects) = (request.engines.join(", "), request.dialects.join(", "));
    write!(out, ", {engines}: programs in {dialects}")?;
    if request.open {
        write!(out, ", with what documents leave open")?;
    }
    if let Some(bytes) = request.max_input {
        write!(out, " of at most {bytes} random bytes")?;
    }
    if !request.without.is_empty() {
        write!(out, ", without {}", request.without.join(", "))?;
    }
    writeln!(out)?;
    out.flush()
}

/// Writes in one line what the survey before a campaign found; nothing where there was none.
///
/// # Errors
/// Errors of writing to the stream.
pub fn surveyed(out: &mut dyn Write, survey: &Survey) -> io::Result<()> {
    let (asked, seconds) = (survey.asked, survey.elapsed.as_secs_f64());
    if asked == 0 {
        return Ok(());
    }
    let mut symptoms: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for part in &survey.failing {
        let symptom = part.symptom.split(':').next().unwrap_or_default();
        symptoms.entry(symptom).or_default().insert(&part.word);
    }
    let failing = symptoms.values().flatten().collect::<BTreeSet<_>>().len();
    let counts = symptoms
        .iter()
        .map(|(symptom, words)| format!("{} {symptom}", words.len()));
    let of = match failing {
        0 => String::new(),
        _ => format!(" ({})", counts.collect::<Vec<_>>().join(", ")),
    };
    let found = format!("{failing} failed{of} and are left out");
    writeln!(
        out,
        "asked for {asked} parts of the language alone in {seconds:.1} s: {found}"
    )?;
    out.flush()
}

/// Writes the findings and the summary: what is new, what probably repeats it, and what a run of the suite found too.
///
/// # Errors
/// Errors of writing to the stream.
pub fn end(
    out: &mut dyn Write,
    summary: &CampaignSummary,
    known: &KnownCauses,
    unsaved: &Unsaved,
) -> io::Result<()> {
    write_totals(out, summary)?;
    let Sorted { new, alike, shown } = Sorted::of(summary, known);
    for finding in new.iter().take(MAX_FINDINGS) {
        write_finding(out, finding, summary.times.get(&finding.id).copied().unwrap_or(0))?;
    }
    let alike_lines = alike.iter().map(|finding| (*finding, rule(finding)));
    write_list(
        out,
        "probably the same, with more of the language around it:",
        alike_lines,
    )?;
    if let Some(folder) = known.folder() {
        let titles = shown
            .iter()
            .map(|(finding, title)| (*finding, without_controls(title)));
        write_list(
            out,
            &format!("shown by the run of the suite in {folder} too:"),
            titles,
        )?;
    }
    let (new, alike, shown) = (new.len(), alike.len(), shown.len());
    let hidden = |number: usize| number.saturating_sub(MAX_FINDINGS);
    let more = hidden(new) + hidden(alike) + hidden(shown);
    if more > 0 {
        writeln!(out, "\n{more} more in {}", unsaved.folder)?;
    }
    let rejects = |finding: &Finding| finding.engine.is_some() && finding.symptom.starts_with("rejected");
    if summary.findings.values().any(rejects) {
        let hint = "what an engine rejects hides what else is wrong with it: --without WORD leaves it out";
        writeln!(out, "\n{DIM}{hint}{DIM:#}")?;
    }
    write_unsaved(out, unsaved)?;
    match &summary.ended {
        CampaignEnd::Done => {}
        CampaignEnd::Interrupted => writeln!(out, "\nstopped before its end")?,
        CampaignEnd::Lost(reason) => writeln!(out, "\n{BAD}stopped:{BAD:#} {reason}")?,
    }
    if !unsaved.findings.is_empty() {
        let number = unsaved.findings.len();
        writeln!(
            out,
            "\n{number} of the findings could not be saved; they stand above"
        )?;
    }
    let causes = match known.folder() {
        Some(_) => format!(": {new} new, {alike} like these, {shown} known"),
        None if alike == 0 => String::new(),
        None => format!(": {new} new, {alike} like these"),
    };
    if summary.is_empty() {
        return writeln!(out, "\n{BAD}no program was judged:{BAD:#} {}", reason(summary));
    }
    if summary.findings.is_empty() {
        return writeln!(out, "\n{GOOD}nothing found{GOOD:#}");
    }
    let findings = counted(summary.findings.len() as u64, "finding", "findings");
    writeln!(out, "\n{BAD}{findings}{BAD:#} in {}{causes}", unsaved.folder)
}

/// Writes the first findings of a list, each with what is said of it, under a heading; nothing where there are none.
fn write_list<'f>(
    out: &mut dyn Write,
    heading: &str,
    findings: impl Iterator<Item = (&'f Finding, String)>,
) -> io::Result<()> {
    for (number, (finding, words)) in findings.take(MAX_FINDINGS).enumerate() {
        if number == 0 {
            writeln!(out, "\n{heading}")?;
        }
        writeln!(out, "  {}  {DIM}{words}{DIM:#}", finding.id)?;
    }
    Ok(())
}

fn write_totals(out: &mut dyn Write, summary: &CampaignSummary) -> io::Result<()> {
    let seconds = summary.elapsed.as_secs_f64();
    let rate = HumanCount(rate(summary.programs, summary.elapsed));
    writeln!(
        out,
        "{} programs in {seconds:.1} s ({rate}/s)",
        HumanCount(summary.programs)
    )?;
    for (word, number) in &summary.passed_over {
        writeln!(out, "{DIM}{:>10} passed over: {word}{DIM:#}", HumanCount(*number))?;
    }
    for ((subject, symptom), number) in &summary.disagreements {
        writeln!(out, "{:>10} {subject}: {symptom}", HumanCount(*number))?;
    }
    let is_unfinished = |finding: &&Finding| !finding.origin.smallest;
    let unfinished = summary.findings.values().filter(is_unfinished).count() as u64;
    let notes = [
        (
            summary.left,
            DIM,
            "of them were not made small, for findings explain them, or many like them were",
        ),
        (
            unfinished,
            Style::new(),
            "findings are not as small as they could be: the time was up, or their tries; a longer --time helps",
        ),
        (
            summary.deaths,
            Style::new(),
            "times an engine died or hung, and was started again",
        ),
    ];
    for (number, style, note) in notes.into_iter().filter(|(number, ..)| *number > 0) {
        writeln!(out, "{style}{:>10} {note}{style:#}", HumanCount(number))?;
    }
    Ok(())
}

fn write_finding(out: &mut dyn Write, finding: &Finding, times: u64) -> io::Result<()> {
    writeln!(out, "\n{BOLD}{}{BOLD:#}", finding.id)?;
    let (origin, unit) = (&finding.origin, finding.unit());
    let dialect = finding.dialect.iter().map(|name| format!("{name}, "));
    let doubt = match finding.standing {
        Confirmation::Flaky => ", flaky: not seen again",
        Confirmation::Confirmed if origin.smallest => "",
        Confirmation::Confirmed => ", not as small as it could be",
    };
    let size = format!("{} {unit} of {}", origin.size, origin.size_found);
    writeln!(
        out,
        "  {}{size}, found {times}x{doubt}",
        dialect.collect::<String>()
    )?;
    if let Some(cause) = &finding.cause {
        writeln!(out, "  {}", without_controls(&cause.title))?;
    }
    if !finding.rule.is_empty() {
        writeln!(out, "  {DIM}{}{DIM:#}", rule(finding))?;
    }
    for line in finding.message.lines().take(MAX_LINES) {
        writeln!(out, "  {line}")?;
    }
    write_program(out, finding, MAX_LINES)?;
    if let Some(command) = finding.reproduce.first() {
        writeln!(out, "  {DIM}{command}{DIM:#}")?;
    }
    Ok(())
}

/// Writes the program of a finding; nothing where it has more lines than `most`.
fn write_program(out: &mut dyn Write, finding: &Finding, most: usize) -> io::Result<()> {
    let program = finding.program.as_deref().unwrap_or_default();
    if program.lines().count() > most {
        return Ok(());
    }
    for (number, line) in (1..).zip(program.lines()) {
        let gap = if line.is_empty() { "" } else { "  " };
        writeln!(out, "  {DIM}{number:>4}{DIM:#}{gap}{}", without_controls(line))?;
    }
    Ok(())
}

/// Writes the findings that could not be saved in full, so that none is lost.
fn write_unsaved(out: &mut dyn Write, unsaved: &Unsaved) -> io::Result<()> {
    let Some(error) = &unsaved.error else {
        return Ok(());
    };
    writeln!(out, "\n{BAD}not saved:{BAD:#} {error}")?;
    for finding in &unsaved.findings {
        writeln!(out, "\n{BOLD}{}{BOLD:#}: {}", finding.id, finding.message)?;
        write_program(out, finding, usize::MAX)?;
        let input: String = finding.input.iter().map(|byte| format!("{byte:02x}")).collect();
        if !input.is_empty() {
            writeln!(out, "  input: {input}")?;
        }
        // The folder does not have the finding, so only the seed reproduces it.
        if let Some(command) = finding.reproduce.last() {
            writeln!(out, "  {command}")?;
        }
    }
    Ok(())
}

/// The findings of a campaign by what is known of them; in each list confirmed findings come before flaky ones, and small
/// before large.
#[derive(Default)]
struct Sorted<'s> {
    /// Each shows a cause of its own.
    new: Vec<&'s Finding>,
    /// Each probably has the cause of a simpler one.
    alike: Vec<&'s Finding>,
    /// A run of the suite found the cause, whose title stands beside each.
    shown: Vec<(&'s Finding, &'s str)>,
}

impl<'s> Sorted<'s> {
    fn of(summary: &'s CampaignSummary, known: &'s KnownCauses) -> Sorted<'s> {
        let mut findings: Vec<&Finding> = summary.findings.values().collect();
        findings.sort_by_key(|finding| (finding.standing, finding.origin.size, finding.id.as_str()));
        let mut sorted = Sorted::default();
        for finding in findings {
            let mut others = summary.findings.values();
            match known.of(finding) {
                Some(title) => sorted.shown.push((finding, title)),
                None if others.any(|simpler| finding.is_like(simpler)) => sorted.alike.push(finding),
                None => sorted.new.push(finding),
            }
        }
        sorted
    }
}

/// Returns why a campaign judged no program.
fn reason(summary: &CampaignSummary) -> &'static str {
    let most = summary.passed_over.iter().max_by_key(|(_, number)| **number);
    most.map_or(
        "its time was up before the first one; a longer --time helps",
        |(word, _)| word,
    )
}

/// Returns the rule of a finding in a line: the features that its program uses.
fn rule(finding: &Finding) -> String {
    let (shown, more) = finding.rule.split_at(finding.rule.len().min(MAX_FEATURES));
    match more.len() {
        0 => shown.join(", "),
        number => format!("{} and {number} more", shown.join(", ")),
    }
}

/// Replaces the control characters of a line, which could steer a terminal.
fn without_controls(line: &str) -> String {
    line.replace(char::is_control, "\u{fffd}")
}
