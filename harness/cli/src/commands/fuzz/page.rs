//! The page of a campaign: its request, its findings and its summary.

use super::bar::rate;
use super::keeper::Unsaved;
use super::known::KnownCauses;
use crate::output::{BAD, BOLD, DIM, GOOD};
use indicatif::HumanCount;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use stickler_campaign::finding::Confirmation;
use stickler_campaign::{CampaignEnd, CampaignRequest, CampaignSummary, Finding, Survey};
use stickler_workers::Shard;

/// The maximum number of findings that are shown with their programs; the folder has all.
const MAX_FINDINGS: usize = 10;
/// The maximum number of features that are shown of a finding's rule; a program that could not be reduced has very many.
const MAX_FEATURES: usize = 12;
/// The maximum number of lines of a message or program that are shown.
const MAX_LINES: usize = 25;

/// The page that is being written.
pub struct FuzzPage<'o> {
    out: &'o mut dyn Write,
}

impl<'o> FuzzPage<'o> {
    /// Makes the page on a stream.
    pub fn new(out: &'o mut dyn Write) -> FuzzPage<'o> {
        FuzzPage { out }
    }

    /// Writes the request: inputs, engines and dialects.
    ///
    /// # Errors
    /// Errors of writing to the stream.
    pub fn begin(&mut self, request: &CampaignRequest, shard: Shard) -> io::Result<()> {
        write!(self.out, "seed {}", request.seed)?;
        if shard != Shard::WHOLE {
            write!(self.out, ", part {shard}")?;
        }
        if request.engines.is_empty() {
            writeln!(self.out, ", reference: {}", request.targets.join(", "))?;
        } else {
            let open = if request.open {
                ", with what documents leave open"
            } else {
                ""
            };
            let (engines, dialects) = (request.engines.join(", "), request.dialects.join(", "));
            write!(self.out, ", {engines}: programs in {dialects}{open}")?;
            if let Some(bytes) = request.max_input {
                write!(self.out, " of at most {bytes} random bytes")?;
            }
            match &request.without[..] {
                [] => writeln!(self.out)?,
                words => writeln!(self.out, ", without {}", words.join(", "))?,
            }
        }
        self.out.flush()
    }

    /// Writes in one line what the survey before a campaign found; nothing where there was none.
    ///
    /// # Errors
    /// Errors of writing to the stream.
    pub fn surveyed(&mut self, survey: &Survey) -> io::Result<()> {
        if survey.asked == 0 {
            return Ok(());
        }
        let mut symptoms: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for part in &survey.failing {
            let symptom = part.symptom.split(':').next().unwrap_or_default();
            symptoms.entry(symptom).or_default().insert(&part.word);
        }
        let failing: BTreeSet<&str> = survey.failing.iter().map(|part| part.word.as_str()).collect();
        let counts = symptoms
            .iter()
            .map(|(symptom, words)| format!("{} {symptom}", words.len()));
        let of = match failing.is_empty() {
            true => String::new(),
            false => format!(" ({})", counts.collect::<Vec<_>>().join(", ")),
        };
        writeln!(
            self.out,
            "asked for {} parts of the language alone in {:.1} s: {} failed{of} and are left out",
            survey.asked,
            survey.elapsed.as_secs_f64(),
            failing.len()
        )?;
        self.out.flush()
    }

    /// Writes the findings and the summary: what is new, what probably repeats it, and what a run of the suite found too.
    ///
    /// # Errors
    /// Errors of writing to the stream.
    pub fn end(
        &mut self,
        summary: &CampaignSummary,
        known: &KnownCauses,
        unsaved: &Unsaved,
    ) -> io::Result<()> {
        self.totals(summary)?;
        let Sorted { new, alike, shown } = Sorted::of(summary, known);
        for finding in new.iter().take(MAX_FINDINGS) {
            self.finding(finding, summary.times.get(&finding.id).copied().unwrap_or(0))?;
        }
        if !alike.is_empty() {
            writeln!(
                self.out,
                "\nprobably the same, with more of the language around it:"
            )?;
        }
        for finding in alike.iter().take(MAX_FINDINGS) {
            writeln!(self.out, "  {}  {DIM}{}{DIM:#}", finding.id, rule(finding))?;
        }
        if let (Some(folder), false) = (known.folder(), shown.is_empty()) {
            writeln!(self.out, "\nshown by the run of the suite in {folder} too:")?;
        }
        for (finding, title) in shown.iter().take(MAX_FINDINGS) {
            writeln!(
                self.out,
                "  {}  {DIM}{}{DIM:#}",
                finding.id,
                without_controls(title)
            )?;
        }
        let hidden = |number: usize| number.saturating_sub(MAX_FINDINGS);
        let more = hidden(new.len()) + hidden(alike.len()) + hidden(shown.len());
        if more > 0 {
            writeln!(self.out, "\n{more} more in {}", unsaved.folder)?;
        }
        let rejects = |finding: &Finding| finding.engine.is_some() && finding.symptom.starts_with("rejected");
        if summary.findings.values().any(rejects) {
            let hint =
                "what an engine rejects hides what else is wrong with it: --without WORD leaves it out";
            writeln!(self.out, "\n{DIM}{hint}{DIM:#}")?;
        }
        self.unsaved(unsaved)?;
        match &summary.ended {
            CampaignEnd::Done => {}
            CampaignEnd::Interrupted => writeln!(self.out, "\nstopped before its end")?,
            CampaignEnd::Lost(reason) => writeln!(self.out, "\n{BAD}stopped:{BAD:#} {reason}")?,
        }
        if !unsaved.findings.is_empty() {
            let number = unsaved.findings.len();
            writeln!(
                self.out,
                "\n{number} of the findings could not be saved; they stand above"
            )?;
        }
        let causes = match known.folder() {
            Some(_) => format!(
                ": {} new, {} like these, {} known",
                new.len(),
                alike.len(),
                shown.len()
            ),
            None if alike.is_empty() => String::new(),
            None => format!(": {} new, {} like these", new.len(), alike.len()),
        };
        match summary.findings.len() {
            _ if summary.is_empty() => writeln!(
                self.out,
                "\n{BAD}no program was judged:{BAD:#} {}",
                reason(summary)
            ),
            0 => writeln!(self.out, "\n{GOOD}nothing found{GOOD:#}"),
            1 => writeln!(self.out, "\n{BAD}1 finding{BAD:#} in {}{causes}", unsaved.folder),
            number => writeln!(
                self.out,
                "\n{BAD}{number} findings{BAD:#} in {}{causes}",
                unsaved.folder
            ),
        }
    }

    fn totals(&mut self, summary: &CampaignSummary) -> io::Result<()> {
        writeln!(
            self.out,
            "{} programs in {:.1} s ({}/s)",
            HumanCount(summary.programs),
            summary.elapsed.as_secs_f64(),
            HumanCount(rate(summary.programs, summary.elapsed))
        )?;
        for (word, number) in &summary.passed_over {
            writeln!(
                self.out,
                "{DIM}{:>10} passed over: {word}{DIM:#}",
                HumanCount(*number)
            )?;
        }
        for ((subject, symptom), number) in &summary.disagreements {
            writeln!(self.out, "{:>10} {subject}: {symptom}", HumanCount(*number))?;
        }
        if summary.left > 0 {
            writeln!(
                self.out,
                "{DIM}{:>10} of them were not made small, for findings explain them, or many like them were{DIM:#}",
                HumanCount(summary.left)
            )?;
        }
        let unfinished = summary
            .findings
            .values()
            .filter(|finding| !finding.origin.smallest)
            .count();
        if unfinished > 0 {
            writeln!(
                self.out,
                "{:>10} findings are not as small as they could be: the time was up, or their tries; a longer --time helps",
                unfinished
            )?;
        }
        if summary.deaths > 0 {
            let deaths = HumanCount(summary.deaths);
            writeln!(
                self.out,
                "{deaths:>10} times an engine died or hung, and was started again"
            )?;
        }
        Ok(())
    }

    fn finding(&mut self, finding: &Finding, times: u64) -> io::Result<()> {
        writeln!(self.out, "\n{BOLD}{}{BOLD:#}", finding.id)?;
        let flaky = match finding.standing {
            Confirmation::Confirmed => "",
            Confirmation::Flaky => ", flaky: not seen again",
        };
        let dialect = finding
            .dialect
            .as_deref()
            .map(|name| format!("{name}, "))
            .unwrap_or_default();
        let unfinished = if finding.origin.smallest || finding.standing == Confirmation::Flaky {
            ""
        } else {
            ", not as small as it could be"
        };
        writeln!(
            self.out,
            "  {dialect}{} {} of {}, found {times}x{flaky}{unfinished}",
            finding.origin.size,
            finding.unit(),
            finding.origin.size_found
        )?;
        if let Some(cause) = &finding.cause {
            writeln!(self.out, "  {}", without_controls(&cause.title))?;
        }
        if !finding.rule.is_empty() {
            writeln!(self.out, "  {DIM}{}{DIM:#}", rule(finding))?;
        }
        for line in finding.message.lines().take(MAX_LINES) {
            writeln!(self.out, "  {line}")?;
        }
        self.program(finding, MAX_LINES)?;
        if let Some(command) = finding.reproduce.first() {
            writeln!(self.out, "  {DIM}{command}{DIM:#}")?;
        }
        Ok(())
    }

    fn program(&mut self, finding: &Finding, most: usize) -> io::Result<()> {
        let Some(program) = &finding.program else {
            return Ok(());
        };
        if program.lines().count() > most {
            return Ok(());
        }
        for (number, line) in program.lines().enumerate() {
            let gap = if line.is_empty() { "" } else { "  " };
            writeln!(
                self.out,
                "  {DIM}{:>4}{DIM:#}{gap}{}",
                number + 1,
                without_controls(line)
            )?;
        }
        Ok(())
    }

    /// Writes the findings that could not be saved in full, so that none is lost.
    fn unsaved(&mut self, unsaved: &Unsaved) -> io::Result<()> {
        let Some(error) = &unsaved.error else {
            return Ok(());
        };
        writeln!(self.out, "\n{BAD}not saved:{BAD:#} {error}")?;
        for finding in &unsaved.findings {
            writeln!(self.out, "\n{BOLD}{}{BOLD:#}: {}", finding.id, finding.message)?;
            self.program(finding, usize::MAX)?;
            let input: String = finding.input.iter().map(|byte| format!("{byte:02x}")).collect();
            if !input.is_empty() {
                writeln!(self.out, "  input: {input}")?;
            }
            // The folder does not have the finding, so only the seed reproduces it.
            if let Some(command) = finding.reproduce.last() {
                writeln!(self.out, "  {command}")?;
            }
        }
        Ok(())
    }
}

/// The findings of a campaign by what is known of them; in each list confirmed findings come before flaky ones, and small
/// before large.
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
        let mut sorted = Sorted {
            new: Vec::new(),
            alike: Vec::new(),
            shown: Vec::new(),
        };
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
    let shown = |character: char| {
        if character.is_control() {
            '\u{fffd}'
        } else {
            character
        }
    };
    line.chars().map(shown).collect()
}
