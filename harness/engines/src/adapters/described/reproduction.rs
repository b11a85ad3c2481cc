//! Writes what a person needs to run a program with the commands of a table.

use super::description::{Commands, Description, Parsed};
use super::takes_scans;
use super::template::{CallValues, HERE};
use crate::adapters::command::CommandTemplate;
use crate::adapters::locate::speaks_not;
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::recipe::Recipe;
use crate::adapters::settings::{with_settings, written};
use crate::adapters::source::{main_program, observed_scans};
use crate::engine::no_rendering;
use crate::{Ability, NoReproduction, Reproduction, ReproductionTool, RunRequest, shell_quote};
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
        let text = with_settings(request);
        let request = &written(request, text.as_ref());
        let script = |program: &str, commands: &[_], last: &dyn Fn(Recipe) -> Recipe| {
            Ok(self.script((request.dialect, dialect), program, commands, last))
        };
        match (ability, &self.run, main_program(request)) {
            (Ability::Render, ..) => {
                let render = self.render.as_ref().ok_or_else(no_rendering)?;
                script(request.source, &[(&render.0, 0)], &|recipe| recipe)
            }
            (Ability::Execute | Ability::Scans, Some(run), Some(main)) => {
                takes_scans(&run.0, request)?;
                let probes = ProbeVariables::of(request);
                let program = with_shown_probes(request, &main, probes.list())?;
                let mut commands = templates(self.compile.as_ref());
                commands.extend(observed_scans(request).into_iter().map(|scan| (&run.0, scan)));
                script(&program, &commands, &|recipe| recipe.legend(probes.list()))
            }
            _ => {
                let check = self.check.as_ref().or(self.compile.as_ref());
                let mut commands = templates(check);
                if check.is_none() {
                    // A compiler that only runs programs accepts a program by running it.
                    commands.extend(self.run.iter().map(|run| (&run.0, 1)));
                }
                script(request.source, &commands, &Recipe::accepted)
            }
        }
    }

    /// Returns the reproduction that gives a program to commands, each with its number of scans, with the `last` command;
    /// `dialect` is the compiler's own word.
    fn script(
        &self,
        (name, dialect): (DialectName, &str),
        program: &str,
        commands: &[(&CommandTemplate, u32)],
        last: &dyn Fn(Recipe) -> Recipe,
    ) -> Reproduction {
        let file = &self.file.0;
        let mut recipe = Recipe::of(file, self.whole(name, program));
        for (name, value) in &self.environment {
            recipe = recipe.shell(&[], format!("export {name}={}", shell_quote(value)));
        }
        let mut tools: Vec<ReproductionTool> = Vec::new();
        for (command, scans) in commands {
            let values = CallValues {
                file,
                dialect,
                folder: Path::new("."),
                scans: *scans,
                here: Path::new(""),
            };
            let (program, arguments) = program_and_arguments(command, &values);
            let mut used: Vec<String> = Vec::new();
            let called = match program.starts_with("./") {
                true => program,
                false => {
                    let tool = ReproductionTool {
                        variable: variable(&program),
                        default: program,
                    };
                    let called = format!("\"${}\"", tool.variable);
                    used.push(tool.variable.clone());
                    if tools.iter().all(|known| known.variable != tool.variable) {
                        tools.push(tool);
                    }
                    called
                }
            };
            if command.placeholders_of_arguments().any(|name| name == "here") {
                used.push(HERE.to_owned());
            }
            recipe = recipe.shell(&used, format!("{called} {arguments}"));
        }
        tools.push(ReproductionTool {
            variable: HERE.to_owned(),
            default: ".".to_owned(),
        });
        last(recipe).reproduction(tools)
    }
}

/// Returns the name of a program, behind `./` where an earlier command makes it, and the arguments, as a shell gets them.
fn program_and_arguments(command: &CommandTemplate, values: &CallValues<'_>) -> (String, String) {
    let program = command.filled(&|name| values.of(name)).0;
    let name = program.file_name().unwrap_or_default().to_string_lossy();
    let is_made = command.placeholders_of_program().any(|name| name == "folder");
    let program = match is_made {
        true => format!("./{}", shell_quote(&name)),
        false => name.into_owned(),
    };
    (program, command.for_shell(&|name| values.of(name)).1)
}

/// Returns commands that make no scans.
fn templates(commands: Option<&Commands>) -> Vec<(&CommandTemplate, u32)> {
    let commands = commands.iter().flat_map(|commands| &commands.0);
    commands.map(|Parsed(template)| (template, 0)).collect()
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
