//! Writes the C program that runs compiled programs, and the functions by which the programs show the observed values.
//!
//! The functions stand in a file of their own, so that the program under test is compiled as it is.
//!
//! Basis: rusty: book, *External Functions*: a function that is declared `{external}` is one of C; `VAR_INPUT {ref}` takes the
//! address. Integers and bit strings have their width, BOOL a byte, durations and dates are nanoseconds in 64 bits, texts end
//! with a zero. Access to the variables of a program from outside is a warning, E049.

use crate::RunRequest;
use crate::adapters::driver::{self, DrivenProgram, Driver};
use crate::adapters::printed::{self, PrintedKind};
use std::collections::BTreeMap;
use std::fmt::Write;
use stickler_types::{ElementaryType, Value};

/// The headers that the driver includes.
pub(super) const HEADER: &str =
    "#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n";

/// The C functions that print values, one for each printed form. Each prints only after the scan for which the value is asked.
const PRINTERS: &str = include_str!("driver/printers.c");

/// A compiled program that a driver runs: its request, and the names of its parts in the compiled text.
pub(super) struct RustySubject<'r> {
    pub(super) request: RunRequest<'r>,
    /// The main program.
    pub(super) program: String,
    /// The variables that are observed, in order.
    pub(super) observed: Vec<String>,
}

/// Returns the driver of compiled programs. The function that sets the initial values of variables that the loader cannot set
/// is named after the first file that the compiler was given.
///
/// Basis: rusty: book, *Variables*, *Pointer Initialization*: a runtime has to call it. Linkers that know of constructors do so,
/// too, and to do it again changes nothing.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn driver<'r>(subjects: &[RustySubject<'r>], first_file: &str) -> Result<Driver<'r>, String> {
    let mut driven = Vec::with_capacity(subjects.len());
    for RustySubject { request, .. } in subjects {
        driven.push(DrivenProgram {
            request: *request,
            kinds: kinds(request)?,
        });
    }
    let mut text = format!("#include \"stickler.h\"\n{PRINTERS}");
    for (name, ty) in shown(&driven) {
        text.push_str(&printer(&name, ty));
    }
    for (number, subject) in subjects.iter().enumerate() {
        write_run(&mut text, number, &subject.request);
    }
    text.push_str(&initialisation(first_file));
    let run = |number| format!("run_initialised(run_{number})");
    text.push_str(&driver::main(subjects.len(), run));
    Ok(Driver {
        text,
        subjects: driven,
        read: value,
        faults: &[],
    })
}

/// Returns the kinds of the observed values.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn kinds<'r>(request: &RunRequest<'r>) -> Result<Vec<PrintedKind<'r>>, String> {
    if !(request.clock.is_empty() && request.set.is_empty()) {
        return Err("its driver takes neither a clock nor values between scans".to_owned());
    }
    printed::kinds(request, |_| true)
}

/// Returns the name of the function that sets the initial values of the variables of programs.
pub(super) fn initialise(first_file: &str) -> String {
    format!("__init___{}", first_file.replace('.', "_"))
}

/// Returns the function that runs one of the programs after their initial values are set. Where the standard library panics,
/// its message is worth more than a backtrace.
fn initialisation(first_file: &str) -> String {
    let initialise = initialise(first_file);
    format!(
        "__attribute__((weak)) void {initialise}(void);\n\
         static int run_initialised(int (*run)(void)) {{\n\
         #if defined(__unix__) || defined(__APPLE__)\n    \
         setenv(\"RUST_BACKTRACE\", \"0\", 1);\n\
         #endif\n    \
         if ({initialise}) {initialise}();\n    return run();\n}}\n"
    )
}

/// Returns the declaration of the function that a program calls to show a value of a type.
fn printer(name: &str, ty: ElementaryType) -> String {
    match ty {
        ElementaryType::String => format!(
            "int32_t {name}(int32_t number, unsigned char *value) {{ print_bytes(number, value); return 0; }}\n"
        ),
        ElementaryType::Wstring => format!(
            "int32_t {name}(int32_t number, uint16_t *value) {{ print_units(number, value); return 0; }}\n"
        ),
        _ => format!(
            "int32_t {name}(int32_t number, {} value) {{ print_bits(number, &value, sizeof value); return 0; }}\n",
            of_c(ty)
        ),
    }
}

