//! Writes what a person needs to run a program with `plc` and a C compiler alone.

use super::driver::{HEADER, initialise, kinds, of_c, shown_as};
use super::{COMPILER, DECLARATIONS, LIBRARY, OBJECT, OBJECT_FILE, library};
use crate::adapters::builder::Language;
use crate::adapters::printed::PrintedKind;
use crate::adapters::readable::{self, DriverMain, ReadableExpression};
use crate::adapters::source::MainProgram;
use crate::adapters::{locate, reproduction};
use crate::reproduction::{PROGRAM, command_line};
use crate::{Ability, NoReproduction, Observation, Reproduction, RunRequest};
use std::collections::BTreeMap;
use std::fmt::Write;
use stickler_syntax::{Edits, words};
use stickler_types::{Dialect, DialectName, ElementaryType};

/// The file of the functions that show the observed values.
const FUNCTIONS: &str = "show.st";

/// The name that a program gets which is called as the place where a C program begins.
const MAIN: &str = "main_program";

/// Returns the reproduction of a request.
///
/// # Errors
/// [`NoReproduction::Unsupported`] where the adapter would not run the program either.
pub(in crate::adapters) fn reproduce(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    locate::speaks(DialectName::RUSTY, request.dialect)?;
    // Some mistakes are only found when the object file is made.
    let translation = |program| compilation(program, &[PROGRAM], &OBJECT);
    reproduction::reproduce(request, ability, translation, |main| execution(request, main))
}

/// Returns the reproduction that only compiles a program.
fn compilation(program: String, files: &[&str], options: &[&str]) -> Reproduction {
    let (plc, declarations) = (COMPILER.shell_variable(), DECLARATIONS.shell_variable());
    let files = files.join(" ");
    let options = command_line(options.iter().copied());
    Reproduction::of(PROGRAM, program)
        .tool(plc, COMPILER.name)
        .tool(declarations, &beside("include"))
        .command(format!(
            "\"${plc}\" {files} -i \"${declarations}/*.st\" {options}"
        ))
}

/// Returns the usual place of a folder of the library.
fn beside(folder: &str) -> String {
    format!(
        "$(dirname \"$(command -v \"${}\")\")/{folder}",
        COMPILER.shell_variable()
    )
}

fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Reproduction, NoReproduction> {
    let kinds = kinds(request)?;
    let library = LIBRARY.shell_variable();
    // Access to the variables of a program is a warning for each, which is one line then.
    let one_line = ["--error-format=clang"];
    let options: Vec<&str> = OBJECT.into_iter().chain(one_line).collect();
    let inputs = format!("{} {OBJECT_FILE}", Language::C.driver());
    let needed = library::NEEDED.join(" ");
    let (before, behind) = library::whole_archive();
    let (archive, shared) = (library::STATIC, library::SHARED);
    let compiler = Language::C.compiler().shell_variable();
    // As RuSTy's own packages are made: the functions that are written in Structured Text are in the static library only.
    let share = format!(
        "if [ -f \"${library}/{archive}\" ]; then \"${compiler}\" -shared -o {shared} {before} \"${library}/{archive}\" {behind} {needed}; \
         else cp \"${library}/{shared}\" .; fi"
    );
    let libraries = format!("-L . -Wl,-rpath,. -liec61131std {needed} -no-pie");
    Ok(
        compilation(renamed(request.source), &[PROGRAM, FUNCTIONS], &options)
            .tool(library, &beside("lib"))
            .file(FUNCTIONS, functions(request, &renamed(&main.name), &kinds))
            .command(share)
            .driver(Language::C, text(request, &kinds), &inputs, &libraries),
    )
}

/// Returns a text without the name at which a C program begins.
fn renamed(source: &str) -> String {
    let mut edits = Edits::new();
    for word in words(source, Dialect::of(DialectName::RUSTY)).filter(|word| word.is("main")) {
        edits.replace(word.span, MAIN);
    }
    edits.apply(source)
}

/// Returns the function that shows the values observed after a scan; `None` stands for the last.
fn show(after: Option<u32>) -> String {
    match after {
        Some(scan) => format!("driver_show_after_{scan}"),
        None => "driver_show".to_owned(),
    }
}

/// Returns the functions of Structured Text that pass the observed values to the driver.
fn functions(request: &RunRequest<'_>, program: &str, kinds: &[PrintedKind<'_>]) -> String {
    let mut shown: BTreeMap<Option<u32>, String> = BTreeMap::from([(None, String::new())]);
    let mut external = String::new();
    for (number, (asked, kind)) in request.observe.iter().zip(kinds).enumerate() {
        let ty = shown_as(kind);
        let by = if ty.is_text() { " {ref}" } else { "" };
        // Writing into a String does not fail.
        let _ = writeln!(
            shown.entry(asked.after).or_default(),
            "  driver_show_{number}({program}.{});",
            renamed(&asked.name)
        );
        let _ = writeln!(
            external,
            "{{external}} FUNCTION driver_show_{number} : DINT VAR_INPUT{by} value : {ty}; END_VAR END_FUNCTION"
        );
    }
    let mut text = format!("FUNCTION driver_scan : DINT\n  {program}();\nEND_FUNCTION\n");
    for (after, statements) in shown {
        let _ = write!(
            text,
            "FUNCTION {} : DINT\n{statements}END_FUNCTION\n",
            show(after)
        );
    }
    text + &external
}

