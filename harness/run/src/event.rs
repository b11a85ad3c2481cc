//! The events of a run: a header, one event a case, a footer. Every report is a projection of them and has no
//! facts of its own; a stream without its footer is a truncated run. Basis: design, section 5.

mod baseline;
mod totals;
mod verdict;

pub use baseline::{BaselineHeader, BaselineNote, OutdatedEntry};
pub use totals::Totals;
pub use verdict::Verdict;

use crate::Fact;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stickler_engines::Grade;

/// The version of the event format.
pub const FORMAT: u32 = 2;

/// What the file of a program is called in [`EngineHeader::commands`].
pub const PROGRAM: &str = "program.st";

/// One event of a run. How a log writes it down is not its own affair.
#[derive(Clone, PartialEq, Debug)]
pub enum Event {
    /// The first event.
    Header(Header),
    /// A case on an engine, in the order of the suite.
    Case(CaseEvent),
    /// The last event of a run that was not cut short.
    Footer(Footer),
}

/// What is known before the first case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct Header {
    /// The version of this format, [`FORMAT`].
    pub format: u32,
    /// The version of Stickler.
    pub stickler: String,
    /// The version of the suite.
    pub suite: String,
    /// When the run began, as the caller writes it.
    pub started: String,
    /// The command that was run, as the caller writes it.
    pub command: String,
    /// The engines that take part, in their order.
    pub engines: Vec<EngineHeader>,
    /// How many case events follow in a run that is not cut short.
    pub cases: u64,
    /// The filters by which cases were selected, as they were typed; none selects all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub filters: Vec<String>,
    /// The dialects of which cases were selected; none is all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dialects: Vec<String>,
    /// The part of a divided run, `2/4`.
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
}

/// A dialect that is another one with some rules overridden.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct DefinedHeader {
    /// Its name.
    pub name: String,
    /// The dialect of a documented system that it extends.
    pub extends: String,
    /// What it is, for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// What it overrides, in the words of the file: `implicit INT.BOOL = yes`.
    pub overrides: Vec<String>,
    /// How many of the selected cases of that dialect it does not take over, because what it overrides changes them and no
    /// document says how.
    pub left_out: u64,
}

/// An engine that takes part in a run.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct EngineHeader {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// The dialects it speaks.
    pub dialects: Vec<String>,
    /// How exact its rejections and faults had to be to pass.
    #[serde(default)]
    pub strict: Grade,
    /// The command that runs a case on this engine again; [`EngineHeader::rerun`] fills in which.
    #[serde(default)]
    pub rerun: String,
    /// By dialect, the command by which a person has this engine do the same with [`PROGRAM`], without Stickler; none where
    /// the engine knows of none.
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

/// Stands for the id of a case in the template of a command that runs it again, within single quotes of a shell.
pub(crate) const RERUN_ID: &str = "{id}";

/// Stands for the dialect of a case in the template of a command that runs it again.
pub(crate) const RERUN_DIALECT: &str = "{dialect}";

/// Returns the command of a template for one case.
pub(crate) fn rerun(template: &str, id: &str, dialect: &str) -> String {
    let command = template.replace(RERUN_DIALECT, dialect);
    command.replace(RERUN_ID, &id.replace('\'', r"'\''"))
}

/// A case on an engine.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct CaseEvent {
    /// The case's id; with the dialect and the engine it is unique in a run.
    pub id: String,
    /// The dialect.
    pub dialect: String,
    /// The engine's name.
    pub engine: String,
    /// What came of it.
    pub verdict: Verdict,
    /// The document leaves it open: the case asserts nothing, or only that the program is accepted, and records what the
    /// engine does.
    pub open: bool,
    /// How exactly a rejection or a fault was right; `None` where neither was expected or neither came.
    pub grade: Option<Grade>,
    /// The claim: document and section.
    pub basis: String,
    /// The case file.
    pub file: String,
    /// The line in the case file at which the case stands; `None` where it passed, for then nobody looks for it.
    pub line: Option<u32>,
    /// The folder of the case, the first part of its id.
    pub area: String,
    /// The case's title.
    pub title: String,
    /// A fingerprint of what had to happen, by which two runs see whether they expected the same.
    pub expectation: u32,
    /// What had to happen, in a fixed order; empty where the case passed and `got` tells nothing more.
    pub expected: Vec<Fact>,
    /// What happened, fact by fact beside `expected`, so that a diff of their texts shows what was not as expected; empty where
    /// `expected` is.
    pub got: Vec<Fact>,
    /// How long the engine took, in microseconds.
    pub duration_us: u64,
    /// What was recorded and not judged.
    pub observations: Vec<Observed>,
    /// The whole program, where the engine did not do with it what was expected; of all others the case has it.
    pub program: Option<String>,
    /// What the engine's baseline says of the case, where it says something.
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

    /// What came of the case, whatever a baseline expects.
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

/// Something recorded and not judged.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Observed {
    /// The variable (`q`, `a[1]`, `q@3`), `acceptance`, or `fault`.
    pub name: String,
    /// Its value as a typed literal; `accepted` or `rejected`; the fault.
    pub value: String,
}

/// What is known after the last case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct Footer {
    /// The verdicts of the whole run, counted.
    pub totals: Totals,
    /// The verdicts by engine, in the header's order.
    pub engines: Vec<EngineTotals>,
    /// How long the run took, in milliseconds.
    pub duration_ms: u64,
}

/// The verdicts of one engine, counted.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct EngineTotals {
    /// The engine's name.
    pub name: String,
    /// Its verdicts.
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
