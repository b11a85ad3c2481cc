//! Reproductions on compilers that translate a program to C, C++ or an object file: a driver runs the result.

use super::builder::Language;
use super::source::{MainProgram, main_program};
use crate::engine::no_rendering;
use crate::reproduction::command_line;
use crate::{Ability, NoReproduction, Reproduction, RunRequest};

/// Returns the reproduction of a request: `execution` where the main program is run, otherwise `translation` of the program as it
/// is.
///
/// # Errors
/// [`NoReproduction::Unsupported`] for a rendering, and where `execution` says so.
pub(super) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
    translation: impl FnOnce(String) -> Reproduction,
    execution: impl FnOnce(&MainProgram) -> Result<Reproduction, NoReproduction>,
) -> Result<Reproduction, NoReproduction> {
    match (ability, main_program(request)) {
        (Ability::Render, _) => Err(no_rendering().into()),
        (Ability::Execute | Ability::Scans, Some(main)) => execution(&main),
        (Ability::Check, _) | (_, None) => Ok(translation(request.source.to_owned()).accepted()),
    }
}

impl Reproduction {
    /// Adds a driver, and the commands that build and run it. `inputs` are the driver and what is compiled with it, with the
    /// folders of headers before them; `libraries` is what it is linked with.
    pub(super) fn driver(
        self,
        language: Language,
        text: String,
        inputs: &str,
        libraries: &str,
    ) -> Reproduction {
        let compiler = language.compiler();
        let variable = compiler.shell_variable();
        let options = command_line(language.options().iter().copied());
        let build = format!("\"${variable}\" {options} {inputs} -o driver {libraries}");
        self.tool(variable, compiler.name)
            .file(language.driver(), text)
            .command(build.trim_end())
            .command("./driver")
    }
}
