//! Calls the commands of a described compiler, and interprets how they end.

use super::DescribedEngine;
use super::description::{Commands, Description, Meaning, Parsed};
use super::template::CallValues;
use crate::adapters::codes::sorted;
use crate::adapters::command::CommandTemplate;
use crate::adapters::locate::{self, failed, unsupported, without_colours};
use crate::process::{Ended, Folder, ToolLimits, run_tool_with};
use crate::{Diagnostic, Outcome};
use std::time::Duration;
use stickler_types::{DialectName, Fault};

/// The output of one execution, the fault at which it stopped, and the warnings of a compiler that only runs programs.
pub(super) struct Execution {
    pub(super) text: String,
    pub(super) fault: Option<Fault>,
    pub(super) warnings: Vec<Diagnostic>,
}

/// The calls of an engine's commands on one program.
pub(super) struct DescribedCall<'c> {
    pub(super) engine: &'c DescribedEngine,
    pub(super) folder: &'c Folder,
    /// The compiler's own word for the dialect.
    pub(super) dialect: &'c str,
}

impl DescribedCall<'_> {
    fn description(&self) -> &Description {
        &self.engine.description
    }

    /// Writes the file of the program.
    pub(super) fn write(&self, dialect: DialectName, source: &str) -> Result<(), Outcome> {
        let description = self.description();
        let text = description.whole(dialect, source);
        self.folder.write(&description.file.0, &text).map_err(failed)?;
        Ok(())
    }

    /// Runs a command.
    pub(super) fn run(&self, template: &CommandTemplate, scans: u32) -> Result<Ended, Outcome> {
        self.run_for(template, scans, self.limits(None))
    }

    fn run_for(&self, template: &CommandTemplate, scans: u32, limits: ToolLimits) -> Result<Ended, Outcome> {
        let values = CallValues {
            file: &self.description().file.0,
            dialect: self.dialect,
            folder: self.folder.path(),
            scans,
            here: &self.engine.here,
        };
        let (program, arguments) = values.filled(template);
        run_tool_with(&program, &arguments, self.folder.path(), &limits, |start| {
            start.envs(&self.description().environment);
        })
    }

    /// Runs commands one after the other, until one does not accept the program. Returns the warnings of all.
    pub(super) fn all(&self, commands: &Commands) -> Result<Vec<Diagnostic>, Outcome> {
        let mut warnings = Vec::new();
        for template in &commands.0 {
            let ended = self.run(&template.0, 0)?;
            self.accepted(&ended)?;
            warnings.extend(self.warnings(&ended));
        }
        Ok(warnings)
    }

    /// Runs the program for `scans` scans.
    pub(super) fn execute(&self, template: &CommandTemplate, scans: u32) -> Result<Execution, Outcome> {
        let description = self.description();
        let limits = self.limits(Some(locate::EXECUTION_TIMEOUT));
        let ended = self.run_for(template, scans, limits)?;
        let text = without_colours(&ended.stdout);
        let warnings = match description.compile {
            None => self.warnings(&ended),
            Some(_) => Vec::new(),
        };
        let executed = |text, fault| Execution {
            text,
            fault,
            warnings,
        };
        if ended.stopped_by_arithmetic() {
            return Ok(executed(text, Some(Fault::DivisionByZero)));
        }
        let code = ended.code()?;
        let meaning = match (&description.run_exit, &description.exit) {
            (Some(meanings), _) => meaning_or_crashed(meanings.get(&code)),
            // A compiler that only runs programs reports a rejection by the same codes.
            (None, Some(meanings)) if description.compile.is_none() => {
                meaning_or_crashed(meanings.get(&code))
            }
            (None, None) if description.compile.is_none() => usual(code),
            (None, _) if code == 0 => Meaning::Accepted,
            (None, _) => Meaning::Crashed,
        };
        let words = |(words, _): &(&String, _)| {
            text.contains(words.as_str()) || ended.stderr.contains(words.as_str())
        };
        match meaning {
            Meaning::Accepted => Ok(executed(text, None)),
            Meaning::Faulted(fault) => Ok(executed(text, Some(fault))),
            other => match description.faults.iter().find(words) {
                Some((words, fault)) => {
                    let own = || behind(words, &text).or_else(|| behind(words, &ended.stderr));
                    let fault = match fault.is_empty() {
                        true => Fault::reported(own().unwrap_or_default()),
                        false => Fault::reported(fault),
                    };
                    Ok(executed(text, Some(fault)))
                }
                None => self.meant(other, &ended).map(|()| executed(text, None)),
            },
        }
    }

    /// Tells whether a command of the compiler says that it accepts the program.
    pub(super) fn accepted(&self, ended: &Ended) -> Result<(), Outcome> {
        let code = ended.code()?;
        let meaning = match &self.description().exit {
            Some(meanings) => meaning_or_crashed(meanings.get(&code)),
            None => usual(code),
        };
        self.meant(meaning, ended)
    }

    /// Interprets how a command ended, by the meaning of its exit code.
    fn meant(&self, meaning: Meaning, ended: &Ended) -> Result<(), Outcome> {
        match meaning {
            Meaning::Accepted => Ok(()),
            Meaning::Crashed | Meaning::Faulted(_) => Err(ended.crashed()),
            Meaning::Unsupported => Err(unsupported(locate::first_error(ended))),
            Meaning::NotImplemented => Err(Outcome::NotImplemented {
                reason: locate::first_error(ended),
            }),
            Meaning::Rejected => Err(self.rejected(ended)),
            Meaning::Diagnosed if !self.diagnostics(ended).iter().any(Diagnostic::is_error) => Ok(()),
            Meaning::Diagnosed => Err(self.rejected(ended)),
        }
    }

    /// Returns the warnings in the output of a command that accepts the program.
    fn warnings(&self, ended: &Ended) -> Vec<Diagnostic> {
        let mut diagnostics = self.diagnostics(ended);
        diagnostics.retain(|reported| !reported.is_error());
        diagnostics
    }

    fn diagnostics(&self, ended: &Ended) -> Vec<Diagnostic> {
        let Some(pattern) = &self.description().diagnostic else {
            return Vec::new();
        };
        let text = without_colours(&format!("{}\n{}", ended.stderr, ended.stdout));
        sorted(pattern.0.diagnostics(&text, &self.description().file.0))
    }

    /// Returns the outcome of a command whose exit code means that it rejects the program.
    fn rejected(&self, ended: &Ended) -> Outcome {
        if self.description().diagnostic.is_none() {
            let message = locate::first_error(ended);
            let diagnostics = vec![Diagnostic {
                message,
                ..Diagnostic::default()
            }];
            return Outcome::Rejected { diagnostics };
        }
        let mut diagnostics = self.diagnostics(ended);
        diagnostics.retain(Diagnostic::is_error);
        if diagnostics.is_empty() {
            return match ended.crashed() {
                Outcome::Crashed { reason } => {
                    Outcome::crashed(format!("{reason}; nothing that it wrote fits its `diagnostic`"))
                }
                other => other,
            };
        }
        self.description().codes.outcome(diagnostics)
    }

    /// Returns the limits of a command; `time` is the time limit where the description names none.
    fn limits(&self, time: Option<Duration>) -> ToolLimits {
        let said = self.description().limits;
        let usual = ToolLimits::default();
        let seconds = |seconds: u32| Duration::from_secs(u64::from(seconds));
        let own = match time {
            Some(_) => said.run_seconds,
            None => said.seconds,
        };
        ToolLimits {
            time: own.map(seconds).or(time).unwrap_or(usual.time),
            cpu: said.cpu_seconds.map(seconds).unwrap_or(usual.cpu),
            output: said.output_mib.map_or(usual.output, |size| u64::from(size) << 20),
            memory: said.memory_mib.map_or(usual.memory, |size| u64::from(size) << 20),
        }
    }
}

/// Returns the meaning that the description gives to an exit code, and otherwise [`Meaning::Crashed`].
fn meaning_or_crashed(meaning: Option<&Parsed<Meaning>>) -> Meaning {
    meaning.map_or(Meaning::Crashed, |meaning| meaning.0)
}

/// Returns the meaning of an exit code that the description does not mention.
fn usual(code: i32) -> Meaning {
    match code {
        0 => Meaning::Accepted,
        1 => Meaning::Rejected,
        _ => Meaning::Crashed,
    }
}

/// Returns the rest of the line of a text behind some words; `None` where the text does not have them.
fn behind<'t>(words: &str, text: &'t str) -> Option<&'t str> {
    let (_, rest) = text.split_once(words)?;
    rest.lines().next()
}
