//! Writes the C program that runs a translated program and prints its observed values.
//!
//! Basis: matiec: the C that `iec2c` writes: `NAME_init__`, `NAME_body__`, a structure of the variables in upper case, each
//! with its `value`; durations and dates are seconds and nanoseconds, a STRING its length and its bytes.

use crate::adapters::driver::{self, DrivenProgram, Driver};
use crate::adapters::printed::{self, PrintedKind};
use crate::adapters::probe_variable::ProbeVariables;
use crate::adapters::source::{OwnConfiguration, main_program, own_configuration, words_of};
use crate::{RunRequest, Setting};
use std::fmt::Write;
use stickler_types::{ElementaryType, Value};

/// A translated program that a driver runs: its request, the copies of observed values, and the name of its main program.
pub(super) struct MatiecSubject<'r, 'c> {
    pub(super) request: RunRequest<'r>,
    pub(super) probes: &'c ProbeVariables,
    pub(super) program: String,
}

/// Returns the driver of translated programs, which stand in one text.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn driver<'r>(subjects: &[MatiecSubject<'r, '_>]) -> Result<Driver<'r>, String> {
    let own = match subjects {
        [only] => own_configuration(&only.request, &only.program),
        _ => None,
    };
    let mut text = format!("#include \"stickler.h\"\n{}", translated(own.as_ref()));
    if own.is_none() {
        write_memory(&mut text, subjects);
    }
    text.push_str(PRINTERS);
    let mut driven = Vec::with_capacity(subjects.len());
    for (number, subject) in subjects.iter().enumerate() {
        let kinds = printed::kinds(&subject.request, has)?;
        let instance = match &own {
            Some(own) => configured(own),
            None => format!("memory.program.p{number}"),
        };
        write_look(&mut text, number, (subject, &instance), &kinds);
        write_run(&mut text, number, (subject, &instance), own.is_some())?;
        driven.push(DrivenProgram {
            request: subject.request,
            kinds,
        });
    }
    text.push_str(&driver::main(subjects.len(), |number| format!("run_{number}()")));
    Ok(Driver {
        text,
        subjects: driven,
        read: value,
        faults: &[],
    })
}

/// Writes the memory of the programs' variables. Only one program runs in a process, and so the programs share one place: a
/// program that accesses memory beside its variables finds there what it would find alone.
fn write_memory(text: &mut String, subjects: &[MatiecSubject<'_, '_>]) {
    text.push_str("static struct {\n    char before[65536];\n    union {\n");
    for (number, subject) in subjects.iter().enumerate() {
        // Writing into a String does not fail.
        let _ = writeln!(
            text,
            "        {} p{number};",
            subject.program.to_ascii_uppercase()
        );
    }
    text.push_str("    } program;\n    char behind[65536];\n} memory;\n");
}

/// Returns the declarations behind the headers, and the translated text with the parts of its own configuration.
pub(super) fn translated(own: Option<&OwnConfiguration>) -> String {
    let files = match own {
        None => "#include \"POUS.h\"\n#include \"POUS.c\"\n".to_owned(),
        // The file of the resource includes those of the program organization units.
        Some(own) => format!("#include \"{}.c\"\n#include \"{}.c\"\n", own.name, own.resource),
    };
    format!("TIME __CURRENT_TIME;\nBOOL __DEBUG;\n{MEMORY_OF_LOCATIONS}#include \"{LOCATIONS}\"\n{files}")
}

/// The file with an entry for each directly represented variable, whose memory the runtime system provides.
pub(super) const LOCATIONS: &str = "LOCATED_VARIABLES.h";

/// The macros that give each location its memory, 64 KiB that are 0 at first: what a runtime system does. Variables with one location
/// share it, whatever their types; programs of a pack run in processes of their own.
const MEMORY_OF_LOCATIONS: &str = include_str!("driver/memory_of_locations.c");

/// Returns the C expression for the instance of a program in its own configuration.
pub(super) fn configured(own: &OwnConfiguration) -> String {
    format!(
        "{}__{}",
        own.resource.to_ascii_uppercase(),
        own.instance.to_ascii_uppercase()
    )
}

/// Returns the statements that initialise the instance of a program and make the scan of a number, which is an expression. With
/// a configuration of its own, all that this has is initialised and runs.
pub(super) fn calls(program: &str, instance: &str, is_configured: bool, scan: &str) -> [String; 2] {
    match is_configured {
        true => [
            "config_init__();".to_owned(),
            format!("config_run__({scan} - 1);"),
        ],
        false => {
            let program = program.to_ascii_uppercase();
            [
                format!("{program}_init__(&{instance}, 0);"),
                format!("{program}_body__(&{instance});"),
            ]
        }
    }
}

/// Returns the C expression for a variable of the instance of a program.
pub(super) fn place(instance: &str, variable: &str, request: &RunRequest<'_>) -> String {
    let value = format!("{instance}.{}.value", variable.to_ascii_uppercase());
    match is_pointer(request, variable) {
        true => format!("(*{value})"),
        false => value,
    }
}

/// Returns whether the main program declares a variable of this name with a location or as an external one, of which the C has a pointer.
fn is_pointer(request: &RunRequest<'_>, variable: &str) -> bool {
    let inside = main_program(request).map_or(request.source, |main| &request.source[main.inside]);
    let inside = RunRequest {
        source: inside,
        ..*request
    };
    let mut words = words_of(&inside).peekable();
    let mut is_external = false;
    while let Some(word) = words.next() {
        if word.is("VAR_EXTERNAL") {
            is_external = true;
        } else if word.is("END_VAR") {
            is_external = false;
        // AT is a keyword, so no name.
        } else if word.is(variable) && (is_external || words.peek().is_some_and(|next| next.is("AT"))) {
            return true;
        }
    }
    false
}

