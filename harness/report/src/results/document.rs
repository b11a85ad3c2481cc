//! The content of `results.json`, as it is written and as it is read. Its published schema is made of these types.

use crate::claims::Standing;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{SerializeMap, Serializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;
use stickler_run::{
    BaselineHeader, BaselineNote, CaseEvent, Cause, DefinedHeader, EngineHeader, Fact, Grade, Observed,
    SourceHeader, Totals, Verdict,
};

/// The results of a run of Stickler, a conformance suite of IEC 61131-3 compilers. Readers ignore keys that they do not know.
#[derive(serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct ResultsDocument<'d> {
    /// The version of this format.
    #[expect(dead_code, reason = "it is read before the rest of the document")]
    #[cfg_attr(test, schemars(extend("const" = super::FORMAT)))]
    pub(super) format: u32,
    /// The version of Stickler.
    pub(super) stickler: String,
    /// The version of the suite.
    pub(super) suite: String,
    /// The time at which the run began.
    #[cfg_attr(test, schemars(extend("format" = "date-time")))]
    pub(super) started: String,
    /// The duration of the run, in milliseconds.
    pub(super) duration_ms: u64,
    /// The engines that took part.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub(super) engines: Vec<EngineResult<'d>>,
    /// The filters by which cases were selected, as they were typed; empty where all cases were.
    #[serde(default)]
    pub(super) filters: Vec<String>,
    /// The dialects whose cases were selected; empty where all were.
    #[serde(default)]
    pub(super) dialects: Vec<String>,
    /// The part of a divided run, such as `2/4`.
    #[serde(default)]
    pub(super) shard: Option<String>,
    /// The case files that could not be read: file, line, key and what is wrong.
    #[serde(default)]
    pub(super) broken_files: Vec<String>,
    /// The baselines that took part.
    #[serde(default)]
    pub(super) baselines: Vec<BaselineHeader>,
    /// The dialects of the run that stickler.toml defines.
    #[serde(default)]
    pub(super) defined: Vec<DefinedHeader>,
    /// The sources that the cases of the suite may cite.
    #[serde(default)]
    pub(super) sources: Vec<SourceHeader>,
    /// The claims, each with the numbers of its cases.
    #[serde(default)]
    #[expect(
        dead_code,
        reason = "a reader counts the cases instead; the claims are checked and dropped"
    )]
    pub(super) claims: Vec<ClaimResult<'d>>,
    /// The causes of failing cases, those that explain most cases first.
    #[serde(default)]
    pub(super) causes: Vec<Cause>,
    /// The cases that did not pass.
    pub(super) cases: Vec<CaseResult<'d>>,
    /// The cases that passed, by probe.
    pub(super) passed: Vec<PassedResult<'d>>,
    /// The observations of all cases, by probe.
    #[serde(default)]
    pub(super) observations: Vec<ObservedResult<'d>>,
}

/// An engine that took part, with its totals.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct EngineResult<'d> {
    /// The name of the engine.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub(super) name: Cow<'d, str>,
    /// The version of the engine.
    pub(super) version: Cow<'d, str>,
    /// The dialects that the engine supports.
    pub(super) dialects: Cow<'d, [String]>,
    /// The worst grade of a rejection or a fault that passed.
    #[serde(default)]
    pub(super) strict: Grade,
    /// The template of the command that runs a case again.
    #[serde(default)]
    pub(super) rerun: Cow<'d, str>,
    /// The number of times that each verdict came.
    pub(super) totals: Totals,
}

/// A section of a source with the results of one engine.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct ClaimResult<'d> {
    /// The name of the engine.
    pub(super) engine: Cow<'d, str>,
    /// The key of the source.
    pub(super) source: Cow<'d, str>,
    /// The section of the source.
    pub(super) section: Cow<'d, str>,
    /// The number of cases by what came of them.
    pub(super) standing: Standing,
}

/// A case that did not pass.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct CaseResult<'d> {
    /// The id of the case; together with dialect and engine it is unique.
    pub(super) id: Cow<'d, str>,
    /// The dialect of the case.
    pub(super) dialect: Cow<'d, str>,
    /// The name of the engine.
    pub(super) engine: Cow<'d, str>,
    /// The verdict, which is not `pass`.
    pub(super) verdict: Verdict,
    /// Whether the case asserts nothing, or only that the program is accepted.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(super) open: bool,
    /// The grade of a rejection or a fault.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) grade: Option<Grade>,
    /// The title of the case.
    pub(super) title: Cow<'d, str>,
    /// The claim of the case: source and section.
    pub(super) basis: Cow<'d, str>,
    /// The area of the case.
    pub(super) area: Cow<'d, str>,
    /// The path of the case file.
    pub(super) file: Cow<'d, str>,
    /// The line of the case in the case file, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) line: Option<u32>,
    /// The expected facts.
    pub(super) expected: Cow<'d, [Fact]>,
    /// The actual facts, side by side with the expected ones.
    pub(super) got: Cow<'d, [Fact]>,
    /// The time that the engine took, in microseconds.
    pub(super) duration_us: u64,
    /// The command that runs the case alone.
    #[serde(default)]
    pub(super) rerun: Cow<'d, str>,
    /// The observations of the case.
    #[serde(default, skip_serializing_if = "<[Observed]>::is_empty")]
    pub(super) observations: Cow<'d, [Observed]>,
    /// The whole program, where the engine did not meet the expectation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) program: Option<Cow<'d, str>>,
    /// The note of the engine's baseline on the case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) baseline: Option<Cow<'d, BaselineNote>>,
}

