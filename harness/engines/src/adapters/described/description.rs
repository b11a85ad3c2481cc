//! What a table of `stickler.toml` says about a compiler.

use super::pattern::{DiagnosticPattern, ValuePattern};
use super::template::{Placeholder, Template};
use crate::Grade;
use serde::de::{self, SeqAccess, Visitor, value::SeqAccessDeserializer};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;
use stickler_types::{Code, DialectName, Fault};

/// A compiler, described by data.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The compiler's own word for each dialect that it speaks.
    pub(super) dialects: BTreeMap<Parsed<DialectName>, String>,
    /// Prints the version.
    pub(super) version: Option<Parsed<Template>>,
    /// Says whether a program is accepted.
    pub(super) check: Option<Commands>,
    /// Makes something of a program that `run` executes.
    pub(super) compile: Option<Commands>,
    /// Executes it and prints the values of its variables.
    pub(super) run: Option<Parsed<Template>>,
    /// Prints the program as normalised source.
    pub(super) render: Option<Parsed<Template>>,
    /// What the file of the program is called.
    #[serde(default)]
    pub(super) file: FileName,
    /// What stands behind the program in its file; `{program}` is the name of its main program.
    pub(super) append: Option<String>,
    /// How a diagnostic is written.
    pub(super) diagnostic: Option<Parsed<DiagnosticPattern>>,
    /// How a value is written.
    pub(super) value: Option<Parsed<ValuePattern>>,
    /// What the exit codes of `check`, `compile` and `render` mean.
    pub(super) exit: Option<BTreeMap<i32, Parsed<Meaning>>>,
    /// What those of `run` mean.
    pub(super) run_exit: Option<BTreeMap<i32, Parsed<Meaning>>>,
    /// Words that `run` writes where a program stops at a fault.
    #[serde(default)]
    pub(super) faults: BTreeMap<String, Parsed<Fault>>,
    /// What its codes mean.
    #[serde(default)]
    pub(super) codes: BTreeMap<String, Parsed<CodeMeaning>>,
    /// How exactly it can say what is wrong.
    pub(super) grade: Option<Grade>,
    /// Environment variables of its commands.
    #[serde(default)]
    pub(super) environment: BTreeMap<String, String>,
    /// What each command may take.
    #[serde(default)]
    pub(super) limits: Limits,
    /// Where its project is.
    pub(super) project: Option<String>,
}

/// What each command may take; what is left out is as for compilers with an adapter.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// How long the compiler may run.
    pub(super) seconds: Option<u32>,
    /// How long `run` may.
    pub(super) run_seconds: Option<u32>,
    /// How much processor time each may take.
    pub(super) cpu_seconds: Option<u32>,
    /// How much memory, with all that it starts.
    pub(super) memory_mib: Option<u32>,
    /// How much it may write.
    pub(super) output_mib: Option<u32>,
}

impl Description {
    /// Returns the address of its project, if it names one.
    #[must_use]
    pub fn project(&self) -> Option<&str> {
        self.project.as_deref()
    }

    /// Looks for what no key is wrong about by itself.
    ///
    /// # Errors
    /// The key at which to look, and what is wrong.
    pub fn check(&self) -> Result<(), (&'static str, String)> {
        if self.dialects.is_empty() {
            return Err((
                "dialects",
                "name at least one dialect, as in `ironplc-ed3 = \"\"`".to_owned(),
            ));
        }
        if self.check.is_none() && self.compile.is_none() && self.run.is_none() {
            let reason = "a compiler needs one of the commands `check`, `compile` and `run`";
            return Err(("dialects", reason.to_owned()));
        }
        if self.run.is_some() && self.value.is_none() {
            let reason =
                "`run` needs a `value`: how a value is printed, as in '^(?<name>\\w+) = (?<value>.*)$'";
            return Err(("run", reason.to_owned()));
        }
        let both = [&self.exit, &self.run_exit];
        let mut meanings = both.into_iter().flatten().flat_map(BTreeMap::values);
        if self.diagnostic.is_none() && meanings.any(|meaning| meaning.0 == Meaning::Diagnosed) {
            return Err((
                "exit",
                "`diagnosed` needs a `diagnostic`: how a diagnostic is written".to_owned(),
            ));
        }
        for (key, template) in self.commands() {
            if key != "run" && template.has(Placeholder::Scans) {
                return Err((key, "`{scans}` stands for something in `run` alone".to_owned()));
            }
        }
        Ok(())
    }

