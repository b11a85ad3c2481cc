//! The events of a run: a header, one event for each case and engine, the causes of what failed, a footer. Every report is a
//! projection of them and adds no facts; a stream without its footer is a truncated run. Basis: reports/README.md.

mod baseline;
mod cause;
mod source;
mod totals;
mod verdict;

pub use baseline::{BaselineHeader, BaselineNote, OutdatedEntry};
pub use cause::{Cause, ExplainedCases, Reduced, RepeatedOutcome, Repeats, Reproducer};
pub use source::SourceHeader;
pub use totals::Totals;
pub use verdict::Verdict;

use crate::Fact;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stickler_engines::Grade;
use stickler_types::Question;

/// The version of the event format.
pub const FORMAT: u32 = 3;

/// The file name that stands for the program in [`EngineHeader::commands`].
pub const PROGRAM: &str = "program.st";

/// An event of a run. Its form in a log is up to the log.
#[derive(Clone, PartialEq, Debug)]
pub enum Event {
    /// The first event.
    Header(Header),
    /// The result of a case on an engine; these events come in the order of the suite.
    Case(CaseEvent),
    /// A feature that an engine lacks, or a cause of failing cases, where the causes were searched for; these events come after the cases.
    Cause(Cause),
    /// The last event of a run that was not cut short.
    Footer(Footer),
}

/// The facts of a run that are known before its first case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Header {
    /// The version of the event format, [`FORMAT`].
    pub format: u32,
    /// The version of Stickler.
    pub stickler: String,
    /// The version of the suite.
    pub suite: String,
    /// The time at which the run began, as the caller writes it.
    pub started: String,
    /// The command that was run, as the caller writes it.
    pub command: String,
    /// The engines that take part, in the order in which they were given.
    pub engines: Vec<EngineHeader>,
    /// The number of case events that follow in a complete run.
    pub cases: u64,
    /// The filters by which cases were selected, as they were typed, and those that left cases out, behind `not`; empty where all cases
    /// were selected.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub filters: Vec<String>,
    /// The dialects whose cases were selected; empty where all were.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dialects: Vec<String>,
    /// The part of a divided run, such as `2/4`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<String>,
    /// The case files that could not be read: file, line, key and what is wrong.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub broken_files: Vec<String>,
    /// The baselines that take part, in the order of their engines.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub baselines: Vec<BaselineHeader>,
    /// The dialects of the run that stickler.toml defines.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub defined: Vec<DefinedHeader>,
    /// The sources that the cases of the suite may cite, Stickler's own rules among them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sources: Vec<SourceHeader>,
}

/// A custom dialect: another dialect with some of its rules overridden.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DefinedHeader {
    /// The name of the dialect.
    pub name: String,
    /// The dialect of a documented system that it extends.
    pub extends: String,
    /// The description of the dialect, for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// The overrides, in the words of the file: `implicit INT.BOOL = yes`.
    pub overrides: Vec<String>,
    /// The number of selected cases of the base dialect that this dialect does not inherit, because the overrides change
    /// their result and no document states the new one.
    pub left_out: u64,
}

/// An engine that takes part in a run.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EngineHeader {
    /// The name of the engine.
    pub name: String,
    /// The version of the engine.
    pub version: String,
    /// The dialects that the engine supports.
    pub dialects: Vec<String>,
    /// The worst grade of a rejection or a fault that still passes.
    #[serde(default)]
    pub strict: Grade,
    /// The template of the command that runs a case on this engine again; [`EngineHeader::rerun`] fills in the case.
    #[serde(default)]
    pub rerun: String,
    /// By dialect, the commands that give [`PROGRAM`] to this engine without Stickler; dialects for which the engine states
    /// none are missing.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub commands: BTreeMap<String, String>,
}

impl EngineHeader {
    /// Returns the exact command that runs a case again on this engine.
    #[must_use]
    pub fn rerun(&self, id: &str, dialect: &str) -> String {
        rerun(&self.rerun, id, dialect)
    }
}

/// The placeholder for the id of a case in the template of a rerun command, within single quotes of a shell.
pub(crate) const RERUN_ID: &str = "{id}";

/// The placeholder for the dialect of a case in the template of a rerun command.
pub(crate) const RERUN_DIALECT: &str = "{dialect}";

/// Fills in the template of a rerun command for one case.
pub(crate) fn rerun(template: &str, id: &str, dialect: &str) -> String {
    let command = template.replace(RERUN_DIALECT, dialect);
    command.replace(RERUN_ID, &id.replace('\'', r"'\''"))
}

