//! Judges results that were copied out of an editor, and emits the same events as a run of any engine.
//!
//! A case for which no result was copied is not judged, and a run that lacks a case has no footer: every reader of its reports
//! says that it was cut short.

use crate::answers::{self, ANSWERS, ReportedOutcome, ReportedOutcomes};
use crate::manifest::Manifest;
use crate::messages::{MessageList, Messages};
use crate::paste;
use crate::result_arrays::{PageResult, ResultArrays};
use crate::unjudged::{PagesWithoutResults, UnjudgedCases, shortened};
use crate::{ExportError, ExtraCases, MANIFEST};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;
use stickler_engines::{Diagnostic, Outcome};
use stickler_run::{
    CaseJudge, DefinedHeader, EngineHeader, EngineTotals, Event, FORMAT, Fact, Footer, Header, RunSummary,
    dialect_headers,
};
use stickler_suite::{Acceptance, Case};
use stickler_types::DialectName;

/// An export that was read from its folder.
#[derive(Debug)]
pub struct Export {
    folder: PathBuf,
    manifest: Manifest,
    dialect: DialectName,
    /// The cases of each page.
    cases: Vec<Vec<Case>>,
    answers: ReportedOutcomes,
}

/// A text that a person copied out of an editor.
#[derive(Clone, Debug)]
pub struct CopiedText {
    /// The name of the file.
    pub name: String,
    /// The bytes of the file.
    pub bytes: Vec<u8>,
}

/// The result of an import.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Imported {
    /// The summary of the verdicts; it is marked as cancelled where cases were not judged.
    pub summary: RunSummary,
    /// The number of cases that were not judged.
    pub unjudged: u64,
    /// The notes on the texts, the pages and the answers, a sentence each, in their order.
    pub notes: Vec<String>,
}

impl Export {
    /// Reads the export of a folder, with the person's answers.
    ///
    /// # Errors
    /// [`ExportError`] where the folder holds no export, or its files cannot be understood.
    pub fn read(folder: &Path) -> Result<Export, ExportError> {
        let manifest = Manifest::read(folder)?;
        let broken = |what: String| ExportError::Manifest(folder.join(MANIFEST), what);
        let dialect: Option<DialectName> = manifest.dialect.parse().ok();
        if let Some(then) = &manifest.defined
            && !dialect.is_some_and(|dialect| is_still(then, dialect))
        {
            return Err(ExportError::Defined(folder.to_owned(), Box::new(then.clone())));
        }
        let dialect = dialect.ok_or_else(|| broken(format!("there is no dialect `{}`", manifest.dialect)))?;
        let page =
            |page: &crate::manifest::PageRecord| page.cases.iter().map(|case| case.case(dialect)).collect();
        let cases: Result<Vec<Vec<Case>>, String> = manifest.pages.iter().map(page).collect();
        Ok(Export {
            folder: folder.to_owned(),
            cases: cases.map_err(broken)?,
            answers: answers::read(folder, dialect)?,
            manifest,
            dialect,
        })
    }

    /// Returns the dialect of the cases.
    pub fn dialect(&self) -> DialectName {
        self.dialect
    }

    /// Returns the kinds of the exported cases beside those whose programs must be accepted.
    pub fn with(&self) -> BTreeSet<ExtraCases> {
        let kinds = self
            .cases
            .iter()
            .flatten()
            .filter_map(|case| match case.expectation.accepted {
                Acceptance::Required => None,
                Acceptance::Observed => Some(ExtraCases::Open),
                Acceptance::Rejected => Some(ExtraCases::Rejected),
            });
        kinds.collect()
    }

    /// Judges the copied texts as the results of the engine of `judge`. Emits events to `sink`: a header, the cases that can be
    /// judged, in the order of the pages, and a footer where these are all cases. Calls `answered` with each case that can be judged and
    /// what the compiler did with it.
    pub fn import(
        &self,
        sources: &[CopiedText],
        judge: &CaseJudge<'_>,
        sink: &mut dyn FnMut(Event),
        answered: &mut OutcomeSink<'_>,
    ) -> Imported {
        let mut imported = Imported::default();
        let (arrays, messages) = self.gather(sources, &mut imported.notes);
        let header = self.header(judge);
        imported.summary.outdated = header
            .baselines
            .iter()
            .map(|baseline| baseline.outdated.len() as u64)
            .sum();
        sink(Event::Header(header));
        let mut without = PagesWithoutResults::default();
        for at in 0..self.manifest.pages.len() {
            let given = self.given(at, &arrays, &messages);
            self.page(at, given, judge, (&mut imported, &mut without), (sink, answered));
        }
        without.tell(&mut imported.notes);
        self.strangers(&mut imported.notes);
        let totals = imported.summary.totals;
        imported.summary.cancelled = imported.unjudged > 0;
        if imported.unjudged == 0 {
            sink(Event::Footer(Footer {
                totals,
                engines: vec![EngineTotals {
                    name: judge.engine.name.clone(),
                    totals,
                }],
                duration_ms: 0,
                causes_ms: None,
            }));
        }
        imported
    }

