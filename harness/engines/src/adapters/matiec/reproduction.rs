//! Writes what a person needs to run a program with `iec2c` and a C compiler alone.

use super::driver::{before, calls, configured, has, is_time, place, translated};
use super::{COMPILER, HEADER, LIBRARY, added_configuration};
use crate::adapters::builder::Language;
use crate::adapters::printed::{self, PrintedKind};
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::readable::{self, DriverMain, ReadableExpression};
use crate::adapters::source::{MainProgram, own_configuration};
use crate::adapters::{locate, reproduction};
use crate::reproduction::{PROGRAM, command_line};
use crate::{Ability, NoReproduction, Observation, Reproduction, RunRequest};
use stickler_types::DialectName;

/// The C expression for the instance of a program without a configuration of its own.
const INSTANCE: &str = "program";

/// Returns the reproduction of a request.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the adapter would not run the program either.
pub(in crate::adapters) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    locate::speaks(DialectName::MATIEC, request.dialect)?;
    reproduction::reproduce(request, ability, translation, |main| execution(request, main))
}

/// Returns the reproduction that only translates a program.
fn translation(program: String) -> Reproduction {
    let compiler = COMPILER.shell_variable();
    let library = LIBRARY.shell_variable();
    Reproduction::of(PROGRAM, program)
        .tool(compiler, COMPILER.name)
        .tool(
            library,
            &format!("$(dirname \"$(command -v \"${compiler}\")\")/lib"),
        )
        .command(format!("\"${compiler}\" -i -I \"${library}\" -T . {PROGRAM}"))
}

fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Reproduction, NoReproduction> {
    let probes = ProbeVariables::of(request);
    let mut program = with_shown_probes(request, main, probes.list())?;
    program.push_str(&added_configuration(request, main));
    let library = LIBRARY.shell_variable();
    let inputs = format!("-I \"${library}/C\" -I . {}", Language::C.driver());
    let libraries = command_line(Language::C.libraries().iter().copied());
    let driver = text(request, main, &probes)?;
    Ok(translation(program).driver(Language::C, driver, &inputs, &libraries))
}

/// Returns the driver.
fn text(
    request: &RunRequest<'_>,
    main: &MainProgram,
    probes: &ProbeVariables,
) -> Result<String, NoReproduction> {
    let kinds = printed::kinds(request, has)?;
    let own = own_configuration(request, &main.name);
    let (instance, declaration) = match &own {
        Some(own) => (configured(own), String::new()),
        None => {
            let class = main.name.to_ascii_uppercase();
            (INSTANCE.to_owned(), format!("static {class} {INSTANCE};\n"))
        }
    };
    let [initialise, scan] = calls(&main.name, &instance, own.is_some(), "++tick");
    let counter = if own.is_some() {
        "static unsigned long tick;\n"
    } else {
        ""
    };
    let observed = request.observe.iter().zip(&kinds);
    let main = DriverMain {
        scans: request.scans,
        start: vec![initialise],
        before: before(&instance, request)?,
        scan,
        after: observed
            .map(|(asked, kind)| {
                let variable = place(&instance, probes.variable(asked), request);
                (asked.after, print(asked, kind, variable))
            })
            .collect(),
    }
    .text();
    Ok(format!(
        "{HEADER}#include <time.h>\n\n{}\n{declaration}{counter}\n{}{main}",
        translated(own.as_ref()),
        readable::functions(&main)
    ))
}

fn print(asked: &Observation, kind: &PrintedKind<'_>, variable: String) -> String {
    let value = match kind {
        PrintedKind::Elementary(ty) if is_time(*ty) => ReadableExpression::Timespec(variable),
        PrintedKind::Elementary(ty) if ty.is_text() => ReadableExpression::Text {
            condition: format!("at < {variable}.len"),
            unit: format!("{variable}.body[at]"),
        },
        _ => ReadableExpression::Number(variable),
    };
    readable::statement(asked, kind, &value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reproduction(source: &str, observe: &[Observation]) -> Reproduction {
        let request = RunRequest::once(DialectName::MATIEC, source, observe);
        reproduce(&request, Ability::Execute).unwrap()
    }

    #[test]
    fn a_program_is_translated_built_and_run_by_three_commands() {
        let source = "PROGRAM main\nVAR x : INT; END_VAR\n  x := 5;\nEND_PROGRAM\n";
        let shown = reproduction(source, &[Observation::last("x", "INT")]);
        assert_eq!(
            shown.commands,
            [
                "\"$IEC2C\" -i -I \"$MATIEC_LIB\" -T . program.st",
                "\"$CC\" -O0 -w -I \"$MATIEC_LIB/C\" -I . driver.c -o driver -lm",
                "./driver"
            ]
        );
        let [program, driver] = &shown.files[..] else {
            panic!("{shown:?}")
        };
        assert_eq!(program.name, "program.st");
        assert!(program.text.starts_with(source), "no line of the program moves");
        assert!(
            program
                .text
                .contains("PROGRAM stickler_instance WITH stickler_task : main;")
        );
        assert_eq!(
            driver.text,
            format!(
                "{HEADER}#include <time.h>\n\n{}\n\
                 static MAIN program;\n\nint main(void) {{\n    MAIN_init__(&program, 0);\n    MAIN_body__(&program);\n    \
                 printf(\"x = %d\\n\", (int)program.X.value);\n    return 0;\n}}\n",
                translated(None)
            )
        );
    }
}
