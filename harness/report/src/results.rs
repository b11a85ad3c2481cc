//! `results.json`: the numbers of a run and the cases that did not pass, for programs. reports/README.md names its keys.
//!
//! The cases that passed, what was observed, and the cases for which there is no room are in the event log alone.

use crate::claims::Claim;
use crate::overview::Overview;
use serde::Serialize;
use stickler_run::{BaselineHeader, CaseEvent, Cause, DefinedHeader, Footer, Grade, Header, Source, Totals};

/// The name of the document in a folder of reports.
pub(crate) const NAME: &str = "results.json";

/// The version of the format of `results.json`.
const FORMAT: u32 = 4;

/// The maximum number of bytes of the causes; those that explain the fewest cases are counted.
const MAX_CAUSE_BYTES: usize = 3 << 20;

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    let (Some(header), Some(footer)) = (&overview.header, &overview.footer) else {
        return Ok(Vec::new());
    };
    let all = overview.lacks.iter().chain(&overview.causes);
    let mut bytes = 0;
    let fitting = all.take_while(|cause| {
        bytes += serde_json::to_vec(cause).map_or(0, |json| json.len());
        bytes <= MAX_CAUSE_BYTES
    });
    let causes: Vec<&Cause> = fitting.collect();
    serde_json::to_vec(&ResultsDocument {
        format: FORMAT,
        stickler: &header.stickler,
        suite: &header.suite,
        started: &header.started,
        duration_ms: footer.duration_ms,
        causes_ms: footer.causes_ms,
        engines: engines(header, footer),
        filters: &header.filters,
        dialects: &header.dialects,
        shard: header.shard.as_deref(),
        broken_files: &header.broken_files,
        baselines: &header.baselines,
        defined: &header.defined,
        sources: &header.sources,
        claims: overview.claims.iter().collect(),
        causes_left_out: overview.lacks.len() + overview.causes.len() - causes.len(),
        causes,
        cases: overview.listed.iter().collect(),
        cases_left_out: overview.listed.left_out,
    })
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
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct ResultsDocument<'d> {
    /// The version of this format.
    #[cfg_attr(test, schemars(extend("const" = FORMAT)))]
    format: u32,
    /// The version of Stickler.
    stickler: &'d str,
    /// The version of the suite.
    suite: &'d str,
    /// The time at which the run began.
    #[cfg_attr(test, schemars(extend("format" = "date-time")))]
    started: &'d str,
    /// The duration of the run, in milliseconds.
    duration_ms: u64,
    /// The duration of the search for causes, in milliseconds; `null` where there was none.
    causes_ms: Option<u64>,
    /// The engines that took part.
    #[cfg_attr(test, schemars(length(min = 1)))]
    engines: Vec<EngineResult<'d>>,
    /// The filters by which cases were selected, as they were typed, and those that left cases out, behind `not`; empty where all cases
    /// were selected.
    filters: &'d [String],
    /// The dialects whose cases were selected; empty where all were.
    dialects: &'d [String],
    /// The part of a divided run, such as `2/4`.
    shard: Option<&'d str>,
    /// The case files that could not be read: file, line, key and what is wrong.
    broken_files: &'d [String],
    /// The baselines that took part.
    baselines: &'d [BaselineHeader],
    /// The dialects of the run that stickler.toml defines.
    defined: &'d [DefinedHeader],
    /// The sources that the cases of the suite may cite.
    sources: &'d [Source],
    /// The claims, each with the numbers of its cases.
    claims: Vec<Claim<'d>>,
    /// The causes of failing cases, those that explain most cases first.
    causes: Vec<&'d Cause>,
    /// The number of causes that `causes` has no room for; the event log has them.
    causes_left_out: usize,
    /// The cases that did not pass, each with at most 32000 characters of its program: all, or the first ones of each engine, case file and
    /// verdict.
    cases: Vec<&'d CaseEvent>,
    /// The number of cases that did not pass and that `cases` has no room for; the event log has them.
    cases_left_out: u64,
}

/// An engine that took part, with its totals.
#[derive(Serialize)]
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
