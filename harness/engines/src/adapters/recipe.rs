//! Recipes: the files and commands by which a compiler is given a program.
//!
//! An adapter says them once. A [`Workplace`] executes them with the tools of this machine, and a [`Reproduction`] prints them for
//! a person, who has the same tools somewhere else.

use super::Compiler;
use super::command::{CommandTemplate, Fill, Filling};
use super::dependencies::Dependency;
use super::driver::DriverText;
use super::locate::{EXECUTION_TIMEOUT, failed, session_folder};
use super::probe_variable::ProbeVariable;
use crate::process::{Ended, Folder, ToolLimits, run_tool_with};
use crate::reproduction::{ReproductionFile, ReproductionTool};
use crate::{EngineError, Identity, Outcome, Reproduction, shell_quote};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// The name of the file of a program.
pub(super) const PROGRAM: &str = "program.st";

/// The purpose of a step of a recipe.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Purpose {
    /// The compiler under test reads the program.
    Translate,
    /// A C or C++ compiler builds what the compiler under test wrote, together with a driver.
    Build,
    /// The program is executed for this number of scans, or the number that its driver has.
    Execute(Option<u32>),
}

/// The files and commands by which a compiler is given a program. Commands have the variables of [tools](Dependency) as
/// placeholders.
#[derive(Clone, Debug, Default)]
pub(super) struct Recipe {
    files: Vec<ReproductionFile>,
    /// The files that the steps make, which an earlier program may have left behind.
    made: &'static [&'static str],
    steps: Vec<(Purpose, CommandTemplate)>,
    /// The steps as a shell gets them.
    pub(super) shown: Vec<String>,
    /// The variables of the steps, in order.
    variables: Vec<String>,
}

impl Recipe {
    /// Returns a recipe that has only a program and no steps yet.
    pub(super) fn of(name: &str, program: impl Into<String>) -> Recipe {
        Recipe::default().file(name, program)
    }

    /// Adds a file.
    pub(super) fn file(mut self, name: &str, text: impl Into<String>) -> Recipe {
        self.files.push(ReproductionFile {
            name: name.to_owned(),
            text: text.into(),
        });
        self
    }

    /// Names files that the steps make.
    pub(super) fn makes(mut self, files: &'static [&'static str]) -> Recipe {
        self.made = files;
        self
    }

    /// Adds the step of a command of a compiler, with values for what its adapter fills in.
    pub(super) fn step(
        self,
        compiler: Compiler,
        purpose: Purpose,
        command: &str,
        values: &[(&str, &str)],
    ) -> Recipe {
        let data = compiler.data();
        self.line(&data.tools, purpose, &data.command(command, values))
    }

    /// Adds the step of a line whose placeholders are variables of these tools.
    pub(super) fn line(self, tools: &[Dependency], purpose: Purpose, line: &str) -> Recipe {
        let variables: Vec<&str> = tools.iter().map(Dependency::shell_variable).collect();
        // A test splits each line of each compiler.
        let command = CommandTemplate::parse(line, &variables).unwrap_or_default();
        let used: Vec<String> = command.placeholders().map(str::to_owned).collect();
        let fill = |name: &str| {
            let variable = variables.iter().find(|variable| **variable == name);
            Filling::Variable(variable.copied().unwrap_or_default(), Path::new(""))
        };
        let (program, arguments) = command.for_shell(&fill);
        let shown = format!("{program} {arguments}");
        let shown = tools.iter().fold(shown, |shown, tool| tool.in_script(shown));
        let mut recipe = self.shell(&used, shown);
        recipe.steps.push((purpose, command));
        recipe
    }

    /// Adds a command that only a person types, with the variables that it has.
    pub(super) fn shell(mut self, variables: &[String], command: impl Into<String>) -> Recipe {
        for variable in variables {
            if !self.variables.contains(variable) {
                self.variables.push(variable.clone());
            }
        }
        self.shown.push(command.into().trim_end().to_owned());
        self
    }

    /// Adds a driver, and the commands that build it and run it.
    pub(super) fn driver(self, compiler: Compiler, driver: &DriverText, values: &[(&str, &str)]) -> Recipe {
        self.file(driver.file, driver.text.clone())
            .step(compiler, Purpose::Build, "build", values)
            .line(&[], Purpose::Execute(None), "./driver")
    }

    /// Adds the command that says that a program was accepted, for compilers that say nothing then.
    pub(super) fn accepted(self) -> Recipe {
        self.shell(&[], "echo 'The program is accepted.'")
    }

    /// Adds the command that says what the probe variables of a program stand for at its end, where its values are printed by
    /// their names: those that keep an initial value stand for nothing, those that take several values in turn for the last.
    pub(super) fn legend(self, probes: &[ProbeVariable]) -> Recipe {
        let stands = |(at, probe): (usize, &ProbeVariable)| {
            let is_last = probes[at + 1..].iter().all(|later| later.name != probe.name);
            let stands = format!("{} is {}", probe.name, probe.expression);
            (is_last && !probe.expression.is_empty()).then_some(stands)
        };
        let stand: Vec<String> = probes.iter().enumerate().filter_map(stands).collect();
        match stand.is_empty() {
            true => self,
            false => self.shell(&[], format!("echo {}", shell_quote(&stand.join(", ")))),
        }
    }

    /// Returns the steps as a person types them into a shell.
    pub(super) fn commands(self) -> Vec<String> {
        self.shown
    }

    /// Returns what a person needs to follow the recipe on a compiler.
    pub(super) fn on(self, compiler: Compiler) -> Reproduction {
        self.reproduction(compiler.data().tools.iter().map(Dependency::usual))
    }

    /// Returns what a person needs to follow the recipe; `tools` are all variables, in the order in which a script sets those
    /// that it needs.
    pub(super) fn reproduction(self, tools: impl IntoIterator<Item = ReproductionTool>) -> Reproduction {
        let needed = |tool: &ReproductionTool| self.variables.contains(&tool.variable);
        Reproduction {
            tools: tools.into_iter().filter(needed).collect(),
            files: self.files,
            commands: self.shown,
        }
    }
}

