//! `results.json`: the numbers of a run and the cases that did not pass, for programs. reports/README.md names its keys.
//!
//! The cases that passed, and what was observed, are in the event log alone.

#[cfg(test)]
use crate::claims::Claim;
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::text::kept;
use crate::{ReportError, overview};
use serde::Serialize;
use std::borrow::Cow;
use std::io::{self, Write};
use std::path::PathBuf;
#[cfg(test)]
use stickler_run::{BaselineHeader, Cause, DefinedHeader, Source};
use stickler_run::{CaseEvent, EngineHeader, Event, Footer, Grade, Header, Totals, Verdict};

/// The name of the document in a folder of reports.
pub(crate) const NAME: &str = "results.json";

/// The version of the format of `results.json`.
pub(crate) const FORMAT: u32 = 3;

/// The results of a run. The cases are written while the run goes on, and what is known last comes after them.
pub(crate) struct Results {
    file: PendingFile,
    engines: Vec<EngineHeader>,
    /// The number of cases that were written.
    cases: u64,
}

impl Results {
    /// Creates the file.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be created.
    pub(crate) fn create(path: PathBuf) -> Result<Results, ReportError> {
        Ok(Results {
            file: PendingFile::create(path)?,
            engines: Vec::new(),
            cases: 0,
        })
    }

    /// Adds one event.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn take(&mut self, event: &Event) -> Result<(), ReportError> {
        let written = match event {
            Event::Header(header) => {
                self.engines.clone_from(&header.engines);
                self.write_start(header)
            }
            Event::Case(case) if case.verdict != Verdict::Pass => {
                self.cases += 1;
                let case = CaseResult::of(case, overview::named(&self.engines, &case.engine));
                element(&mut self.file, self.cases == 1, &case)
            }
            // Causes and the footer are taken from the overview, when the document ends.
            Event::Case(_) | Event::Cause(_) | Event::Footer(_) => Ok(()),
        };
        written.map_err(ReportError::writing(self.file.path()))
    }

    /// Ends the document. A run without header or footer has no results.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn finish(mut self, overview: &Overview) -> Result<(), ReportError> {
        let (Some(header), Some(footer)) = (&overview.header, &overview.footer) else {
            return Ok(());
        };
        let path = self.file.path().to_owned();
        self.write_end(header, footer, overview)
            .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }

    /// Writes what is known before the first case.
    fn write_start(&mut self, header: &Header) -> io::Result<()> {
        let out = &mut self.file;
        write!(out, "{{\"format\":{FORMAT}")?;
        key(out, "stickler", &header.stickler)?;
        key(out, "suite", &header.suite)?;
        key(out, "started", &header.started)?;
        key(out, "filters", &header.filters)?;
        key(out, "dialects", &header.dialects)?;
        key(out, "shard", &header.shard)?;
        key(out, "broken_files", &header.broken_files)?;
        key(out, "baselines", &header.baselines)?;
        key(out, "defined", &header.defined)?;
        key(out, "sources", &header.sources)?;
        write!(out, ",\n\"cases\":[")
    }

    /// Writes what is known after the last case.
    fn write_end(&mut self, header: &Header, footer: &Footer, overview: &Overview) -> io::Result<()> {
        let out = &mut self.file;
        write!(out, "\n]")?;
        key(out, "duration_ms", &footer.duration_ms)?;
        key(out, "causes_ms", &footer.causes_ms)?;
        key(out, "engines", &engines(header, footer))?;
        list(out, "claims", overview.claims.iter())?;
        list(out, "causes", overview.lacks.iter().chain(&overview.causes))?;
        out.write_all(b"}\n")
    }
}

/// Writes one key of the document's top level, which follows at least one other.
fn key(out: &mut impl Write, name: &str, value: &impl Serialize) -> io::Result<()> {
    write!(out, ",\n\"{name}\":")?;
    Ok(serde_json::to_writer(out, value)?)
}

/// Writes a key whose value is an array, with one element per line.
fn list<T: Serialize>(
    out: &mut impl Write,
    name: &str,
    elements: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    write!(out, ",\n\"{name}\":[")?;
    for (at, value) in elements.into_iter().enumerate() {
        element(out, at == 0, &value)?;
    }
    out.write_all(b"\n]")
}