/// The cases of one probe that passed in the same dialects.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct PassedResult<'d> {
    /// The beginning of the ids of the cases.
    pub(super) id: Cow<'d, str>,
    /// The name of the engine.
    pub(super) engine: Cow<'d, str>,
    /// The dialects in which the cases passed.
    pub(super) dialects: Vec<Cow<'d, str>>,
    /// The title of the cases.
    pub(super) title: Cow<'d, str>,
    /// The claim of the cases: source and section.
    pub(super) basis: Cow<'d, str>,
    /// The path of the case file.
    pub(super) file: Cow<'d, str>,
    /// The area of the cases.
    pub(super) area: Cow<'d, str>,
    /// Whether the cases assert nothing, or only that the program is accepted.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(super) open: bool,
    /// The grade of a rejection or a fault.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) grade: Option<Grade>,
    /// By the rest of the case's id and by dialect, the actual facts, where neither the expectation nor an observation tells them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) got: ActualFacts<'d>,
    /// By the rest of the case's id, the time that the engine took in each of the dialects, in microseconds.
    #[cfg_attr(test, schemars(with = "BTreeMap<String, Vec<u64>>"))]
    pub(super) duration_us: ByArguments<'d, u64>,
}

/// The observations of one variable in the cases of one probe.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct ObservedResult<'d> {
    /// The beginning of the ids of the cases.
    pub(super) id: Cow<'d, str>,
    /// The name of the engine.
    pub(super) engine: Cow<'d, str>,
    /// The dialects of the cases.
    pub(super) dialects: Vec<Cow<'d, str>>,
    /// The observed variable, or `acceptance`, or `fault`.
    pub(super) name: Cow<'d, str>,
    /// By the rest of the case's id, what was observed in each of the dialects.
    #[cfg_attr(test, schemars(with = "BTreeMap<String, Vec<String>>"))]
    pub(super) values: ByArguments<'d, Cow<'d, str>>,
}

/// Actual facts of cases of one probe: by the rest of the case's id, and under it by dialect.
pub(super) type ActualFacts<'d> = BTreeMap<Cow<'d, str>, BTreeMap<Cow<'d, str>, Cow<'d, [Fact]>>>;

/// The cases of a probe in their order: a JSON object with a key for the arguments of each case, and under it a value for each
/// dialect.
pub(super) struct ByArguments<'d, T>(pub(super) Vec<(Cow<'d, str>, Vec<T>)>);

impl<T: serde::Serialize> serde::Serialize for ByArguments<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (arguments, values) in &self.0 {
            map.serialize_entry(arguments, values)?;
        }
        map.end()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for ByArguments<'_, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Entries<T> {
            type Value = Vec<(Cow<'static, str>, Vec<T>)>;
            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("an object with a key for the arguments of each case")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries = Vec::with_capacity(map.size_hint().unwrap_or(0));
                while let Some((arguments, values)) = map.next_entry::<String, Vec<T>>()? {
                    entries.push((Cow::Owned(arguments), values));
                }
                Ok(entries)
            }
        }
        deserializer
            .deserialize_map(Entries(PhantomData))
            .map(ByArguments)
    }
}

impl<'d> CaseResult<'d> {
    /// Returns the element for a case.
    pub(super) fn of(case: &'d CaseEvent, engine: Option<&EngineHeader>) -> CaseResult<'d> {
        CaseResult {
            id: Cow::Borrowed(&case.id),
            dialect: Cow::Borrowed(&case.dialect),
            engine: Cow::Borrowed(&case.engine),
            verdict: case.verdict,
            open: case.open,
            grade: case.grade,
            title: Cow::Borrowed(&case.title),
            basis: Cow::Borrowed(&case.basis),
            area: Cow::Borrowed(&case.area),
            file: Cow::Borrowed(&case.file),
            line: case.line,
            expected: Cow::Borrowed(&case.expected),
            got: Cow::Borrowed(&case.got),
            duration_us: case.duration_us,
            rerun: Cow::Owned(crate::engine::rerun(engine, case)),
            observations: Cow::Borrowed(&case.observations),
            program: case.program.as_deref().map(Cow::Borrowed),
            baseline: case.baseline.as_ref().map(Cow::Borrowed),
        }
    }

    /// Returns the event of the case.
    pub(super) fn into_event(self) -> CaseEvent {
        CaseEvent {
            id: self.id.into_owned(),
            dialect: self.dialect.into_owned(),
            engine: self.engine.into_owned(),
            verdict: self.verdict,
            open: self.open,
            grade: self.grade,
            basis: self.basis.into_owned(),
            file: self.file.into_owned(),
            line: self.line,
            area: self.area.into_owned(),
            title: self.title.into_owned(),
            expectation: Fact::fingerprint(&self.expected),
            expected: self.expected.into_owned(),
            got: self.got.into_owned(),
            duration_us: self.duration_us,
            observations: self.observations.into_owned(),
            program: self.program.map(Cow::into_owned),
            baseline: self.baseline.map(Cow::into_owned),
        }
    }
}

/// Returns what tells a case from all others of a run.
pub(super) fn case_key(engine: &str, dialect: &str, probe: &str, arguments: &str) -> String {
    format!("{engine}\0{dialect}\0{probe}{arguments}")
}
