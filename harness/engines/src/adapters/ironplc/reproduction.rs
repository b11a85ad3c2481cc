//! Writes what a person needs to run a program with `ironplcc` and `ironplcvm` alone.

use super::readback::{Readbacks, RunHints};
use super::{COMPILER, MACHINE, dialect_name};
use crate::adapters::probe_variable::with_shown_probes;
use crate::adapters::source::main_program;
use crate::reproduction::PROGRAM;
use crate::{Ability, NoReproduction, Reproduction, RunRequest};
use std::collections::BTreeSet;

/// Returns the reproduction of a request.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the adapter would not run the program either.
pub(in crate::adapters) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    let dialect = dialect_name(request.dialect)?;
    let compiler = COMPILER.shell_variable();
    let on = |program: String| Reproduction::of(PROGRAM, program).tool(compiler, COMPILER.name);
    let compile = format!("\"${compiler}\" compile --dialect {dialect} {PROGRAM} -o program.iplc");
    match (ability, main_program(request.source)) {
        (Ability::Render, _) => Ok(on(request.source.to_owned())
            .command(format!("\"${compiler}\" echo --dialect {dialect} {PROGRAM}"))),
        (Ability::Execute | Ability::Scans, Some(main)) => {
            super::takes_no_settings(request)?;
            let readbacks = Readbacks::of(request, RunHints::default());
            let program = with_shown_probes(request, &main, readbacks.probes())?;
            let machine = MACHINE.shell_variable();
            let compiled = on(program).tool(machine, MACHINE.name).command(compile);
            let runs = scans(request);
            Ok(runs.iter().fold(compiled, |reproduction, scans| {
                let reproduction = match runs.len() {
                    1 => reproduction,
                    _ => reproduction.command(format!("echo 'After scan {scans}:'")),
                };
                reproduction.command(format!(
                    "\"${machine}\" run program.iplc --scans {scans} --dump-vars"
                ))
            }))
        }
        (Ability::Check, _) | (_, None) => Ok(on(request.source.to_owned()).command(compile).accepted()),
    }
}

/// Returns the scans after which values are observed, each of which the machine is run for anew.
fn scans(request: &RunRequest<'_>) -> BTreeSet<u32> {
    let observed = request.observe.iter();
    let observed = observed.map(|asked| asked.after.unwrap_or(request.scans));
    observed.chain([request.scans]).collect()
}