    fn gather(&self, sources: &[CopiedText], notes: &mut Vec<String>) -> (ResultArrays, Messages) {
        let (mut arrays, mut messages) = (ResultArrays::default(), Messages::default());
        for source in sources {
            let text = paste::decoded(&source.bytes);
            let taken = messages.take(&text, &self.manifest);
            if taken > 0 && !text.contains("results[") {
                continue;
            }
            let pasted = paste::read(&text);
            let complaints = pasted.complaints.iter().map(|reported| {
                format!(
                    "{}:{}:{}: {}",
                    source.name, reported.line, reported.column, reported.what
                )
            });
            notes.extend(shortened(complaints.collect()));
            if pasted.arrays.is_empty() {
                notes.push(format!("{}: there is no number in it", source.name));
            }
            for array in &pasted.arrays {
                match arrays.take(array, &self.manifest) {
                    Ok(note) => {
                        notes.extend(note.map(|note| format!("{}:{}: {note}", source.name, array.line)))
                    }
                    Err(why) => notes.push(format!("{}:{}: the array {why}", source.name, array.line)),
                }
            }
        }
        (arrays, messages)
    }

    /// Returns the results of the cases of a page.
    fn given(&self, at: usize, arrays: &ResultArrays, messages: &Messages) -> PageResults {
        let page = &self.manifest.pages[at];
        let mut given = match page.is_compiled() {
            true => self.compiled(at, messages),
            false => self.run(at, arrays, messages),
        };
        // The programs of these cases were not on the page.
        for case in &page.answered {
            given.cases[*case] = PageResult::NotRun;
        }
        given
    }

    /// Returns the results from the array of a page; where there are only messages that reject some of its cases, the state names
    /// these cases.
    fn run(&self, at: usize, arrays: &ResultArrays, messages: &Messages) -> PageResults {
        let page = &self.manifest.pages[at];
        let numbered = self.cases[at].iter().enumerate();
        let cases = numbered
            .map(|(number, case)| arrays.result(at, page, number, case))
            .collect();
        let without = arrays.is_without(at);
        let by_case = messages
            .by_case(at, &page.lines)
            .filter(|_| without)
            .unwrap_or_default();
        let culprits = by_case
            .iter()
            .zip(&page.cases)
            .filter(|(message, _)| message.is_some());
        let lines: Vec<String> = culprits
            .map(|(_, case)| format!("\n  rejected {}", case.id))
            .collect();
        let hint = format!(
            "it was not accepted; write this into {ANSWERS} and export again in the same words:{}",
            lines.concat()
        );
        PageResults {
            cases,
            without: without && lines.is_empty(),
            state: match lines.is_empty() {
                true => arrays.state(at, page),
                false => Some(hint),
            },
        }
    }

    /// Returns the results from the messages about a page that is only compiled.
    fn compiled(&self, at: usize, messages: &Messages) -> PageResults {
        let page = &self.manifest.pages[at];
        let missing = |without, state| PageResults {
            cases: page.cases.iter().map(|_| PageResult::Missing).collect(),
            without,
            state,
        };
        match messages.list(at, &page.lines) {
            MessageList::Missing => missing(true, None),
            MessageList::Complete(cases) => PageResults {
                cases: cases.into_iter().map(compiled_outcome).collect(),
                without: false,
                state: None,
            },
            MessageList::Truncated(last) => {
                let hint = match last.and_then(|last| page.cases.get(last)) {
                    Some(case) => format!(
                        "; the last case with a message is {}: if the compiler reads no further, note `rejected` of that one in \
                         {ANSWERS} and export again",
                        case.id
                    ),
                    None => String::new(),
                };
                let state = "the list of messages is not whole, for its first statement or its last is wrong and has none";
                missing(false, Some(format!("{state}{hint}")))
            }
        }
    }