/// The result of a case on an engine.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct CaseEvent {
    /// The id of the case; together with the dialect and the engine it is unique in a run.
    pub id: String,
    /// The dialect of the case.
    pub dialect: String,
    /// The name of the engine.
    pub engine: String,
    /// The verdict, after the engine's baseline was applied.
    pub verdict: Verdict,
    /// Whether the document leaves the result open: the case asserts nothing, or only that the program is accepted, and
    /// records what the engine does.
    pub open: bool,
    /// The grade of a rejection or a fault; `None` where neither was expected or neither came.
    pub grade: Option<Grade>,
    /// The claim that the case checks: document and section.
    pub basis: String,
    /// The path of the case file.
    pub file: String,
    /// The line of the case in the case file; `None` where it passed, since nobody looks for it then.
    pub line: Option<u32>,
    /// The area of the case: its folder, the first part of its id.
    pub area: String,
    /// The title of the case.
    pub title: String,
    /// A fingerprint of the expectation, by which two runs see whether they expected the same.
    pub expectation: u32,
    /// The expected facts, in a fixed order; empty where the case passed and `got` adds nothing to them.
    pub expected: Vec<Fact>,
    /// The actual facts, in the order of `expected`, so that a diff of their texts shows the deviation; empty where
    /// `expected` is.
    pub got: Vec<Fact>,
    /// The time that the engine took, in microseconds.
    pub duration_us: u64,
    /// The observations, which are recorded and not judged.
    pub observations: Vec<Observed>,
    /// The whole program, where the engine did not meet the expectation, with a timing diagram of several scans as a comment behind it;
    /// `None` otherwise, since the case file has it.
    pub program: Option<String>,
    /// The question that the program asks; `None` where it asks none, or where `program` is.
    pub question: Option<Question>,
    /// The note of the engine's baseline on the case; `None` where no entry matters to it.
    pub baseline: Option<BaselineNote>,
}

impl CaseEvent {
    /// Returns where the case stands: its file, and its line where that is known.
    #[must_use]
    pub fn place(&self) -> String {
        match self.line {
            Some(line) => format!("{}:{line}", self.file),
            None => self.file.clone(),
        }
    }

    /// Returns the part of the id that the cases of a table's probe share, or the whole id where the case comes from no table.
    #[must_use]
    pub fn probe(&self) -> &str {
        self.id.split_once('(').map_or(&self.id, |(probe, _)| probe)
    }

    /// Returns the verdict of the case as if there were no baseline.
    #[must_use]
    pub fn actual_verdict(&self) -> Verdict {
        match (self.verdict, &self.baseline) {
            (Verdict::Xfail, Some(note)) => note.verdict,
            (Verdict::Xfail, None) => Verdict::Fail,
            (Verdict::Xpass, _) => Verdict::Pass,
            (verdict, _) => verdict,
        }
    }
}

/// An observation: a result that is recorded and not judged.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Observed {
    /// The observed variable (`q`, `a[1]`, `q@3`), or `acceptance`, or `fault`.
    pub name: String,
    /// The value of the variable as a typed literal; `accepted` or `rejected` for an acceptance; the kind of fault for a
    /// fault.
    pub value: String,
}

/// The facts of a run that are known after its last case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Footer {
    /// The number of times that each verdict came in the whole run.
    pub totals: Totals,
    /// The verdict counts of each engine, in the order of the header.
    pub engines: Vec<EngineTotals>,
    /// The duration of the run until its last case, in milliseconds.
    pub duration_ms: u64,
    /// The duration of the search for causes behind it, in milliseconds; `None` where there was none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub causes_ms: Option<u64>,
}

/// The verdict counts of one engine.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EngineTotals {
    /// The name of the engine.
    pub name: String,
    /// The number of times that each verdict came on the engine.
    pub totals: Totals,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rerun_command_is_filled_in_with_what_a_shell_takes() {
        let template = "stickler run --filter '{id}' --dialect {dialect}";
        let command = rerun(template, "a(STRING,'x')", "matiec");
        assert_eq!(
            command,
            r"stickler run --filter 'a(STRING,'\''x'\'')' --dialect matiec"
        );
    }

    #[test]
    fn a_header_of_a_later_version_with_more_keys_is_read() {
        let line = r#"{"format":2,"stickler":"9","suite":"1","started":"","command":"",
            "engines":[],"cases":4,"weather":"fine"}"#;
        let header: Header = serde_json::from_str(line).unwrap();
        assert_eq!(
            (header.stickler.as_str(), header.cases, header.shard),
            ("9", 4, None)
        );
    }
}
