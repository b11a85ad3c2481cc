//! Writes what a person needs to run a program with the command line of STruC++ and a C++ compiler alone.

use super::driver::{before, class, kinds, place};
use super::{COMPILER, DIALECT, NODE};
use crate::adapters::builder::{CXX, Language};
use crate::adapters::printed::Kind;
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::readable::{self, Expression, Main};
use crate::adapters::source::{MainProgram, main_program};
use crate::reproduction::{PROGRAM, command_line};
use crate::{Ability, NoReproduction, Observation, Reproduction, RunRequest};
use stickler_types::ElementaryType;

/// The variable for the folder of the compiler's run-time headers.
const HEADERS: &str = "STRUCPP_INCLUDE";

/// Returns the reproduction of a request.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the adapter would not run the program either.
pub(in crate::adapters) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    if request.dialect.base() != DIALECT.base() {
        return Err(NoReproduction::Unsupported(format!(
            "it does not speak {}",
            request.dialect
        )));
    }
    match (ability, main_program(request.source)) {
        (Ability::Render, _) => Err(super::no_rendering().into()),
        (Ability::Execute | Ability::Scans, Some(main)) => execution(request, &main),
        (Ability::Check, _) | (_, None) => Ok(translation(request.source.to_owned())),
    }
}

/// Returns the reproduction that only translates a program; the compiler says itself that it accepts it.
fn translation(program: String) -> Reproduction {
    let (node, compiler) = (NODE.shell_variable(), COMPILER.shell_variable());
    Reproduction::of(PROGRAM, program)
        .tool(node, NODE.name)
        .tool(compiler, &format!("$(command -v {})", COMPILER.name))
        .command(format!(
            "\"${node}\" \"${compiler}\" --no-default-libs {PROGRAM} -o program.cpp"
        ))
}

fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Reproduction, NoReproduction> {
    let probes = ProbeVariables::of(request);
    let program = with_shown_probes(request, main, probes.list())?;
    let (compiler, cxx) = (COMPILER.shell_variable(), CXX.shell_variable());
    let driver = Language::Cpp.driver();
    let options = command_line(Language::Cpp.options().iter().copied());
    Ok(translation(program)
        .tool(
            HEADERS,
            &format!("$(dirname \"$(readlink -f \"${compiler}\")\")/../../src/runtime/include"),
        )
        .tool(cxx, CXX.name)
        .file(driver, text(request, main, &probes)?)
        .command(format!(
            "\"${cxx}\" {options} -I \"${HEADERS}\" -I . {driver} -o driver"
        ))
        .command("./driver"))
}

/// Returns the driver.
fn text(
    request: &RunRequest<'_>,
    main: &MainProgram,
    probes: &ProbeVariables,
) -> Result<String, NoReproduction> {
    let kinds = kinds(request)?;
    let observed = request.observe.iter().zip(&kinds);
    let text = Main {
        scans: request.scans,
        start: Vec::new(),
        before: before(request),
        scan: "program.run();".to_owned(),
        after: observed
            .map(|(asked, kind)| (asked.after, print(asked, kind, place(probes.variable(asked)))))
            .collect(),
    }
    .text();
    Ok(format!(
        "#include \"program.cpp\"\n#include <cstdio>\n#include <ctime>\n\nstatic {} program;\n\n{}{text}",
        class(&main.name),
        readable::functions(&text)
    ))
}

fn print(asked: &Observation, kind: &Kind<'_>, variable: String) -> String {
    let value = match kind {
        Kind::Elementary(ElementaryType::Date | ElementaryType::Ldate) => Expression::Days(variable),
        Kind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => Expression::Nanoseconds(variable),
        Kind::Elementary(ty) if ty.is_text() => Expression::Text {
            condition: format!("at < {variable}.length()"),
            unit: match ty {
                ElementaryType::Wstring => format!("{variable}[at]"),
                _ => format!("(unsigned char){variable}[at]"),
            },
        },
        _ => Expression::Number(variable),
    };
    readable::statement(asked, kind, &value)
}
