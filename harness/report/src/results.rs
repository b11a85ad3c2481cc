//! `results.json`: the whole run as one JSON document, for programs. Section 5 of the design names its keys.

use crate::ReportError;
use crate::claims::{Claims, Standing};
use crate::overview::Overview;
use crate::pending::PendingFile;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;
use stickler_run::{CaseEvent, Event, Footer, Grade, Header, Totals, Verdict};

/// The version of this format.
const FORMAT: u32 = 1;

/// Gathers the run. Cases and observations are serialised as they come; the document is written when it is whole,
/// with the totals, which are known last, in front.
pub(crate) struct Results {
    file: PendingFile,
    cases: List,
    observations: List,
}

impl Results {
    /// Makes the file.
    ///
    /// # Errors
    /// [`ReportError::Write`] where it cannot be made.
    pub(crate) fn create(path: PathBuf) -> Result<Results, ReportError> {
        Ok(Results {
            file: PendingFile::create(path)?,
            cases: List::default(),
            observations: List::default(),
        })
    }

    /// Adds one event.
    ///
    /// # Errors
    /// [`ReportError::Serialise`] where the event cannot be serialised.
    pub(crate) fn take(&mut self, event: &Event) -> Result<(), ReportError> {
        match event {
            // The header and the footer are taken from the overview, when the document is written.
            Event::Header(_) | Event::Footer(_) => Ok(()),
            Event::Case(case) => self.take_case(case).map_err(|error| ReportError::Serialise {
                path: self.file.path().to_owned(),
                source: error.into(),
            }),
        }
    }

    fn take_case(&mut self, case: &CaseEvent) -> serde_json::Result<()> {
        self.cases.push(&CaseResult::new(case))?;
        for observation in &case.observations {
            self.observations.push(&ObservationResult {
                id: &case.id,
                dialect: &case.dialect,
                engine: &case.engine,
                name: &observation.name,
                value: &observation.value,
            })?;
        }
        Ok(())
    }

    /// Writes the document. A run without header or footer has no results.
    ///
    /// # Errors
    /// [`ReportError::Write`] where that fails.
    pub(crate) fn finish(mut self, overview: &Overview) -> Result<(), ReportError> {
        let (Some(header), Some(footer)) = (&overview.header, &overview.footer) else {
            return Ok(());
        };
        let path = self.file.path().to_owned();
        self.write(header, footer, &overview.claims)
            .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }

    fn write(&mut self, header: &Header, footer: &Footer, claims: &Claims) -> io::Result<()> {
        let out = &mut self.file;
        write!(out, "{{\"format\":{FORMAT}")?;
        key(out, "stickler", &header.stickler)?;
        key(out, "suite", &header.suite)?;
        key(out, "started", &header.started)?;
        key(out, "duration_ms", &footer.duration_ms)?;
        key(out, "engines", &engines(header, footer))?;
        key(out, "shard", &header.shard)?;
        key(out, "broken_files", &header.broken_files)?;
        let mut list = List::default();
        for claim in claims.iter() {
            list.push(&ClaimResult {
                engine: claim.engine,
                source: claim.source,
                section: claim.section,
                standing: claim.standing,
            })?;
        }
        list.write(out, "claims")?;
        self.cases.write(out, "cases")?;
        self.observations.write(out, "observations")?;
        out.write_all(b"}\n")
    }
}

/// Writes one key of the document's top level, after at least one other.
fn key(out: &mut impl Write, name: &str, value: &impl Serialize) -> io::Result<()> {
    write!(out, ",\n\"{name}\":")?;
    Ok(serde_json::to_writer(out, value)?)
}

/// A JSON array that grows, one element a line.
#[derive(Default)]
struct List {
    bytes: Vec<u8>,
}

impl List {
    fn push(&mut self, element: &impl Serialize) -> serde_json::Result<()> {
        if !self.bytes.is_empty() {
            self.bytes.extend_from_slice(b",\n");
        }
        serde_json::to_writer(&mut self.bytes, element)
    }

    fn write(&self, out: &mut impl Write, name: &str) -> io::Result<()> {
        write!(out, ",\n\"{name}\":[\n")?;
        out.write_all(&self.bytes)?;
        out.write_all(b"\n]")
    }
}

/// Each engine of the header with its totals from the footer.
fn engines<'a>(header: &'a Header, footer: &'a Footer) -> Vec<EngineResult<'a>> {
    let totals = |name: &str| footer.engines.iter().find(|engine| engine.name == name);
    header
        .engines
        .iter()
        .map(|engine| EngineResult {
            name: &engine.name,
            version: &engine.version,
            dialects: &engine.dialects,
            totals: totals(&engine.name).map(|found| found.totals).unwrap_or_default(),
        })
        .collect()
}

#[derive(Serialize)]
struct EngineResult<'a> {
    name: &'a str,
    version: &'a str,
    dialects: &'a [String],
    totals: Totals,
}

#[derive(Serialize)]
struct ClaimResult<'a> {
    engine: &'a str,
    source: &'a str,
    section: &'a str,
    standing: Standing,
}

#[derive(Serialize)]
struct CaseResult<'a> {
    id: &'a str,
    dialect: &'a str,
    engine: &'a str,
    verdict: Verdict,
    grade: Option<Grade>,
    title: &'a str,
    basis: &'a str,
    area: &'a str,
    file: &'a str,
    line: u32,
    expected: &'a str,
    got: &'a str,
    duration_us: u64,
    rerun: &'a str,
}

impl<'a> CaseResult<'a> {
    fn new(case: &'a CaseEvent) -> CaseResult<'a> {
        CaseResult {
            id: &case.id,
            dialect: &case.dialect,
            engine: &case.engine,
            verdict: case.verdict,
            grade: case.grade,
            title: &case.title,
            basis: &case.basis,
            area: &case.area,
            file: &case.file,
            line: case.line,
            expected: &case.expected,
            got: &case.got,
            duration_us: case.duration_us,
            rerun: &case.rerun,
        }
    }
}

#[derive(Serialize)]
struct ObservationResult<'a> {
    id: &'a str,
    dialect: &'a str,
    engine: &'a str,
    name: &'a str,
    value: &'a str,
}
