//! `results.json`: the whole run as one JSON document, for programs. Section 5 of the design names its keys.

use crate::ReportError;
use crate::claims::{Claims, Standing};
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::spool::Spool;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;
use stickler_run::{CaseEvent, Event, FORMAT, Footer, Grade, Header, Totals};

/// How the JSON of a case event begins: what the document says by its key `cases` already.
const TAG: &[u8] = br#"{"type":"case","#;

/// Gathers the run. Cases are kept as the JSON that they came as; the document is written when it is whole, with the
/// totals and claims, which are known last, in front.
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

    /// Adds one event, which is also given as JSON.
    ///
    /// # Errors
    /// [`ReportError::Serialise`] where an observation cannot be serialised.
    pub(crate) fn take(&mut self, event: &Event, json: &[u8]) -> Result<(), ReportError> {
        match event {
            // The header and the footer are taken from the overview, when the document is written.
            Event::Header(_) | Event::Footer(_) => Ok(()),
            Event::Case(case) => {
                match json.strip_prefix(TAG) {
                    Some(rest) => self.cases.push_json(&[b"{", rest]),
                    None => self.cases.push_json(&[json]),
                }
                Ok(self.take_observations(case)?)
            }
        }
    }

    fn take_observations(&mut self, case: &CaseEvent) -> serde_json::Result<()> {
        case.observations.iter().try_for_each(|observation| {
            self.observations.push(&ObservationResult {
                id: &case.id,
                dialect: &case.dialect,
                engine: &case.engine,
                name: &observation.name,
                value: &observation.value,
            })
        })
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
        key(out, "baselines", &header.baselines)?;
        key(out, "defined", &header.defined)?;
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
    spool: Spool,
}

impl List {
    fn push(&mut self, element: &impl Serialize) -> serde_json::Result<()> {
        let json = serde_json::to_vec(element)?;
        self.push_json(&[&json]);
        Ok(())
    }

    /// Adds an element that is JSON already, in pieces.
    fn push_json(&mut self, pieces: &[&[u8]]) {
        if !self.spool.is_empty() {
            self.spool.add(b",\n");
        }
        pieces.iter().for_each(|piece| self.spool.add(piece));
    }

    fn write(&self, out: &mut impl Write, name: &str) -> io::Result<()> {
        write!(out, ",\n\"{name}\":[\n")?;
        self.spool.write(out)?;
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
            strict: engine.strict,
            totals: totals(&engine.name).map(|found| found.totals).unwrap_or_default(),
        })
        .collect()
}

#[derive(Serialize)]
struct EngineResult<'a> {
    name: &'a str,
    version: &'a str,
    dialects: &'a [String],
    strict: Grade,
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
struct ObservationResult<'a> {
    id: &'a str,
    dialect: &'a str,
    engine: &'a str,
    name: &'a str,
    value: &'a str,
}
