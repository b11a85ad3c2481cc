//! Writes what a person needs to run a program with the commands of a table.

use super::description::{Commands, Description, Parsed};
use super::template::{CommandTemplate, Filling, HERE, ShellCommand};
use super::{scans, takes_scans};
use crate::adapters::locate::speaks_not;
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::source::main_program;
use crate::engine::no_rendering;
use crate::{Ability, NoReproduction, Reproduction, RunRequest, shell_quote};
use std::path::Path;
use stickler_types::DialectName;

impl Description {
    /// Returns the files and commands by which a person runs a program on this compiler without Stickler. The compiler need not
    /// be on this machine.
    ///
    /// # Errors
    /// [`NoReproduction::Unsupported`] where the engine would not run the program either.
    pub fn reproduce(
        &self,
        request: &RunRequest<'_>,
        ability: Ability,
    ) -> Result<Reproduction, NoReproduction> {
        let dialect = self.word(request.dialect);
        let dialect = dialect.ok_or_else(|| speaks_not(request.dialect))?;
        match (ability, &self.run, main_program(request)) {
            (Ability::Render, ..) => {
                let render = self.render.as_ref().ok_or_else(no_rendering)?;
                Ok(self.script((request.dialect, dialect), request.source, &[(&render.0, 0)]))
            }
            (Ability::Execute | Ability::Scans, Some(run), Some(main)) => {
                takes_scans(&run.0, request)?;
                let probes = ProbeVariables::of(request);
                let program = with_shown_probes(request, &main, probes.list())?;
                let mut commands = templates(self.compile.as_ref());
                commands.extend(scans(request).into_iter().map(|scan| (&run.0, scan)));
                Ok(self
                    .script((request.dialect, dialect), &program, &commands)
                    .legend(probes.list()))
            }
            _ => {
                let check = self.check.as_ref().or(self.compile.as_ref());
                let mut commands = templates(check);
                if check.is_none() {
                    // A compiler that only runs programs accepts a program by running it.
                    commands.extend(self.run.iter().map(|run| (&run.0, 1)));
                }
                Ok(self
                    .script((request.dialect, dialect), request.source, &commands)
                    .accepted())
            }
        }
    }

    /// Returns the reproduction that gives a program to commands, each with its number of scans; `dialect` is the compiler's own
    /// word.
    fn script(
        &self,
        (name, dialect): (DialectName, &str),
        program: &str,
        commands: &[(&CommandTemplate, u32)],
    ) -> Reproduction {
        let file = &self.file.0;
        let mut reproduction = Reproduction::of(file, self.whole(name, program));
        for (name, value) in &self.environment {
            reproduction = reproduction.command(format!("export {name}={}", shell_quote(value)));
        }
        for (template, scans) in commands {
            let command = template.for_shell(&Filling {
                file,
                dialect,
                folder: Path::new("."),
                scans: *scans,
                here: Path::new(""),
            });
            reproduction = with(reproduction, &command);
        }
        reproduction
    }
}

/// Returns commands that make no scans.
fn templates(commands: Option<&Commands>) -> Vec<(&CommandTemplate, u32)> {
    let commands = commands.iter().flat_map(|commands| &commands.0);
    commands.map(|Parsed(template)| (template, 0)).collect()
}

/// Adds a command, and the variables that name its program and the folder of `stickler.toml`.
fn with(mut reproduction: Reproduction, command: &ShellCommand) -> Reproduction {
    let ShellCommand { program, arguments } = command;
    let mut called = shell_quote(program).into_owned();
    if !program.contains('/') {
        let variable = variable(program);
        called = format!("\"${variable}\"");
        reproduction = reproduction.tool(&variable, program);
    }
    if arguments.contains(&format!("\"${HERE}\"")) {
        reproduction = reproduction.tool(HERE, ".");
    }
    reproduction.command(format!("{called} {arguments}").trim_end().to_owned())
}

/// Returns the name of the variable for the program of a path.
pub(super) fn program_variable(path: &Path) -> String {
    variable(&path.file_stem().unwrap_or_default().to_string_lossy())
}

/// Returns the name of the variable for a program.
fn variable(program: &str) -> String {
    let letter = |letter: char| match letter {
        letter if letter.is_ascii_alphanumeric() => letter.to_ascii_uppercase(),
        _ => '_',
    };
    let name: String = program.chars().map(letter).collect();
    match name.starts_with(|first: char| first.is_ascii_digit()) {
        true => format!("_{name}"),
        false => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Observation;

    const TABLE: &str = "compile = [\"bin/my-st --target '{folder}' {file} -o {folder}/out\", 'cc {folder}/out.c']\n\
                         run = '{folder}/out -n{scans} --library {here}/lib'\n\
                         value = '^(?<name>\\w+) = (?<value>.*)$'\nfile = 'p.st'\nappend = 'USE {program}'\n\
                         environment = { ST_HOME = \"it's\" }\ndialects = { matiec = '' }\n";

    #[test]
    fn the_commands_of_a_table_become_those_of_a_script() {
        let description: Description = toml::from_str(TABLE).unwrap();
        let observe = [Observation::last("a[1]", "INT")];
        let source = "PROGRAM main\n  ;\nEND_PROGRAM\n";
        let request = RunRequest {
            scans: 3,
            ..RunRequest::once(DialectName::MATIEC, source, &observe)
        };
        let shown = description.reproduce(&request, Ability::Execute).unwrap();
        assert_eq!(shown.files[0].name, "p.st");
        assert!(shown.files[0].text.ends_with("\nUSE main"), "{shown:?}");
        assert_eq!(
            shown.commands,
            [
                r"export ST_HOME='it'\''s'",
                "\"$MY_ST\" --target . p.st -o ./out",
                "\"$CC\" ./out.c",
                "./out -n3 --library \"$HERE\"/lib",
                "echo 'stickler_probe_0 is a[1]'",
            ]
        );
        let tools = shown.tools.iter().map(|tool| (&*tool.variable, &*tool.default));
        assert!(tools.eq([("MY_ST", "my-st"), ("CC", "cc"), ("HERE", ".")]));
        let checked = description.reproduce(&request, Ability::Check).unwrap();
        assert_eq!(checked.commands.len(), 4);
        for (dialect, ability) in [
            (DialectName::PLCNEXT, Ability::Check),
            (DialectName::MATIEC, Ability::Render),
        ] {
            let request = RunRequest { dialect, ..request };
            assert!(description.reproduce(&request, ability).is_err());
        }
    }
}