/// Writes the function that runs a program, given with the expression for its instance.
fn write_run(
    text: &mut String,
    number: usize,
    (subject, instance): (&MatiecSubject<'_, '_>, &str),
    is_configured: bool,
) -> Result<(), String> {
    let [initialise, run] = calls(&subject.program, instance, is_configured, "scan");
    let _ = write!(
        text,
        "static int run_{number}(void) {{\n    {initialise}\n    \
         for (unsigned long scan = 1; scan <= {}UL; scan++) {{\n",
        subject.request.scans
    );
    for (scan, statement) in before(instance, &subject.request)? {
        let _ = writeln!(text, "        if (scan == {scan}UL) {{ {statement} }}");
    }
    let _ = write!(
        text,
        "        {run}\n        look_{number}(scan);\n    }}\n    look_{number}(0);\n    return 0;\n}}\n"
    );
    Ok(())
}

/// Tells whether the compiler has values of a type.
pub(super) fn has(ty: ElementaryType) -> bool {
    !ty.is_third_edition() && ty != ElementaryType::Wstring
}

/// The C functions that print values, one for each printed form.
const PRINTERS: &str = include_str!("driver/printers.c");

/// Writes the function that prints the values observed after a scan; 0 stands for the end.
fn write_look(
    text: &mut String,
    number: usize,
    (subject, instance): (&MatiecSubject<'_, '_>, &str),
    kinds: &[PrintedKind<'_>],
) {
    let _ = writeln!(text, "static void look_{number}(unsigned long scan) {{");
    for (asked_as, (asked, kind)) in subject.request.observe.iter().zip(kinds).enumerate() {
        let variable = place(instance, subject.probes.variable(asked), &subject.request);
        let call = match kind {
            PrintedKind::Elementary(ty) if is_time(*ty) => format!("print_time({asked_as}, {variable})"),
            PrintedKind::Elementary(ty) if ty.is_text() => format!("print_text({asked_as}, {variable})"),
            _ => format!("print_bits({asked_as}, &{variable}, sizeof {variable})"),
        };
        let _ = writeln!(text, "    if (scan == {}UL) {call};", asked.after.unwrap_or(0));
    }
    text.push_str("}\n");
}

/// Returns the statements before scans, which advance the clock and set variables of the instance of a program, each with the
/// number of its scan.
///
/// # Errors
/// A fragment that says what cannot be set.
pub(super) fn before(instance: &str, request: &RunRequest<'_>) -> Result<Vec<(u32, String)>, String> {
    let clock = request.clock.iter().map(|step| {
        let (seconds, rest) = split(step.nanoseconds);
        Ok((
            step.before,
            format!("__CURRENT_TIME = (TIME){{{seconds}, {rest}}};"),
        ))
    });
    let set = request
        .set
        .iter()
        .map(|setting| Ok((setting.before, written(instance, setting, request)?)));
    clock.chain(set).collect()
}

/// Returns the statement that sets a variable.
fn written(instance: &str, setting: &Setting, request: &RunRequest<'_>) -> Result<String, String> {
    let cannot = || format!("its driver cannot write {}", setting.name);
    let Value::Plain { ty, raw } = setting.value else {
        return Err(cannot());
    };
    if setting.name.contains(['.', '[']) {
        return Err(cannot());
    }
    let variable = place(instance, &setting.name, request);
    Ok(if is_time(ty) {
        let (seconds, rest) = split(raw.cast_signed());
        format!("{variable} = (TIME){{{seconds}, {rest}}};")
    } else {
        format!("unsigned long long bits = {raw}ULL; memcpy(&{variable}, &bits, sizeof {variable});")
    })
}

/// Splits a duration into seconds and nanoseconds of the same sign.
fn split(nanoseconds: i64) -> (i64, i64) {
    (nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000)
}

pub(super) fn is_time(ty: ElementaryType) -> bool {
    ty.is_duration() || ty.is_date_or_time()
}

/// Parses a printed value; `None` where the text is no such value.
fn value(kind: &PrintedKind<'_>, shown: &str) -> Option<Value> {
    let bits = || u64::from_str_radix(shown, 16).ok();
    match kind {
        PrintedKind::Enumerated(..) => kind.enumerated(bits()?),
        PrintedKind::Elementary(ty) if is_time(*ty) => {
            let (seconds, rest) = shown.split_once(' ')?;
            let (seconds, rest) = (seconds.parse::<i64>().ok()?, rest.parse::<i64>().ok()?);
            let nanoseconds = i128::from(seconds) * 1_000_000_000 + i128::from(rest);
            Some(Value::of_nanoseconds(*ty, nanoseconds))
        }
        PrintedKind::Elementary(ty) if ty.is_text() => {
            text(shown.strip_prefix('\'')?).map(|units| Value::text(*ty, units))
        }
        PrintedKind::Elementary(ty) => Some(Value::plain(*ty, printed::raw(*ty, bits()?))),
    }
}

/// Parses the bytes of a text in hexadecimal digits.
fn text(digits: &str) -> Option<Vec<u16>> {
    let pairs = digits.as_bytes().chunks(2);
    pairs
        .map(|pair| u16::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok())
        .collect()
}

#[cfg(test)]
mod tests;