/// The tools of a compiler on this machine, by the variables of scripts.
pub(super) type Tools = Vec<(String, PathBuf)>;

/// A folder in which recipes are executed, with the tools of this machine.
pub(super) struct Workplace<'t> {
    pub(super) folder: Folder,
    tools: &'t Tools,
}

impl<'t> Workplace<'t> {
    /// Makes the workplace of a session of an engine.
    ///
    /// # Errors
    /// [`EngineError::NotStarted`] where its folder cannot be created.
    pub(super) fn new(engine: &Identity, tools: &'t Tools) -> Result<Workplace<'t>, EngineError> {
        Ok(Workplace {
            folder: session_folder(engine)?,
            tools,
        })
    }

    /// Makes a workplace beside those of sessions.
    ///
    /// # Errors
    /// A fragment that says why its folder cannot be created.
    pub(super) fn with(tools: &'t Tools) -> Result<Workplace<'t>, String> {
        let folder = Folder::new()?;
        Ok(Workplace { folder, tools })
    }

    /// Returns another workplace with the same tools.
    ///
    /// # Errors
    /// A fragment that says why its folder cannot be created.
    pub(super) fn elsewhere(&self) -> Result<Workplace<'t>, String> {
        Workplace::with(self.tools)
    }

    /// Writes the files of a recipe, in place of those of an earlier one.
    ///
    /// # Errors
    /// [`Outcome::Error`] where a file cannot be written.
    pub(super) fn begin(&self, recipe: &Recipe) -> Result<(), Outcome> {
        for made in recipe.made {
            // What an earlier program left behind must not be taken for that of this one.
            let _ = std::fs::remove_file(self.folder.path().join(made));
        }
        for file in &recipe.files {
            self.folder.write(&file.name, &file.text).map_err(failed)?;
        }
        Ok(())
    }

    /// Executes the step of a recipe that is for this, with further arguments, under the limits that every compiler and every
    /// execution gets.
    ///
    /// # Errors
    /// An outcome as [`run_tool_with`] returns; [`Outcome::Error`] where the recipe has no such step.
    pub(super) fn step(
        &self,
        recipe: &Recipe,
        purpose: Purpose,
        further: &[&OsStr],
    ) -> Result<Ended, Outcome> {
        let found = recipe.steps.iter().find(|(of, _)| *of == purpose);
        let (_, command) = found.ok_or_else(|| failed(format!("there is no step {purpose:?}")))?;
        let usual = ToolLimits::default();
        let limits = match purpose {
            Purpose::Execute(_) => ToolLimits {
                time: EXECUTION_TIMEOUT,
                ..usual
            },
            _ => usual,
        };
        // Where a program written in Rust panics, its message is worth more than the backtrace.
        let environment = [("RUST_BACKTRACE", "0")];
        let fill: &Fill<'_> = &|name| {
            let tool = self.tools.iter().find(|(variable, _)| variable == name);
            Filling::Variable("", tool.map_or(Path::new(""), |(_, path)| path))
        };
        let (program, mut arguments) = command.filled(fill);
        // A program that a step makes is in the folder.
        let program = match program.strip_prefix(".") {
            Ok(made) => self.folder.path().join(made),
            Err(_) => program,
        };
        arguments.extend(further.iter().map(Into::into));
        run_tool_with(&program, &arguments, self.folder.path(), &limits, |start| {
            start.envs(environment);
        })
    }
}
