//! The header of a run: what is known before its first case.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stickler_engines::Grade;
use stickler_suite::Source;

/// The facts of a run that are known before its first case.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
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
    pub sources: Vec<Source>,
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

/// The file name that stands for the program in [`EngineHeader::commands`].
pub const PROGRAM: &str = "program.st";

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

/// A baseline that takes part in a run.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BaselineHeader {
    /// The name of the engine that the baseline is for.
    pub engine: String,
    /// The path of the file, as messages show it.
    pub file: String,
    /// The number of entries.
    pub entries: u64,
    /// The entries that are out of date; a run with any of them is not as expected.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outdated: Vec<OutdatedEntry>,
}

/// An entry of a baseline that no longer applies to anything.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OutdatedEntry {
    /// The file and line of the entry.
    pub at: String,
    /// The id or the pattern of the entry.
    pub case: String,
    /// The reason why the entry is out of date, as a fragment: it fits no case, or its last day is past.
    pub why: String,
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