/// Returns the driver.
fn text(request: &RunRequest<'_>, kinds: &[PrintedKind<'_>]) -> String {
    let observed = request.observe.iter().zip(kinds).enumerate();
    let mut printers = String::new();
    for (number, (asked, kind)) in observed {
        let _ = writeln!(
            printers,
            "int32_t driver_show_{number}({}value) {{ {} return 0; }}",
            parameter(kind),
            print(asked, kind)
        );
    }
    let mut after: Vec<Option<u32>> = request.observe.iter().map(|asked| asked.after).collect();
    after.push(None);
    after.sort_unstable();
    after.dedup();
    let declared: String = after
        .iter()
        .map(|after| format!("int32_t {}(void);\n", show(*after)))
        .collect();
    let initialise = initialise(PROGRAM);
    let main = DriverMain {
        scans: request.scans,
        start: vec![format!("if ({initialise}) {initialise}();")],
        before: Vec::new(),
        scan: "driver_scan();".to_owned(),
        after: after
            .iter()
            .map(|after| (*after, format!("{}();", show(*after))))
            .collect(),
    };
    format!(
        "{HEADER}#include <time.h>\n\n{}{printers}\nint32_t driver_scan(void);\n{declared}\
         __attribute__((weak)) void {initialise}(void);\n\n{}",
        readable::functions(&printers),
        main.text()
    )
}

/// Returns the C type of the parameter that takes a value, with the blank or star behind it. Numbers with a sign have one here.
fn parameter(kind: &PrintedKind<'_>) -> String {
    let ty = shown_as(kind);
    match ty {
        ElementaryType::String => "unsigned char *".to_owned(),
        ElementaryType::Wstring => "uint16_t *".to_owned(),
        _ if ty.is_signed() => format!("{} ", of_c(ty).trim_start_matches('u')),
        _ => format!("{} ", of_c(ty)),
    }
}

fn print(asked: &Observation, kind: &PrintedKind<'_>) -> String {
    let value = || "value".to_owned();
    let value = match kind {
        PrintedKind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => {
            ReadableExpression::Nanoseconds(value())
        }
        PrintedKind::Elementary(ty) if ty.is_text() => ReadableExpression::Text {
            condition: "value[at]".to_owned(),
            unit: "value[at]".to_owned(),
        },
        _ => ReadableExpression::Number(value()),
    };
    readable::statement(asked, kind, &value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_shows_its_values_through_functions_and_keeps_its_lines() {
        let observe = [
            Observation::last("n", "INT"),
            Observation {
                after: Some(1),
                ..Observation::last("s", "STRING")
            },
        ];
        let source = "PROGRAM main\nVAR n : INT; s : STRING; END_VAR\n  n := n + 1; // main\nEND_PROGRAM\n";
        let request = RunRequest {
            scans: 2,
            ..RunRequest::once(DialectName::RUSTY, source, &observe)
        };
        let shown = reproduce(&request, Ability::Execute).unwrap();
        let [program, functions, driver] = &shown.files[..] else {
            panic!("{shown:?}")
        };
        // Nothing but the name of the program changes, since `main` is where a C program begins.
        assert_eq!(program.text, source.replacen("main", "main_program", 1));
        assert_eq!(
            functions.text,
            "FUNCTION driver_scan : DINT\n  main_program();\nEND_FUNCTION\n\
             FUNCTION driver_show : DINT\n  driver_show_0(main_program.n);\nEND_FUNCTION\n\
             FUNCTION driver_show_after_1 : DINT\n  driver_show_1(main_program.s);\nEND_FUNCTION\n\
             {external} FUNCTION driver_show_0 : DINT VAR_INPUT value : INT; END_VAR END_FUNCTION\n\
             {external} FUNCTION driver_show_1 : DINT VAR_INPUT {ref} value : STRING; END_VAR END_FUNCTION\n"
        );
        for line in [
            "int32_t driver_show_0(int16_t value) { printf(\"n = %d\\n\", (int)value); return 0; }",
            "int32_t driver_show_1(unsigned char *value) { printf(\"s@1 = '\"); for (unsigned at = 0; value[at]; at++)",
            "        driver_scan();\n        if (scan == 1) { driver_show_after_1(); }\n    }\n    driver_show();\n",
        ] {
            assert!(driver.text.contains(line), "{line}\n{}", driver.text);
        }
        let checked = reproduce(&request, Ability::Check).unwrap();
        assert_eq!(checked.files[0].text, source);
        assert_eq!(
            checked.commands[0],
            "\"$PLC\" program.st -i \"$RUSTY_INCLUDE/*.st\" -c -O none -o program.o"
        );
    }
}
