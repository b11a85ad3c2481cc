//! Reads a `results.json` that anyone hands in, as the events of its run.

use super::document::{PassedResult, ResultsDocument, case_key};
use super::error::ResultsError;
use super::{FORMAT, check};
use crate::LogError;
use crate::events::check_format;
use serde::Deserialize;
use std::collections::HashMap;
use std::fs;
use std::path::Path;
use stickler_run::{
    CaseEvent, Cause, EngineHeader, EngineTotals, Event, Footer, Header, Observed, Totals, Verdict,
};

/// The results of a run, checked.
pub(crate) struct ResultsRun {
    pub(crate) header: Header,
    cases: Vec<CaseEvent>,
    passed: Vec<PassedResult<'static>>,
    /// The observations by [`case_key`].
    observed: HashMap<String, Vec<Observed>>,
    causes: Vec<Cause>,
    footer: Footer,
}

impl ResultsRun {
    /// Returns the events of the run: its header, the cases that did not pass, those that passed, the causes, the footer. The document
    /// does not tell what was expected of a case that passed, so such an event has no fingerprint of it.
    pub(crate) fn into_events(self) -> impl Iterator<Item = Event> {
        let ResultsRun {
            header,
            cases,
            passed,
            mut observed,
            causes,
            footer,
        } = self;
        let passed = passed
            .into_iter()
            .flat_map(move |probe| expanded(&probe, &mut observed));
        let cases = cases.into_iter().chain(passed).map(Event::Case);
        std::iter::once(Event::Header(header))
            .chain(cases)
            .chain(causes.into_iter().map(Event::Cause))
            .chain(std::iter::once(Event::Footer(footer)))
    }
}

/// Reads the results of a run.
///
/// # Errors
/// [`ResultsError`], with the place in the document.
pub(crate) fn read(path: &Path) -> Result<ResultsRun, ResultsError> {
    parse(&fs::read(path)?)
}

/// Parses and checks the results of a run.
pub(super) fn parse(text: &[u8]) -> Result<ResultsRun, ResultsError> {
    if text.iter().all(u8::is_ascii_whitespace) {
        return Err(ResultsError::Empty);
    }
    match format_of(text)? {
        format if format < FORMAT => return Err(ResultsError::Earlier(format)),
        format if format > FORMAT => return Err(ResultsError::Later(format)),
        _ => {}
    }
    let mut json = serde_json::Deserializer::from_slice(text);
    let document: ResultsDocument<'static> =
        serde_path_to_error::deserialize(&mut json).map_err(|error| ResultsError::Schema {
            path: error.path().to_string(),
            source: error.into_inner(),
        })?;
    let counted = check::check(&document)?;
    Ok(run_of(document, counted))
}

/// Returns the version of a document's format.
fn format_of(text: &[u8]) -> Result<u32, ResultsError> {
    #[derive(Deserialize)]
    struct Format {
        #[serde(default)]
        format: serde_json::Value,
    }
    match serde_json::from_slice::<Format>(text) {
        Ok(Format { format }) => {
            let number = format.as_u64().and_then(|number| u32::try_from(number).ok());
            number.ok_or(ResultsError::NoFormat)
        }
        // A document of another format that was cut short is first of all one of another format.
        Err(error) => match check_format(text) {
            Err(LogError::Results { format }) if format != FORMAT => Ok(format),
            _ if error.is_eof() => Err(ResultsError::CutShort {
                line: error.line(),
                column: error.column(),
            }),
            _ if error.is_data() => Err(ResultsError::NoFormat),
            _ => Err(ResultsError::NoJson(error)),
        },
    }
}

fn run_of(document: ResultsDocument<'static>, counted: Vec<Totals>) -> ResultsRun {
    let mut totals = Totals::default();
    counted.iter().for_each(|engine| totals += *engine);
    let engines = document.engines.iter().map(|engine| EngineHeader {
        name: engine.name.to_string(),
        version: engine.version.to_string(),
        dialects: engine.dialects.to_vec(),
        strict: engine.strict,
        rerun: engine.rerun.to_string(),
        commands: std::collections::BTreeMap::new(),
    });
    let engines: Vec<EngineHeader> = engines.collect();
    let named = engines.iter().zip(counted);
    let footer = Footer {
        totals,
        engines: named
            .map(|(engine, totals)| EngineTotals {
                name: engine.name.clone(),
                totals,
            })
            .collect(),
        duration_ms: document.duration_ms,
    };
    ResultsRun {
        header: Header {
            format: stickler_run::FORMAT,
            stickler: document.stickler,
            suite: document.suite,
            started: document.started,
            command: String::new(),
            engines,
            cases: totals.all(),
            filters: document.filters,
            dialects: document.dialects,
            shard: document.shard,
            broken_files: document.broken_files,
            baselines: document.baselines,
            defined: document.defined,
            sources: document.sources,
        },
        observed: observed(&document.observations),
        cases: document
            .cases
            .into_iter()
            .map(super::document::CaseResult::into_event)
            .collect(),
        passed: document.passed,
        causes: document.causes,
        footer,
    }
}

fn observed(probes: &[super::document::ObservedResult<'_>]) -> HashMap<String, Vec<Observed>> {
    let mut observed: HashMap<String, Vec<Observed>> = HashMap::new();
    for probe in probes {
        for (arguments, values) in &probe.values.0 {
            for (dialect, value) in probe.dialects.iter().zip(values) {
                let key = case_key(&probe.engine, dialect, &probe.id, arguments);
                observed.entry(key).or_default().push(Observed {
                    name: probe.name.to_string(),
                    value: value.to_string(),
                });
            }
        }
    }
    observed
}

/// Returns the cases of a probe that passed, and takes their observations.
fn expanded(probe: &PassedResult<'_>, observed: &mut HashMap<String, Vec<Observed>>) -> Vec<CaseEvent> {
    let mut cases = Vec::with_capacity(probe.duration_us.0.len() * probe.dialects.len());
    for (arguments, durations) in &probe.duration_us.0 {
        let got = probe.got.get(arguments);
        for (dialect, duration_us) in probe.dialects.iter().zip(durations) {
            let key = case_key(&probe.engine, dialect, &probe.id, arguments);
            cases.push(CaseEvent {
                id: format!("{}{arguments}", probe.id),
                dialect: dialect.to_string(),
                engine: probe.engine.to_string(),
                verdict: Verdict::Pass,
                open: probe.open,
                grade: probe.grade,
                basis: probe.basis.to_string(),
                file: probe.file.to_string(),
                area: probe.area.to_string(),
                title: probe.title.to_string(),
                got: got
                    .and_then(|got| got.get(dialect))
                    .map_or_else(Vec::new, |got| got.to_vec()),
                duration_us: *duration_us,
                observations: observed.remove(&key).unwrap_or_default(),
                ..CaseEvent::default()
            });
        }
    }
    cases
}
