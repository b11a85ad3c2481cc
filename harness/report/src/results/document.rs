//! The content of `results.json`. Its published schema is made of these types.

#[cfg(test)]
use crate::claims::Claim;
#[cfg(test)]
use stickler_run::{BaselineHeader, Cause, DefinedHeader, SourceHeader};
use stickler_run::{BaselineNote, CaseEvent, EngineHeader, Fact, Grade, Observed, Totals, Verdict};

/// The results of a run of Stickler, a conformance suite of IEC 61131-3 compilers. Readers ignore keys that they do not know.
#[cfg(test)]
#[derive(schemars::JsonSchema)]
#[expect(
    dead_code,
    reason = "the document is written piece by piece; only its schema is made of this type"
)]
pub(crate) struct ResultsDocument<'d> {
    /// The version of this format.
    #[schemars(extend("const" = super::FORMAT))]
    pub(super) format: u32,
    /// The version of Stickler.
    pub(super) stickler: String,
    /// The version of the suite.
    pub(super) suite: String,
    /// The time at which the run began.
    #[schemars(extend("format" = "date-time"))]
    pub(super) started: String,
    /// The duration of the run, in milliseconds.
    pub(super) duration_ms: u64,
    /// The duration of the search for causes, in milliseconds; `null` where there was none.
    pub(super) causes_ms: Option<u64>,
    /// The engines that took part.
    #[schemars(length(min = 1))]
    pub(super) engines: Vec<EngineResult<'d>>,
    /// The filters by which cases were selected, as they were typed, and those that left cases out, behind `not`; empty where all cases
    /// were selected.
    pub(super) filters: Vec<String>,
    /// The dialects whose cases were selected; empty where all were.
    pub(super) dialects: Vec<String>,
    /// The part of a divided run, such as `2/4`.
    pub(super) shard: Option<String>,
    /// The case files that could not be read: file, line, key and what is wrong.
    pub(super) broken_files: Vec<String>,
    /// The baselines that took part.
    pub(super) baselines: Vec<BaselineHeader>,
    /// The dialects of the run that stickler.toml defines.
    pub(super) defined: Vec<DefinedHeader>,
    /// The sources that the cases of the suite may cite.
    pub(super) sources: Vec<SourceHeader>,
    /// The claims, each with the numbers of its cases.
    pub(super) claims: Vec<Claim<'d>>,
    /// The causes of failing cases, those that explain most cases first.
    pub(super) causes: Vec<Cause>,
    /// The cases that did not pass.
    pub(super) cases: Vec<CaseResult<'d>>,
}

/// An engine that took part, with its totals.
#[derive(serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct EngineResult<'d> {
    /// The name of the engine.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub(super) name: &'d str,
    /// The version of the engine.
    pub(super) version: &'d str,
    /// The dialects that the engine supports.
    pub(super) dialects: &'d [String],
    /// The worst grade of a rejection or a fault that passed.
    pub(super) strict: Grade,
    /// The template of the command that runs a case again.
    pub(super) rerun: &'d str,
    /// The number of times that each verdict came.
    pub(super) totals: Totals,
}

/// A case that did not pass.
#[derive(serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct CaseResult<'d> {
    /// The id of the case; together with dialect and engine it is unique.
    pub(super) id: &'d str,
    /// The dialect of the case.
    pub(super) dialect: &'d str,
    /// The name of the engine.
    pub(super) engine: &'d str,
    /// The verdict, which is not `pass`.
    pub(super) verdict: Verdict,
    /// Whether the case asserts nothing, or only that the program is accepted.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) open: bool,
    /// The grade of a rejection or a fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) grade: Option<Grade>,
    /// The title of the case.
    pub(super) title: &'d str,
    /// The claim of the case: source and section.
    pub(super) basis: &'d str,
    /// The area of the case.
    pub(super) area: &'d str,
    /// The path of the case file.
    pub(super) file: &'d str,
    /// The line of the case in the case file, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) line: Option<u32>,
    /// The expected facts.
    pub(super) expected: &'d [Fact],
    /// The actual facts, side by side with the expected ones.
    pub(super) got: &'d [Fact],
    /// The time that the engine took, in microseconds.
    pub(super) duration_us: u64,
    /// The command that runs the case alone.
    pub(super) rerun: String,
    /// The observations of the case.
    #[serde(skip_serializing_if = "<[Observed]>::is_empty")]
    pub(super) observations: &'d [Observed],
    /// The whole program, where the engine did not meet the expectation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) program: Option<&'d str>,
    /// The note of the engine's baseline on the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) baseline: Option<&'d BaselineNote>,
}

impl<'d> CaseResult<'d> {
    /// Returns the element for a case.
    pub(super) fn of(case: &'d CaseEvent, engine: Option<&EngineHeader>) -> CaseResult<'d> {
        CaseResult {
            id: &case.id,
            dialect: &case.dialect,
            engine: &case.engine,
            verdict: case.verdict,
            open: case.open,
            grade: case.grade,
            title: &case.title,
            basis: &case.basis,
            area: &case.area,
            file: &case.file,
            line: case.line,
            expected: &case.expected,
            got: &case.got,
            duration_us: case.duration_us,
            rerun: crate::engine::rerun(engine, case),
            observations: &case.observations,
            program: case.program.as_deref(),
            baseline: case.baseline.as_ref(),
        }
    }
}