/// Writes the function that runs a program, which shows the observed values before the first scan and after each scan.
fn write_run(text: &mut String, number: usize, request: &RunRequest<'_>) {
    let after = request
        .observe
        .iter()
        .map(|asked| format!("{}UL", asked.after.unwrap_or(request.scans)));
    // C has no empty arrays.
    let after: Vec<String> = after.chain(["0".to_owned()]).collect();
    // Writing into a String does not fail.
    let _ = write!(
        text,
        "int32_t stickler_scan_{number}(void);\nint32_t stickler_look_{number}(void);\n\
         static const unsigned long after_{number}[] = {{{}}};\n\
         static int run_{number}(void) {{\n    after = after_{number};\n    stickler_look_{number}();\n    \
         for (scan = 1; scan <= {}UL; scan++) {{\n        \
         stickler_scan_{number}();\n        stickler_look_{number}();\n    }}\n    return 0;\n}}\n",
        after.join(", "),
        request.scans,
    );
}

/// Returns the text of the functions that the driver calls: a line for each program, in order, and then the functions that
/// these call.
pub(super) fn functions(subjects: &[RustySubject<'_>], driven: &[DrivenProgram<'_>]) -> String {
    let mut text = String::new();
    for (number, (subject, driven)) in subjects.iter().zip(driven).enumerate() {
        let program = &subject.program;
        // Writing into a String does not fail.
        let _ = write!(
            text,
            "FUNCTION stickler_scan_{number} : DINT {program}(); END_FUNCTION FUNCTION stickler_look_{number} : DINT"
        );
        for (asked_as, (variable, kind)) in subject.observed.iter().zip(&driven.kinds).enumerate() {
            let _ = write!(text, " {}({asked_as}, {program}.{variable});", function(kind));
        }
        text.push_str(" END_FUNCTION\n");
    }
    for (name, ty) in shown(driven) {
        let by = if ty.is_text() { " {ref}" } else { "" };
        let _ = writeln!(
            text,
            "{{external}} FUNCTION {name} : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT{by} value : {ty}; END_VAR \
             END_FUNCTION"
        );
    }
    text
}

/// Returns the type as which a value is shown. The values of an enumeration are numbers.
pub(super) fn shown_as(kind: &PrintedKind<'_>) -> ElementaryType {
    match kind {
        PrintedKind::Elementary(ty) => *ty,
        PrintedKind::Enumerated(..) => ElementaryType::Dint,
    }
}

/// Returns the functions by which values are shown, each once, with the type that each takes.
fn shown(driven: &[DrivenProgram<'_>]) -> BTreeMap<String, ElementaryType> {
    let kinds = driven.iter().flat_map(|driven| &driven.kinds);
    kinds.map(|kind| (function(kind), shown_as(kind))).collect()
}

fn function(kind: &PrintedKind<'_>) -> String {
    format!("stickler_show_{}", shown_as(kind).name().to_ascii_lowercase())
}

/// Returns the C type that has the bits of a value.
pub(super) fn of_c(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Real => "float",
        ElementaryType::Lreal => "double",
        ElementaryType::Char => "uint8_t",
        ElementaryType::Wchar => "uint16_t",
        _ if ty.is_duration() || ty.is_date_or_time() => "int64_t",
        _ => match ty.bits() {
            0..=8 => "uint8_t",
            9..=16 => "uint16_t",
            17..=32 => "uint32_t",
            _ => "uint64_t",
        },
    }
}

/// Parses a printed value; `None` where the text is no such value.
fn value(kind: &PrintedKind<'_>, shown: &str) -> Option<Value> {
    let bits = || u64::from_str_radix(shown, 16).ok();
    match kind {
        PrintedKind::Enumerated(..) => kind.enumerated(bits()?),
        PrintedKind::Elementary(ty) if ty.is_text() && shown.starts_with('\'') => {
            Some(Value::text(*ty, printed::units(shown.strip_prefix('\'')?)?))
        }
        PrintedKind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => {
            Some(Value::plain(*ty, bits()?))
        }
        PrintedKind::Elementary(ty) => Some(Value::plain(*ty, printed::raw(*ty, bits()?))),
    }
}
