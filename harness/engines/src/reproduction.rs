//! Reproductions: the files and commands by which a person runs a program on a compiler without Stickler.

use crate::adapters::locate::without_colours;
use crate::process::{Folder, ToolLimits, run_tool_with};
use crate::{Ability, Engine, Outcome, RunRequest};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// All that a person needs to run one program on a compiler, with the compiler's own tools only: the program and what stands
/// around it, and the commands. Nothing in it depends on the machine on which it was made.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Reproduction {
    /// The files of the folder in which the commands run. The first is the program.
    pub files: Vec<ReproductionFile>,
    /// The variables of the commands that name programs and folders of the compiler.
    pub tools: Vec<ReproductionTool>,
    /// The commands, for a POSIX shell. Each is run only where the one before it succeeded.
    pub commands: Vec<String>,
}

/// A file of a reproduction.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReproductionFile {
    /// The name of the file, without a folder.
    pub name: String,
    /// The text of the file.
    pub text: String,
}

/// A program or folder of a compiler, which a variable of the shell names.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
        "{0} has no command line of its own: it is part of Stickler, or is asked over the wire protocol alone, and no \
         `reproduce = \"…\"` in stickler.toml says how a person runs it"
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
            Outcome::Unsupported { reason } | Outcome::NotImplemented { reason } => reason,
            other => other.to_string(),
        })
    }
}

/// The name of the file of [`Reproduction::script`].
const SCRIPT: &str = "run.sh";

/// The variable for the folder of `stickler.toml`.
pub(crate) const HERE: &str = "HERE";

impl Reproduction {
    /// Returns the reproduction with each command ended after a number of seconds, for a program that gives no answer.
    pub fn within(mut self, seconds: u64) -> Reproduction {
        for command in &mut self.commands {
            *command = format!("timeout {seconds} {command}");
        }
        if let Some(last) = self.commands.last_mut() {
            *last = format!("{last} || echo \"exit code $? (124: no answer within {seconds} s)\"");
        }
        self
    }

    /// Returns the reproduction by a command that a person states, in which `{file}` stands for the program, `{dialect}` for the name of
    /// its dialect and `{here}` for the folder of `stickler.toml`.
    pub fn by_command(command: &str, request: &RunRequest<'_>) -> Reproduction {
        let file = ReproductionFile {
            name: "program.st".to_owned(),
            text: request.source.to_owned(),
        };
        let here = command.contains("{here}").then(|| ReproductionTool {
            variable: HERE.to_owned(),
            default: ".".to_owned(),
        });
        let command = command.replace("{file}", &file.name);
        let command = command.replace("{dialect}", request.dialect.as_str());
        Reproduction {
            commands: vec![command.replace("{here}", &format!("\"${HERE}\""))],
            files: vec![file],
            tools: here.into_iter().collect(),
        }
    }

    /// Returns the name and text of a shell script that runs the commands in its own folder.
    pub fn script(&self) -> ReproductionFile {
        let mut text = "#!/bin/sh\n".to_owned();
        if !self.tools.is_empty() {
            text.push_str("# Set a variable where a program or folder of the compiler is elsewhere.\n");
        }
        text.push_str(&self.assignments());
        text.push_str("set -e\ncd \"$(dirname \"$0\")\"\n");
        for command in &self.commands {
            text.push_str(&format!("{command}\n"));
        }
        ReproductionFile {
            name: SCRIPT.to_owned(),
            text,
        }
    }

    /// Writes the files and the script into a folder. Returns their names, in the order of [`Reproduction::files`].
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<Vec<String>> {
        let script = self.script();
        let mut names = Vec::with_capacity(self.files.len() + 1);
        for file in self.files.iter().chain([&script]) {
            fs::write(folder.join(&file.name), &file.text)?;
            names.push(file.name.clone());
        }
        executable(&folder.join(SCRIPT))?;
        Ok(names)
    }

    /// Returns the text of a shell that sets the variables and runs the commands in the folder of the files.
    pub fn commands_with_tools(&self) -> String {
        self.assignments() + &self.commands.join(" &&\n")
    }

    fn assignments(&self) -> String {
        let assign = |ReproductionTool { variable, default }: &_| {
            format!("{variable}=\"${{{variable}:-{default}}}\"\n")
        };
        self.tools.iter().map(assign).collect()
    }

