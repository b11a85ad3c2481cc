//! The description of a compiler by a table of `stickler.toml`.

use super::pattern::{DiagnosticPattern, ValuePattern};
use super::template::SCANS;
use crate::adapters::codes::CompilerCodes;
use crate::adapters::command::CommandTemplate;
use crate::adapters::source::main_program;
use crate::{Grade, RunRequest};
use serde::de::{self, SeqAccess, Visitor, value::SeqAccessDeserializer};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;
use stickler_types::{DialectName, Fault, join};

/// A compiler, described by data.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The compiler's own word for each dialect that it speaks.
    pub(super) dialects: BTreeMap<Parsed<DialectName>, String>,
    /// The command that prints the version.
    pub(super) version: Option<Parsed<CommandTemplate>>,
    /// The commands that check whether a program is accepted.
    pub(super) check: Option<Commands>,
    /// The commands that translate a program into something that `run` executes.
    pub(super) compile: Option<Commands>,
    /// The command that executes the program and prints the values of its variables.
    pub(super) run: Option<Parsed<CommandTemplate>>,
    /// The command that prints the program as normalised source.
    pub(super) render: Option<Parsed<CommandTemplate>>,
    /// The name of the file of the program.
    #[serde(default)]
    pub(super) file: FileName,
    /// The text behind the program in its file; `{program}` is the name of its main program.
    pub(super) append: Option<String>,
    /// The pattern of a diagnostic.
    pub(super) diagnostic: Option<Parsed<DiagnosticPattern>>,
    /// The pattern of a value.
    pub(super) value: Option<Parsed<ValuePattern>>,
    /// The meanings of the exit codes of `check`, `compile` and `render`.
    pub(super) exit: Option<BTreeMap<i32, Parsed<Meaning>>>,
    /// The meanings of the exit codes of `run`.
    pub(super) run_exit: Option<BTreeMap<i32, Parsed<Meaning>>>,
    /// The texts that `run` writes where a program stops at a fault, and their faults, for which the compiler may have words of its own;
    /// an empty one stands for what follows on the line.
    #[serde(default)]
    pub(super) faults: BTreeMap<String, String>,
    /// The meanings of the compiler's diagnostic codes.
    #[serde(default)]
    pub(super) codes: CompilerCodes,
    /// The best grade that can be asked of the compiler's rejections.
    pub(super) grade: Option<Grade>,
    /// The environment variables of the commands.
    #[serde(default)]
    pub(super) environment: BTreeMap<String, String>,
    /// The limits of each command.
    #[serde(default)]
    pub(super) limits: DescribedLimits,
    /// The address of the compiler's project.
    pub(super) project: Option<String>,
}

/// The limits of each command; the default of each is that of compilers with an adapter.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DescribedLimits {
    /// The time for which the compiler may run, in seconds.
    pub(super) seconds: Option<u32>,
    /// The time for which `run` may run, in seconds.
    pub(super) run_seconds: Option<u32>,
    /// The processor time that each command may take, in seconds.
    pub(super) cpu_seconds: Option<u32>,
    /// The memory that a command and all that it starts may hold, in MiB.
    pub(super) memory_mib: Option<u32>,
    /// The amount that a command may write, in MiB.
    pub(super) output_mib: Option<u32>,
}

impl Description {
    /// Returns the address of the compiler's project, if the description names one.
    pub fn project(&self) -> Option<&str> {
        self.project.as_deref()
    }

    /// Checks rules that involve several keys.
    ///
    /// # Errors
    /// The key that is wrong, and the reason.
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
            if key != "run" && template.has(SCANS) {
                return Err((key, "`{scans}` stands for something in `run` alone".to_owned()));
            }
        }
        Ok(())
    }

    /// Returns the compiler's own word for a dialect, or for the one that it extends; `None` where it speaks neither.
    pub(super) fn word(&self, dialect: DialectName) -> Option<&str> {
        let base = (!dialect.is_variant()).then_some(dialect.base());
        let mut names = [Some(dialect), base].into_iter().flatten();
        let word = names.find_map(|dialect| self.dialects.get(&Parsed(dialect)));
        word.map(String::as_str)
    }

    /// Returns the text of the file of a program: the program, and what stands behind it.
    pub(super) fn whole(&self, dialect: DialectName, program: &str) -> String {
        let mut text = program.to_owned();
        let request = RunRequest::once(dialect, program, &[]);
        if let (Some(append), Some(main)) = (&self.append, main_program(&request)) {
            text.push('\n');
            text.push_str(&append.replace("{program}", &main.name));
        }
        text
    }

    /// Returns every command with its key.
    pub(super) fn commands(&self) -> Vec<(&'static str, &CommandTemplate)> {
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

/// A value that is written as a text and parsed by [`FromStr`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(in crate::adapters) struct Parsed<T>(pub(in crate::adapters) T);

impl<'de, T: FromStr<Err: fmt::Display>> Deserialize<'de> for Parsed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map(Parsed).map_err(de::Error::custom)
    }
}

/// One command, or several that follow one another.
#[derive(Clone, Debug)]
pub(super) struct Commands(pub(super) Vec<Parsed<CommandTemplate>>);

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

/// The meaning of an exit code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meaning {
    /// The program is accepted, or ran to its end.
    Accepted,
    /// The program is rejected, for the reasons that the diagnostics give.
    Rejected,
    /// The program is rejected where there is a diagnostic, and otherwise accepted.
    Diagnosed,
    /// The compiler cannot do what was asked.
    Unsupported,
    /// The compiler does not implement a construct of the program.
    NotImplemented,
    /// The compiler failed.
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
            "not-implemented" => Ok(Meaning::NotImplemented),
            "crashed" => Ok(Meaning::Crashed),
            fault => match fault.strip_prefix("fault ") {
                Some(words) => Ok(Meaning::Faulted(Fault::reported(words))),
                None => fault.parse().map(Meaning::Faulted).map_err(|_| {
                    let faults = join(Fault::ALL.iter().map(|fault| format!("`{fault}`")), ", ");
                    format!(
                        "an exit code means `accepted`, `rejected`, `diagnosed`, `unsupported`, `not-implemented`, `crashed` or \
                         a fault ({faults}, or `fault WORDS` for another one), not `{text}`"
                    )
                }),
            },
        }
    }
}