    fn page(
        &self,
        at: usize,
        given: PageResults,
        judge: &CaseJudge<'_>,
        (imported, without): (&mut Imported, &mut PagesWithoutResults),
        (sink, answered): (&mut dyn FnMut(Event), &mut OutcomeSink<'_>),
    ) {
        let page = &self.manifest.pages[at];
        let mut unjudged = UnjudgedCases::default();
        for (case, reported) in self.cases[at].iter().zip(given.cases) {
            let answer = self.answers.get(&*case.id);
            let (outcome, untold) = match (reported, answer) {
                (PageResult::Outcome(outcome, untold), None) => (outcome, untold),
                (PageResult::Outcome(outcome, untold), Some((_, place))) => {
                    imported
                        .notes
                        .push(format!("{place}: {} has results, which count", case.id));
                    (outcome, untold)
                }
                (_, Some((answer, place))) => (noted(*answer, place), Vec::new()),
                (reported, None) => {
                    unjudged.add(&case.id, reported);
                    continue;
                }
            };
            answered(case, &outcome);
            let answers = stickler_run::Answers::of_run(outcome);
            let mut event = judge.event(case, &answers, Duration::ZERO);
            event
                .got
                .iter_mut()
                .for_each(|fact| correct_missing(fact, &untold));
            imported.summary.totals.count(event.verdict);
            imported.summary.cases += 1;
            sink(Event::Case(event));
        }
        imported.unjudged += unjudged.count();
        if given.without && unjudged.count() > 0 {
            without.add(page.number, unjudged.count());
            return;
        }
        unjudged.tell(page, given.state, &mut imported.notes);
    }

    /// Adds notes about answers for cases that are on no page.
    fn strangers(&self, notes: &mut Vec<String>) {
        let on_a_page = |id: &str| self.cases.iter().flatten().any(|case| *case.id == *id);
        let strangers = self.answers.iter().filter(|(id, _)| !on_a_page(id));
        let reported =
            strangers.map(|(id, (_, place))| format!("{place}: {id} is on no page of this export"));
        notes.extend(shortened(reported.collect()));
    }

    fn header(&self, judge: &CaseJudge<'_>) -> Header {
        let CaseJudge { plan, engine, .. } = *judge;
        Header {
            format: FORMAT,
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            suite: self.manifest.suite.clone(),
            started: plan.started.clone(),
            command: plan.command.clone(),
            engines: vec![EngineHeader {
                name: engine.name.clone(),
                version: engine.version.clone(),
                dialects: vec![self.dialect.to_string()],
                strict: plan.strict(engine),
                rerun: plan.rerun_template(&engine.name),
                commands: std::collections::BTreeMap::new(),
            }],
            cases: self.cases.iter().map(|cases| cases.len() as u64).sum(),
            dialects: vec![self.dialect.to_string()],
            baselines: judge
                .baseline
                .map(|baseline| baseline.header().clone())
                .into_iter()
                .collect(),
            defined: self.manifest.defined.clone().into_iter().collect(),
            sources: judge.suite.sources.iter().cloned().collect(),
            ..Header::default()
        }
    }

    /// Returns the folder of the export.
    pub fn folder(&self) -> &Path {
        &self.folder
    }
}

/// Returns whether a dialect of stickler.toml still has the rules that it had at the time of the export.
fn is_still(then: &DefinedHeader, dialect: DialectName) -> bool {
    let now = dialect_headers(&[dialect], &[]);
    now.iter()
        .any(|now| now.extends == then.extends && now.overrides == then.overrides)
}

/// Takes each case that can be judged, and what the compiler did with it.
type OutcomeSink<'s> = dyn FnMut(&Case, &Outcome) + 's;

/// The results of the cases of a page.
struct PageResults {
    /// The result of each case.
    cases: Vec<PageResult>,
    /// Whether no result of the page was pasted.
    without: bool,
    /// A sentence on how far the page ran, where there is something to say.
    state: Option<String>,
}

/// Returns the outcome of a case that is only compiled, by its first message, whose line number is of the page and not of the case.
fn compiled_outcome(message: Option<String>) -> PageResult {
    PageResult::Outcome(message.map_or(Outcome::ACCEPTED, rejected), Vec::new())
}

fn rejected(message: String) -> Outcome {
    Outcome::rejected(vec![Diagnostic {
        message,
        ..Diagnostic::default()
    }])
}

fn noted(answer: ReportedOutcome, place: &str) -> Outcome {
    match answer {
        ReportedOutcome::Accepted => Outcome::ACCEPTED,
        ReportedOutcome::Rejected => rejected(format!("rejected, as noted at {place}")),
        ReportedOutcome::Crashed => Outcome::crashed(format!("as noted at {place}")),
    }
}

/// Replaces the fact that a value is missing where the page has the value in `untold`: it differs, but no number shows it.
fn correct_missing(fact: &mut Fact, untold: &[String]) {
    if let Fact::MissingValue { name } = fact
        && untold.contains(name)
    {
        *fact = Fact::OtherValue {
            name: std::mem::take(name),
        };
    }
}