    /// Every command with its key.
    pub(super) fn commands(&self) -> Vec<(&'static str, &Template)> {
        let mut commands = Vec::new();
        for (key, template) in [
            ("version", &self.version),
            ("run", &self.run),
            ("render", &self.render),
        ] {
            commands.extend(template.as_ref().map(|template| (key, &template.0)));
        }
        for (key, several) in [("check", &self.check), ("compile", &self.compile)] {
            let several = several.iter().flat_map(|several| &several.0);
            commands.extend(several.map(|template| (key, &template.0)));
        }
        commands
    }
}

/// A value that is written as a text, read by [`FromStr`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Parsed<T>(pub(super) T);

impl<'de, T: FromStr<Err: fmt::Display>> Deserialize<'de> for Parsed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map(Parsed).map_err(de::Error::custom)
    }
}

/// One command, or several that follow one another.
#[derive(Clone, Debug)]
pub(super) struct Commands(pub(super) Vec<Parsed<Template>>);

impl<'de> Deserialize<'de> for Commands {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneOrMore)
    }
}

struct OneOrMore;

impl<'de> Visitor<'de> for OneOrMore {
    type Value = Commands;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a command, or a list of commands")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Commands, E> {
        let template = text.parse().map_err(E::custom)?;
        Ok(Commands(vec![Parsed(template)]))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Commands, A::Error> {
        let commands = Vec::deserialize(SeqAccessDeserializer::new(items))?;
        match commands.is_empty() {
            true => Err(de::Error::custom("the list has no command")),
            false => Ok(Commands(commands)),
        }
    }
}

/// The name of a file in the folder of a command.
#[derive(Clone, Debug)]
pub(super) struct FileName(pub(super) String);

impl Default for FileName {
    fn default() -> FileName {
        FileName("program.st".to_owned())
    }
}

impl<'de> Deserialize<'de> for FileName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        if name.is_empty() || name.starts_with('.') || name.contains(['/', '\\']) {
            return Err(de::Error::custom(
                "this is no name of a file in a folder, such as `program.st`",
            ));
        }
        Ok(FileName(name))
    }
}

/// What an exit code means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meaning {
    /// The program is accepted, or ran to its end.
    Accepted,
    /// It is rejected, for what the diagnostics say.
    Rejected,
    /// It is rejected where there is a diagnostic, and otherwise accepted.
    Diagnosed,
    /// The compiler cannot do what was asked.
    Unsupported,
    /// The compiler went wrong.
    Crashed,
    /// The program stopped at this fault.
    Faulted(Fault),
}

impl FromStr for Meaning {
    type Err = String;

    fn from_str(text: &str) -> Result<Meaning, String> {
        match text {
            "accepted" => Ok(Meaning::Accepted),
            "rejected" => Ok(Meaning::Rejected),
            "diagnosed" => Ok(Meaning::Diagnosed),
            "unsupported" => Ok(Meaning::Unsupported),
            "crashed" => Ok(Meaning::Crashed),
            fault => fault.parse().map(Meaning::Faulted).map_err(|_| {
                let faults = Fault::ALL.map(|fault| format!("`{fault}`")).join(", ");
                format!(
                    "an exit code means `accepted`, `rejected`, `diagnosed`, `unsupported`, `crashed` or a fault ({faults}), \
                     not `{text}`"
                )
            }),
        }
    }
}

/// What a code of the compiler's own means.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum CodeMeaning {
    /// It says the same as this code of the registry.
    Code(Code),
    /// The compiler cannot do what was asked.
    Unsupported,
    /// The compiler went wrong.
    Crashed,
}

impl FromStr for CodeMeaning {
    type Err = String;

    fn from_str(text: &str) -> Result<CodeMeaning, String> {
        match text {
            "unsupported" => Ok(CodeMeaning::Unsupported),
            "crashed" => Ok(CodeMeaning::Crashed),
            code => code.parse().map(CodeMeaning::Code).map_err(|_| {
                format!(
                    "`{text}` is no code of Stickler's; `stickler explain` lists them, and there are `unsupported` and \
                     `crashed`"
                )
            }),
        }
    }
}
