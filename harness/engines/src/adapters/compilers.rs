//! The data of the compilers with an adapter: `compilers.toml`, which says what its keys mean.

use super::Compiler;
use super::codes::CompilerCodes;
use super::dependencies::{Dependency, DependencySearch};
use super::described::Parsed;
use super::locate;
use super::recipe::{Purpose, Recipe, Tools, Workplace};
use crate::{Ability, Grade, Identity};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use stickler_types::{DialectName, Fault};

/// The data of one compiler.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CompilerData {
    pub(super) project: String,
    version: String,
    abilities: Vec<Ability>,
    grade: Grade,
    /// The compiler's own words for each dialect, behind which other options follow.
    pub(super) dialects: BTreeMap<Parsed<DialectName>, String>,
    /// The options for what the definition of a dialect turns on.
    #[serde(default)]
    pub(super) options: BTreeMap<String, String>,
    pub(super) tools: Vec<Dependency>,
    commands: BTreeMap<String, String>,
    #[serde(default)]
    faults: BTreeMap<String, String>,
    #[serde(default)]
    pub(super) codes: CompilerCodes,
}

static COMPILERS: LazyLock<BTreeMap<String, CompilerData>> = LazyLock::new(|| {
    toml::from_str(include_str!("compilers.toml")).expect("tests read the compilers that a program has")
});

impl Compiler {
    /// Returns the data of the compiler.
    pub(super) fn data(self) -> &'static CompilerData {
        &COMPILERS[self.as_str()]
    }
}

impl CompilerData {
    /// Returns a command, with values for what an adapter fills in.
    pub(super) fn command(&self, name: &str, values: &[(&str, &str)]) -> String {
        let command = self.commands.get(name).cloned().unwrap_or_default();
        let fill = |line: String, (name, value): &(&str, &str)| line.replace(&format!("{{{name}}}"), value);
        values.iter().fold(command, fill)
    }

    /// Returns the fault that these words of a program that stopped tell, if any.
    pub(super) fn fault(&self, words: &str) -> Option<Fault> {
        let told = self
            .faults
            .iter()
            .find(|(known, _)| words.contains(known.as_str()));
        told.map(|(_, fault)| Fault::reported(fault))
    }

    /// Finds the tools on this machine, and asks the compiler for its version, of which `version` keeps what tells versions apart.
    /// Returns it as an engine that is `called` so, and the paths of the tools.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(
        &'static self,
        called: &str,
        search: &mut DependencySearch<'_>,
        version: fn(&str) -> String,
    ) -> Result<(Identity, Tools), String> {
        let mut tools = Tools::new();
        for tool in &self.tools {
            let first = tools
                .first()
                .map_or(Path::new(""), |(_, first): &(String, PathBuf)| first);
            if let Some(path) = search.find(tool, first)? {
                tools.push((tool.shell_variable().to_owned(), path));
            }
        }
        let recipe = Recipe::default().line(&self.tools, Purpose::Translate, &self.version);
        let ended = Workplace::with(&tools)?.step(&recipe, Purpose::Translate, &[]);
        let (_, compiler) = &tools[0];
        let said = ended.map_err(|outcome| format!("`{}`: {outcome}", compiler.display()))?;
        let said = locate::said(&said)
            .ok_or_else(|| format!("`{}` does not say its version", compiler.display()))?;
        let identity = Identity {
            name: called.to_owned(),
            version: version(&said),
            dialects: self.dialects.keys().map(|dialect| dialect.0).collect(),
            abilities: self.abilities.clone(),
            grade: self.grade,
            lacks: Vec::new(),
        };
        Ok((identity, tools))
    }
}

/// Returns the last word of what a compiler says of its version.
pub(super) fn last_word(said: &str) -> String {
    said.rsplit(' ').next().unwrap_or_default().to_owned()
}

/// Returns the path of a tool that was found.
pub(super) fn path(tools: &Tools, variable: &str) -> PathBuf {
    let found = tools.iter().find(|(name, _)| name == variable);
    found.map_or_else(PathBuf::new, |(_, path)| path.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_compiler_has_its_data_and_each_command_can_be_split() {
        for compiler in Compiler::ALL {
            let data = compiler.data();
            assert!(data.project.starts_with("https://") && !data.dialects.is_empty());
            let lines = data.commands.values().chain([&data.version]);
            for line in lines {
                let adapters = ["options", "scans", "files", "all", "no-more", "position"];
                let line = adapters.iter().fold(line.clone(), |line, name| {
                    line.replace(&format!("{{{name}}}"), "x")
                });
                let variables: Vec<&str> = data.tools.iter().map(Dependency::shell_variable).collect();
                super::super::command::CommandTemplate::parse(&line, &variables).unwrap();
            }
        }
    }
}
