//! Writes what a person needs to run a program with `ironplcc` and `ironplcvm` alone.

use super::readback::{Readbacks, RunHints};
use super::{COMPILER, MACHINE, options};
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
    let dialect = options(request.dialect)?.join(" ");
    let compiler = COMPILER.shell_variable();
    let on = |program: String| Reproduction::of(PROGRAM, program).tool(compiler, COMPILER.name);
    let compile = format!("\"${compiler}\" compile --dialect {dialect} {PROGRAM} -o program.iplc");
    match (ability, main_program(request)) {
        (Ability::Render, _) => Ok(on(request.source.to_owned())
            .command(format!("\"${compiler}\" echo --dialect {dialect} {PROGRAM}"))),
        (Ability::Execute | Ability::Scans, Some(main)) => {
            super::takes_no_settings(request)?;
            let readbacks = Readbacks::of(request, RunHints::default());
            let program = with_shown_probes(request, &main, readbacks.probes())?;
            let machine = MACHINE.shell_variable();
            let compiled = on(program)
                .tool(machine, MACHINE.name)
                .command(compile)
                .legend(readbacks.probes());
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClockSetting, Observation};
    use stickler_types::DialectName;

    const SOURCE: &str = "PROGRAM main\nVAR\n  a : ARRAY[1..2] OF INT;\nEND_VAR\n  a[1] := 7;\nEND_PROGRAM\n";

    #[test]
    fn the_machine_runs_once_for_each_scan_that_is_observed() {
        let observe = [1, 3].map(|scan| Observation {
            after: Some(scan),
            ..Observation::last("a[1]", "INT")
        });
        let request = RunRequest {
            scans: 3,
            ..RunRequest::once(DialectName::IRONPLC_ED2, SOURCE, &observe)
        };
        let shown = reproduce(&request, Ability::Execute).unwrap();
        assert_eq!(
            shown.commands,
            [
                "\"$IRONPLCC\" compile --dialect iec61131-3-ed2 program.st -o program.iplc",
                "echo 'stickler_probe_0 is a[1]'",
                "echo 'After scan 1:'",
                "\"$IRONPLCVM\" run program.iplc --scans 1 --dump-vars",
                "echo 'After scan 3:'",
                "\"$IRONPLCVM\" run program.iplc --scans 3 --dump-vars",
            ]
        );
        let rendered = reproduce(&request, Ability::Render).unwrap();
        assert_eq!(rendered.files[0].text, SOURCE);
        assert_eq!(
            rendered.commands,
            ["\"$IRONPLCC\" echo --dialect iec61131-3-ed2 program.st"]
        );
    }

    #[test]
    fn what_the_adapter_does_not_run_has_no_reproduction() {
        let clock = [ClockSetting {
            before: 1,
            nanoseconds: 5,
        }];
        let request = RunRequest {
            clock: &clock,
            ..RunRequest::once(DialectName::IRONPLC_ED2, SOURCE, &[])
        };
        let reason = "ironplcvm takes neither a clock nor values between scans".to_owned();
        assert_eq!(
            reproduce(&request, Ability::Execute),
            Err(NoReproduction::Unsupported(reason))
        );
        assert!(reproduce(&request, Ability::Check).is_ok());
    }
}
