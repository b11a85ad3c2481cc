//! Writes what a person needs to run a program with the command line of STruC++ and a C++ compiler alone.

use super::driver::{VALUE_OF, before, instance, kinds, place};
use super::{COMPILER, DIALECT, NODE};
use crate::adapters::builder::Language;
use crate::adapters::printed::PrintedKind;
use crate::adapters::probe_variable::{ProbeVariables, with_shown_probes};
use crate::adapters::readable::{self, DriverMain, ReadableExpression};
use crate::adapters::source::MainProgram;
use crate::adapters::{locate, reproduction};
use crate::reproduction::PROGRAM;
use crate::{Ability, NoReproduction, Observation, Reproduction, RunRequest};
use stickler_types::ElementaryType;

/// The variable for the folder of the compiler's run-time headers.
pub(super) const HEADERS: &str = "STRUCPP_INCLUDE";

/// Returns the reproduction of a request.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the adapter would not run the program either.
pub(in crate::adapters) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    locate::speaks(DIALECT, request.dialect)?;
    reproduction::reproduce(request, ability, translation, |main| execution(request, main))
}

/// Returns the reproduction that only translates a program.
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
    let compiler = COMPILER.shell_variable();
    let headers = format!("$(dirname \"$(readlink -f \"${compiler}\")\")/../../src/runtime/include");
    let inputs = format!("-I \"${HEADERS}\" -I . {}", Language::Cpp.driver());
    let driver = text(request, main, &probes)?;
    Ok(translation(program)
        .tool(HEADERS, &headers)
        .driver(Language::Cpp, driver, &inputs, ""))
}

/// Returns the driver.
fn text(
    request: &RunRequest<'_>,
    main: &MainProgram,
    probes: &ProbeVariables,
) -> Result<String, NoReproduction> {
    let kinds = kinds(request)?;
    let observed = request.observe.iter().zip(&kinds);
    let text = DriverMain {
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
        "#include \"program.cpp\"\n#include <cstdio>\n#include <ctime>\n\n{}\n{VALUE_OF}{}{text}",
        instance(request, &main.name),
        readable::functions(&text)
    ))
}

fn print(asked: &Observation, kind: &PrintedKind<'_>, variable: String) -> String {
    let value = match kind {
        PrintedKind::Elementary(ElementaryType::Date | ElementaryType::Ldate) => {
            ReadableExpression::Days(variable)
        }
        PrintedKind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => {
            ReadableExpression::Nanoseconds(variable)
        }
        PrintedKind::Elementary(ty) if ty.is_text() => ReadableExpression::Text {
            condition: format!("at < {variable}.length()"),
            unit: match ty {
                ElementaryType::Wstring => format!("{variable}[at]"),
                _ => format!("(unsigned char){variable}[at]"),
            },
        },
        _ => ReadableExpression::Number(variable),
    };
    readable::statement(asked, kind, &value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    #[test]
    fn each_kind_of_value_is_printed_as_a_person_reads_it() {
        let observe = [
            "i INT",
            "u UDINT",
            "w WORD",
            "r LREAL",
            "t TIME",
            "d DATE",
            "o TOD",
            "s STRING",
            "l[1] BYTE",
        ]
        .map(|asked| {
            let (name, type_name) = asked.split_once(' ').unwrap();
            Observation::last(name, type_name)
        });
        let source = "PROGRAM main\n  ;\nEND_PROGRAM\n";
        let request = RunRequest {
            scans: 2,
            ..RunRequest::once(DialectName::STRUCPP, source, &observe)
        };
        let shown = reproduce(&request, Ability::Execute).unwrap();
        let [program, driver] = &shown.files[..] else {
            panic!("{shown:?}")
        };
        assert!(
            program.text.contains("stickler_probe_0 := l[1];"),
            "{}",
            program.text
        );
        for line in [
            "static strucpp::Program_MAIN program;",
            "for (unsigned scan = 1; scan <= 2; scan++) {",
            "printf(\"i = %d\\n\", (int)value_of(program.I, 0));",
            "printf(\"u = %u\\n\", (unsigned)value_of(program.U, 0));",
            "printf(\"w = 16#%04X\\n\", (unsigned)value_of(program.W, 0));",
            "printf(\"r = %.17g\\n\", (double)value_of(program.R, 0));",
            "printf(\"t = %lld ns\\n\", (long long)value_of(program.T, 0));",
            "print_date(\"d\", \"%Y-%m-%d\", value_of(program.D, 0) * 86400LL, 0);",
            "print_date(\"o\", \"%H:%M:%S\", value_of(program.O, 0) / 1000000000, value_of(program.O, 0) % 1000000000);",
            "at < value_of(program.S, 0).length(); at++) print_character((unsigned char)value_of(program.S, 0)[at]);",
            "printf(\"l[1] = 16#%02X\\n\", (unsigned)value_of(program.STICKLER_PROBE_0, 0));",
            "static void print_character(",
            "static void print_date(",
        ] {
            assert!(driver.text.contains(line), "{line}\n{}", driver.text);
        }
        assert_eq!(
            shown.commands,
            [
                "\"$NODE\" \"$STRUCPP\" --no-default-libs program.st -o program.cpp",
                "\"$CXX\" -std=c++17 -O0 -w -I \"$STRUCPP_INCLUDE\" -I . driver.cpp -o driver",
                "./driver"
            ]
        );
    }
}
