//! Which recipe reproduces a request on a compiler that translates a program to C, C++ or an object file.

use super::recipe::Recipe;
use super::source::{MainProgram, main_program};
use crate::engine::no_rendering;
use crate::{Ability, NoReproduction, RunRequest};

/// Returns the recipe that reproduces a request: `execution` where the main program is run, otherwise `translation` of the program
/// as it is.
///
/// # Errors
/// [`NoReproduction::Unsupported`] for a rendering, and where `execution` says so.
pub(super) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
    translation: impl FnOnce(String) -> Recipe,
    execution: impl FnOnce(&MainProgram) -> Result<Recipe, NoReproduction>,
) -> Result<Recipe, NoReproduction> {
    match (ability, main_program(request)) {
        (Ability::Render, _) => Err(no_rendering().into()),
        (Ability::Execute | Ability::Scans, Some(main)) => execution(&main),
        (Ability::Check, _) | (_, None) => Ok(translation(request.source.to_owned()).accepted()),
    }
}