    /// Writes everything into a private folder and runs the script there, under the limits that every compiler gets; `tools`
    /// are those of the [engine](Engine::tools).
    ///
    /// # Errors
    /// A fragment that says why the script did not end.
    pub fn run(&self, tools: &[(String, PathBuf)]) -> Result<ScriptOutput, String> {
        let folder = Folder::new()?;
        self.write(folder.path()).map_err(|error| error.to_string())?;
        // One stream keeps the output in the order in which it is printed.
        let arguments = ["-c", "exec sh ./run.sh 2>&1"];
        let limits = ToolLimits::default();
        let ended = run_tool_with(Path::new("sh"), &arguments, folder.path(), &limits, |start| {
            start.envs(tools.iter().map(|(name, path)| (name, path)));
        });
        let ended = ended.map_err(|outcome| outcome.to_string())?;
        let inside = format!("{}/", folder.path().display());
        let text = without_colours(&ended.stdout).replace(&inside, "");
        Ok(ScriptOutput {
            text: without_places(text, tools),
            succeeded: ended.status.success(),
        })
    }
}

/// The result of the commands of a reproduction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptOutput {
    /// The text that the commands printed, without colours and without paths of this machine.
    pub text: String,
    /// Whether every command succeeded.
    pub succeeded: bool,
}

/// Returns a text with the variables of tools in the place of their paths.
fn without_places(mut text: String, tools: &[(String, PathBuf)]) -> String {
    let mut tools: Vec<&(String, PathBuf)> = tools.iter().collect();
    // A folder comes after what lies in it.
    tools.sort_by_key(|(_, path)| std::cmp::Reverse(path.as_os_str().len()));
    for (variable, path) in tools {
        // A path of one name, such as `cc` or `/`, may stand for something else.
        if path.components().count() > 2 {
            text = text.replace(&*path.to_string_lossy(), &format!("${variable}"));
        }
    }
    text
}

/// Reproduces a request on an engine that is here, and runs the commands. What the compiler alone rejects, or crashes at, is
/// shown by the compiler alone, without what an execution needs. The second value says what the commands printed, or why they
/// did not end.
///
/// # Errors
/// As [`Engine::reproduce`].
pub fn reproduce_and_run(
    engine: &dyn Engine,
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<(Reproduction, Result<ScriptOutput, String>), NoReproduction> {
    let run = |ability| {
        let reproduction = engine.reproduce(request, ability)?;
        let output = reproduction.run(&engine.tools());
        Ok((reproduction, output))
    };
    if matches!(ability, Ability::Execute | Ability::Scans) {
        let (reproduction, output) = run(Ability::Check)?;
        if !output.as_ref().is_ok_and(|output| output.succeeded) {
            return Ok((reproduction, output));
        }
    }
    run(ability)
}

#[cfg(unix)]
fn executable(script: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(script, fs::Permissions::from_mode(0o755))
}

/// Does nothing: on systems other than Unix the name of a file says whether it can be started.
#[cfg(not(unix))]
fn executable(_: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_path_of_this_machine_is_in_what_a_script_printed() {
        let tools = [("LIB", "/opt/st/lib"), ("ST", "/opt/st"), ("CC", "/cc")];
        let tools = tools.map(|(variable, path)| (variable.to_owned(), PathBuf::from(path)));
        let text = "/opt/st/lib/a.h:3: error in /opt/st/bin, not in /cc".to_owned();
        let printed = without_places(text, &tools);
        assert_eq!(printed, "$LIB/a.h:3: error in $ST/bin, not in /cc");
    }

    #[test]
    fn the_script_names_its_tools_first_and_runs_where_it_stands() {
        let tool = ReproductionTool {
            variable: "STC".to_owned(),
            default: "stc".to_owned(),
        };
        let reproduction = Reproduction {
            files: Vec::new(),
            tools: vec![tool],
            commands: vec!["\"$STC\" program.st".to_owned(), "echo done".to_owned()],
        };
        let script = reproduction.script();
        assert_eq!(script.name, "run.sh");
        assert_eq!(
            script.text,
            "#!/bin/sh\n# Set a variable where a program or folder of the compiler is elsewhere.\n\
             STC=\"${STC:-stc}\"\nset -e\ncd \"$(dirname \"$0\")\"\n\"$STC\" program.st\n\
             echo done\n"
        );
    }
}
