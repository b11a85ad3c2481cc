//! `results.json`: the whole run as one JSON document, for programs. reports/README.md names its keys.
//!
//! A case that did not pass is in `cases` with all its properties. The cases that passed are in `passed`, each with only its
//! arguments and its times, under the common properties of its probe.

mod check;
mod document;
mod error;
mod passed;
mod read;
#[cfg(test)]
mod schema_tests;

pub use error::ResultsError;
pub(crate) use read::read;

use crate::groups::{GroupNumber, Groups};
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::spool::Spool;
use crate::{ReportError, engine};
use document::{CaseResult, ClaimResult, EngineResult};
use passed::Passed;
use serde::Serialize;
use std::borrow::Cow;
use std::io::{self, Write};
use std::path::PathBuf;
use stickler_run::{EngineHeader, Event, Footer, Header, Verdict};

/// The name of the document in a folder of reports.
pub(crate) const NAME: &str = "results.json";

/// The version of the format of `results.json`.
pub(crate) const FORMAT: u32 = 2;

/// The JSON Schema of `results.json`, as it is published.
pub(crate) const SCHEMA: &str = include_str!("../schemas/results.schema.json");

/// The results of a run, gathered until the document is written: it begins with the totals and claims, which are known last.
pub(crate) struct Results {
    file: PendingFile,
    engines: Vec<EngineHeader>,
    cases: JsonList,
    passed: Passed,
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
            cases: JsonList::default(),
            passed: Passed::default(),
        })
    }

    /// Adds one event, with the group of a case.
    ///
    /// # Errors
    /// [`ReportError::Serialise`] where a case cannot be serialised.
    pub(crate) fn take(&mut self, event: &Event, group: Option<GroupNumber>) -> Result<(), ReportError> {
        match (event, group) {
            (Event::Header(header), _) => self.engines.clone_from(&header.engines),
            (Event::Case(case), Some(group)) => {
                self.passed.take(case, group);
                if case.verdict != Verdict::Pass {
                    let engine = engine::of(&self.engines, case);
                    self.cases.push(&CaseResult::of(case, engine))?;
                }
            }
            // The footer is taken from the overview, when the document is written.
            (Event::Case(_) | Event::Cause(_) | Event::Footer(_), _) => {}
        }
        Ok(())
    }

    /// Writes the document. A run without header or footer has no results.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn finish(mut self, overview: &Overview, groups: &Groups) -> Result<(), ReportError> {
        let (Some(header), Some(footer)) = (&overview.header, &overview.footer) else {
            return Ok(());
        };
        let path = self.file.path().to_owned();
        self.write(header, footer, overview, groups)
            .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }

    fn write(
        &mut self,
        header: &Header,
        footer: &Footer,
        overview: &Overview,
        groups: &Groups,
    ) -> io::Result<()> {
        let out = &mut self.file;
        write!(out, "{{\"format\":{FORMAT}")?;
        key(out, "stickler", &header.stickler)?;
        key(out, "suite", &header.suite)?;
        key(out, "started", &header.started)?;
        key(out, "duration_ms", &footer.duration_ms)?;
        key(out, "engines", &engines(header, footer))?;
        key(out, "filters", &header.filters)?;
        key(out, "dialects", &header.dialects)?;
        key(out, "shard", &header.shard)?;
        key(out, "broken_files", &header.broken_files)?;
        key(out, "baselines", &header.baselines)?;
        key(out, "defined", &header.defined)?;
        key(out, "sources", &header.sources)?;
        let mut list = JsonList::default();
        for claim in overview.claims.iter() {
            list.push(&ClaimResult {
                engine: claim.engine.into(),
                source: claim.source.into(),
                section: claim.section.into(),
                standing: claim.standing,
            })?;
        }
        list.write(out, "claims")?;
        let mut causes = JsonList::default();
        for cause in &overview.causes {
            causes.push(cause)?;
        }
        causes.write(out, "causes")?;
        self.cases.write(out, "cases")?;
        self.passed.list(groups)?.write(out, "passed")?;
        self.passed.observations(groups)?.write(out, "observations")?;
        out.write_all(b"}\n")
    }
}

/// Writes one key of the document's top level, which follows at least one other.
fn key(out: &mut impl Write, name: &str, value: &impl Serialize) -> io::Result<()> {
    write!(out, ",\n\"{name}\":")?;
    Ok(serde_json::to_writer(out, value)?)
}

/// A JSON array that grows, with one element per line.
#[derive(Default)]
struct JsonList {
    spool: Spool,
}

impl JsonList {
    fn push(&mut self, element: &impl Serialize) -> serde_json::Result<()> {
        let json = serde_json::to_vec(element)?;
        if !self.spool.is_empty() {
            self.spool.add(b",\n");
        }
        self.spool.add(&json);
        Ok(())
    }

    fn write(&self, out: &mut impl Write, name: &str) -> io::Result<()> {
        write!(out, ",\n\"{name}\":[\n")?;
        self.spool.write(out)?;
        out.write_all(b"\n]")
    }
}

/// Returns each engine of the header with its totals from the footer.
fn engines<'a>(header: &'a Header, footer: &'a Footer) -> Vec<EngineResult<'a>> {
    let totals = |name: &str| footer.engines.iter().find(|engine| engine.name == name);
    header
        .engines
        .iter()
        .map(|engine| EngineResult {
            name: Cow::Borrowed(&engine.name),
            version: Cow::Borrowed(&engine.version),
            dialects: Cow::Borrowed(&engine.dialects),
            strict: engine.strict,
            rerun: Cow::Borrowed(&engine.rerun),
            totals: totals(&engine.name).map(|found| found.totals).unwrap_or_default(),
        })
        .collect()
}
