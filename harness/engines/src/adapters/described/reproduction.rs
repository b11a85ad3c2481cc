//! Writes what a person needs to run a program with the commands of a table.

use super::description::{Commands, Description, Parsed};
use super::template::{Filling, HERE, ShellCommand, Template};
use super::{no_rendering, scans, takes_scans};
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::source::main_program;
use crate::{Ability, NoReproduction, Reproduction, RunRequest, shell_quote};
use std::path::Path;

/// Returns the reproduction of a request; `dialect` is the compiler's own word.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the engine would not run the program either.
pub(super) fn reproduce(
    description: &Description,
    dialect: &str,
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    let script = Script { description, dialect };
    match (ability, &description.run, main_program(request.source)) {
        (Ability::Render, ..) => {
            let render = description.render.as_ref().ok_or_else(no_rendering)?;
            Ok(script.on(request.source, &[(&render.0, 0)]))
        }
        (Ability::Execute | Ability::Scans, Some(run), Some(main)) => {
            takes_scans(&run.0, request)?;
            let probes = ProbeVariables::of(request);
            let program = with_shown_probes(request, &main, probes.list())?;
            let mut commands = templates(description.compile.as_ref());
            commands.extend(scans(request).into_iter().map(|scan| (&run.0, scan)));
            Ok(script.on(&program, &commands))
        }
        _ => {
            let check = description.check.as_ref().or(description.compile.as_ref());
            let mut commands = templates(check);
            if check.is_none() {
                commands.extend(description.run.iter().map(|run| (&run.0, 1)));
            }
            Ok(script.on(request.source, &commands).accepted())
        }
    }
}

/// Returns commands that make no scans.
fn templates(commands: Option<&Commands>) -> Vec<(&Template, u32)> {
    let commands = commands.iter().flat_map(|commands| &commands.0);
    commands.map(|Parsed(template)| (template, 0)).collect()
}

/// The reproductions of one compiler and dialect.
struct Script<'d> {
    description: &'d Description,
    dialect: &'d str,
}

impl Script<'_> {
    /// Returns the reproduction that gives a program to commands, each with its number of scans.
    fn on(&self, program: &str, commands: &[(&Template, u32)]) -> Reproduction {
        let file = &self.description.file.0;
        let mut reproduction = Reproduction::of(file, self.description.whole(program));
        for (name, value) in &self.description.environment {
            reproduction = reproduction.command(format!("export {name}={}", shell_quote(value)));
        }
        for (template, scans) in commands {
            let command = template.for_shell(&Filling {
                file,
                dialect: self.dialect,
                folder: Path::new("."),
                scans: *scans,
                here: Path::new(""),
            });
            reproduction = with(reproduction, &command);
        }
        reproduction
    }
}

/// Adds a command, and the variables that name its program and the folder of `stickler.toml`.
fn with(mut reproduction: Reproduction, command: &ShellCommand) -> Reproduction {
    let ShellCommand { program, arguments } = command;
    let mut called = shell_quote(program).into_owned();
    if !program.contains('/') {
        let variable = variable(program);
        called = format!("\"${variable}\"");
        if reproduction.tools.iter().all(|tool| tool.variable != variable) {
            reproduction = reproduction.tool(&variable, program);
        }
    }
    if arguments.contains(&format!("\"${HERE}\""))
        && reproduction.tools.iter().all(|tool| tool.variable != HERE)
    {
        reproduction = reproduction.tool(HERE, ".");
    }
    reproduction.command(format!("{called} {arguments}").trim_end().to_owned())
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