/// Writes an element of an array on a line of its own.
fn element(out: &mut impl Write, is_first: bool, value: &impl Serialize) -> io::Result<()> {
    out.write_all(if is_first { b"\n" } else { b",\n" })?;
    Ok(serde_json::to_writer(out, value)?)
}

/// Returns each engine of the header with its totals from the footer.
fn engines<'a>(header: &'a Header, footer: &'a Footer) -> Vec<EngineResult<'a>> {
    let totals = |name: &str| footer.engines.iter().find(|engine| engine.name == name);
    header
        .engines
        .iter()
        .map(|engine| EngineResult {
            name: &engine.name,
            version: &engine.version,
            dialects: &engine.dialects,
            strict: engine.strict,
            rerun: &engine.rerun,
            totals: totals(&engine.name).map(|found| found.totals).unwrap_or_default(),
        })
        .collect()
}

/// The results of a run of Stickler, a conformance suite of IEC 61131-3 compilers. Readers ignore keys that they do not know.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[expect(
    dead_code,
    reason = "the document is written piece by piece; only its schema is made of this type"
)]
pub(crate) struct ResultsDocument<'d> {
    /// The version of this format.
    #[schemars(extend("const" = FORMAT))]
    format: u32,
    /// The version of Stickler.
    stickler: String,
    /// The version of the suite.
    suite: String,
    /// The time at which the run began.
    #[schemars(extend("format" = "date-time"))]
    started: String,
    /// The duration of the run, in milliseconds.
    duration_ms: u64,
    /// The duration of the search for causes, in milliseconds; `null` where there was none.
    causes_ms: Option<u64>,
    /// The engines that took part.
    #[schemars(length(min = 1))]
    engines: Vec<EngineResult<'d>>,
    /// The filters by which cases were selected, as they were typed, and those that left cases out, behind `not`; empty where all cases
    /// were selected.
    filters: Vec<String>,
    /// The dialects whose cases were selected; empty where all were.
    dialects: Vec<String>,
    /// The part of a divided run, such as `2/4`.
    shard: Option<String>,
    /// The case files that could not be read: file, line, key and what is wrong.
    broken_files: Vec<String>,
    /// The baselines that took part.
    baselines: Vec<BaselineHeader>,
    /// The dialects of the run that stickler.toml defines.
    defined: Vec<DefinedHeader>,
    /// The sources that the cases of the suite may cite.
    sources: Vec<Source>,
    /// The claims, each with the numbers of its cases.
    claims: Vec<Claim<'d>>,
    /// The causes of failing cases, those that explain most cases first.
    causes: Vec<Cause>,
    /// The cases that did not pass.
    cases: Vec<CaseResult<'d>>,
}

/// An engine that took part, with its totals.
#[derive(serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct EngineResult<'d> {
    /// The name of the engine.
    #[cfg_attr(test, schemars(length(min = 1)))]
    name: &'d str,
    /// The version of the engine.
    version: &'d str,
    /// The dialects that the engine supports.
    dialects: &'d [String],
    /// The worst grade of a rejection or a fault that passed.
    strict: Grade,
    /// The template of the command that runs a case again.
    rerun: &'d str,
    /// The number of times that each verdict came.
    totals: Totals,
}

/// A case that did not pass.
#[derive(serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct CaseResult<'d> {
    /// The case, with at most 32000 characters of its program.
    #[serde(flatten)]
    case: Cow<'d, CaseEvent>,
    /// The command that runs the case alone.
    rerun: String,
}

impl<'d> CaseResult<'d> {
    /// Returns the element for a case.
    fn of(case: &'d CaseEvent, engine: Option<&EngineHeader>) -> CaseResult<'d> {
        CaseResult {
            rerun: overview::rerun(engine, case),
            case: match case.program.as_deref().map(kept) {
                Some(Cow::Owned(program)) => Cow::Owned(CaseEvent {
                    program: Some(program),
                    ..case.clone()
                }),
                _ => Cow::Borrowed(case),
            },
        }
    }
}
