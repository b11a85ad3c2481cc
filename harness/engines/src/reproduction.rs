//! Reproductions: the files and commands by which a person runs a program on a compiler without Stickler.

use crate::{Outcome, shell_quote};
use std::fmt::Write;

/// All that a person needs to run one program on a compiler, with the compiler's own tools only: the program and what stands
/// around it, and the commands. Nothing in it depends on the machine on which it was made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Reproduction {
    /// The files of the folder in which the commands run. The first is the program.
    pub files: Vec<ReproductionFile>,
    /// The variables of the commands that name programs and folders of the compiler.
    pub tools: Vec<ReproductionTool>,
    /// The commands, for a POSIX shell. Each is run only where the one before it succeeded.
    pub commands: Vec<String>,
}

/// A file of a reproduction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReproductionFile {
    /// The name of the file, without a folder.
    pub name: String,
    /// The text of the file.
    pub text: String,
}

/// A program or folder of a compiler, which a variable of the shell names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReproductionTool {
    /// The name of the variable, such as `IEC2C`.
    pub variable: String,
    /// The value where the variable is not set, as a shell expands it between double quotes.
    pub default: String,
}

/// The reason why there is no reproduction of a program on an engine.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NoReproduction {
    /// The engine is no compiler whose command line Stickler knows; holds its name.
    #[error(
        "{0} has no command line of its own: it is part of Stickler, or is asked over the wire protocol alone"
    )]
    NoTools(String),
    /// The compiler cannot do what the program needs; holds the reason, as a fragment.
    #[error("{0}")]
    Unsupported(String),
}

impl From<String> for NoReproduction {
    fn from(reason: String) -> NoReproduction {
        NoReproduction::Unsupported(reason)
    }
}

impl From<Outcome> for NoReproduction {
    fn from(outcome: Outcome) -> NoReproduction {
        NoReproduction::Unsupported(match outcome {
            Outcome::Unsupported { reason } => reason,
            other => other.to_string(),
        })
    }
}

/// The name of the file of the program.
pub(crate) const PROGRAM: &str = "program.st";

/// The name of the file of [`Reproduction::script`].
const SCRIPT: &str = "run.sh";

impl Reproduction {
    /// Returns a reproduction that has only a program and no commands yet.
    pub(crate) fn of(name: &str, program: String) -> Reproduction {
        Reproduction {
            files: Vec::new(),
            tools: Vec::new(),
            commands: Vec::new(),
        }
        .file(name, program)
    }

    /// Adds a file.
    pub(crate) fn file(mut self, name: &str, text: String) -> Reproduction {
        self.files.push(ReproductionFile {
            name: name.to_owned(),
            text,
        });
        self
    }

    /// Adds a program or folder, by the variable that names it and its usual value.
    pub(crate) fn tool(mut self, variable: &str, default: &str) -> Reproduction {
        self.tools.push(ReproductionTool {
            variable: variable.to_owned(),
            default: default.to_owned(),
        });
        self
    }

    /// Adds a command.
    pub(crate) fn command(mut self, command: impl Into<String>) -> Reproduction {
        self.commands.push(command.into());
        self
    }

    /// Adds the command that says that a program was accepted, for compilers that say nothing then.
    pub(crate) fn accepted(self) -> Reproduction {
        self.command("echo 'The program is accepted.'")
    }

    /// Returns the name and text of a shell script that runs the commands in its own folder.
    #[must_use]
    pub fn script(&self) -> ReproductionFile {
        let mut text = "#!/bin/sh\n".to_owned();
        if !self.tools.is_empty() {
            text.push_str("# Set a variable where a program or folder of the compiler is elsewhere.\n");
        }
        for ReproductionTool { variable, default } in &self.tools {
            // Writing into a String does not fail.
            let _ = writeln!(text, "{variable}=\"${{{variable}:-{default}}}\"");
        }
        text.push_str("set -e\ncd \"$(dirname \"$0\")\"\n");
        for command in &self.commands {
            let _ = writeln!(text, "{command}");
        }
        ReproductionFile {
            name: SCRIPT.to_owned(),
            text,
        }
    }
}

/// Joins words to a command of a POSIX shell.
pub(crate) fn command_line<'w>(words: impl IntoIterator<Item = &'w str>) -> String {
    let words: Vec<_> = words.into_iter().map(shell_quote).collect();
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_script_names_its_tools_first_and_runs_where_it_stands() {
        let reproduction = Reproduction::of(PROGRAM, "PROGRAM main END_PROGRAM\n".to_owned())
            .tool("STC", "stc")
            .command("\"$STC\" program.st")
            .accepted();
        let script = reproduction.script();
        assert_eq!(script.name, "run.sh");
        assert_eq!(
            script.text,
            "#!/bin/sh\n# Set a variable where a program or folder of the compiler is elsewhere.\n\
             STC=\"${STC:-stc}\"\nset -e\ncd \"$(dirname \"$0\")\"\n\"$STC\" program.st\n\
             echo 'The program is accepted.'\n"
        );
    }
}
