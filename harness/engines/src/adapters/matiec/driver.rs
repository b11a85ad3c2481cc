//! Writes the C program that runs a translated program and prints its observed values.
//!
//! Basis: matiec: the C that `iec2c` writes: `NAME_init__`, `NAME_body__`, a structure of the variables in upper case, each
//! with its `value`; durations and dates are seconds and nanoseconds, a STRING its length and its bytes.

use crate::RunRequest;
use crate::adapters::Compiler;
use crate::adapters::builder::C;
use crate::adapters::driver::{DrivenProgram, Driver, clock};
use crate::adapters::probe_variable::ProbeVariables;
use crate::adapters::source::{OwnConfiguration, main_program, own_configuration, words_of};
use crate::adapters::values::{self, ObservedKind, ValueExpression};
use std::collections::HashSet;
use stickler_types::ElementaryType;

/// The headers that every driver includes.
pub(super) const HEADER: &str = "#include \"iec_std_lib.h\"\n#include <stdio.h>\n#include <time.h>\n";

/// A translated program that a driver runs: its request, the copies of observed values, and the name of its main program.
pub(super) struct MatiecSubject<'r, 'c> {
    request: RunRequest<'r>,
    probes: &'c ProbeVariables,
    /// The name in capitals, as the compiler writes it.
    program: String,
}

impl<'r, 'c> MatiecSubject<'r, 'c> {
    /// Returns the program of a request, whose main program has this name in the translated text.
    pub(super) fn of(
        request: &RunRequest<'r>,
        probes: &'c ProbeVariables,
        program: &str,
    ) -> MatiecSubject<'r, 'c> {
        MatiecSubject {
            request: *request,
            probes,
            program: program.to_ascii_uppercase(),
        }
    }
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
    let has_locations = subjects
        .iter()
        .any(|subject| words_of(&subject.request).any(|word| word.is("AT")));
    let translated = translated(own.as_ref(), has_locations);
    let (memory, instances) = match &own {
        Some(own) => (String::new(), vec![configured(own)]),
        None => memory(subjects),
    };
    let subjects = subjects.iter().zip(&instances);
    Ok(Driver {
        language: &C,
        head: format!("{HEADER}\n{translated}\n{memory}"),
        programs: subjects
            .map(|(subject, instance)| driven(subject, instance, own.is_some()))
            .collect::<Result<_, _>>()?,
        compiler: Compiler::Matiec,
    })
}

/// Returns the declaration of the memory of the programs' variables, and the C expression for those of each. Only one program runs in a
/// process, and so the programs share one place. Around it memory is 0, so that a program which accesses memory beside its variables
/// finds there what it would find alone; a single program without subscripts has its variables alone, as a person would declare them.
fn memory(subjects: &[MatiecSubject<'_, '_>]) -> (String, Vec<String>) {
    let (program, instances) = match subjects {
        [only] if !only.request.source.contains('[') => {
            let declaration = format!("static {} program;\n\n", only.program);
            return (declaration, vec!["program".to_owned()]);
        }
        [only] => (
            format!("    {} program;\n", only.program),
            vec!["memory.program".to_owned()],
        ),
        several => {
            let parts = several.iter().enumerate();
            let parts = parts.map(|(number, subject)| format!("        {} p{number};\n", subject.program));
            let instances = (0..several.len()).map(|number| format!("memory.program.p{number}"));
            (
                format!("    union {{\n{}    }} program;\n", parts.collect::<String>()),
                instances.collect(),
            )
        }
    };
    (
        format!(
            "static struct {{\n    char before[65536];\n{program}    char behind[65536];\n}} memory;\n\n"
        ),
        instances,
    )
}

/// Returns a program as the driver runs it; `instance` is the C expression for its instance. With a configuration of its own, all
/// that this has is initialised and runs.
fn driven<'r>(
    subject: &MatiecSubject<'r, '_>,
    instance: &str,
    is_configured: bool,
) -> Result<DrivenProgram<'r>, String> {
    let MatiecSubject {
        request,
        probes,
        program,
    } = subject;
    let kinds = values::kinds(request, has)?;
    let (declarations, start, scan) = match is_configured {
        true => (
            "static unsigned long tick;\n\n".to_owned(),
            "config_init__();".to_owned(),
            "config_run__(tick++);".to_owned(),
        ),
        false => (
            String::new(),
            format!("{program}_init__(&{instance}, 0);"),
            format!("{program}_body__(&{instance});"),
        ),
    };
    let observed = request.observe.iter().zip(&kinds);
    let pointers = pointers(request);
    let place = |variable: &str| {
        let variable = variable.to_ascii_uppercase();
        match pointers.contains(&variable) {
            true => format!("(*{instance}.{variable}.value)"),
            false => format!("{instance}.{variable}.value"),
        }
    };
    Ok(DrivenProgram {
        request: *request,
        before: clock(request, set_clock),
        after: observed
            .map(|(asked, kind)| {
                let variable = place(probes.variable(asked));
                let print = values::statement(asked, kind, &expression(kind, variable));
                (asked.after, print)
            })
            .collect(),
        kinds,
        declarations,
        start: vec![start],
        scan,
        namespace: None,
    })
}

/// Returns the expression for the value of a variable.
fn expression(kind: &ObservedKind<'_>, variable: String) -> ValueExpression {
    match kind {
        ObservedKind::Elementary(ty) if ty.is_moment() => ValueExpression::Timespec(variable),
        ObservedKind::Elementary(ty) if ty.is_text() => ValueExpression::Text {
            condition: format!("at < {variable}.len"),
            unit: format!("{variable}.body[at]"),
        },
        _ => ValueExpression::Number(variable),
    }
}

/// Returns the declarations behind the headers, and the translated text with the parts of its own configuration. The memory of locations
/// is declared only where a program has one, so that what the compiler writes into [`LOCATIONS`] beside them hides nothing else.
fn translated(own: Option<&OwnConfiguration>, has_locations: bool) -> String {
    let files = match own {
        None => "#include \"POUS.h\"\n#include \"POUS.c\"\n".to_owned(),
        // The file of the resource includes those of the program organization units.
        Some(own) => format!("#include \"{}.c\"\n#include \"{}.c\"\n", own.name, own.resource),
    };
    let locations = match has_locations {
        true => format!("{MEMORY_OF_LOCATIONS}#include \"{LOCATIONS}\"\n"),
        false => String::new(),
    };
    format!("TIME __CURRENT_TIME;\nBOOL __DEBUG;\n{locations}{files}")
}

/// The file with an entry for each directly represented variable, whose memory the runtime system provides.
pub(super) const LOCATIONS: &str = "LOCATED_VARIABLES.h";

/// The macros that give each location its memory, 64 KiB that are 0 at first: what a runtime system does. Variables with one location
/// share it, whatever their types; programs of a pack run in processes of their own.
const MEMORY_OF_LOCATIONS: &str = include_str!("driver/memory_of_locations.c");

/// Returns the C expression for the instance of a program in its own configuration.
fn configured(own: &OwnConfiguration) -> String {
    format!(
        "{}__{}",
        own.resource.to_ascii_uppercase(),
        own.instance.to_ascii_uppercase()
    )
}

/// Returns the variables, in capitals, that the main program declares with a location or as external ones, of which the C has pointers.
fn pointers(request: &RunRequest<'_>) -> HashSet<String> {
    let inside = main_program(request).map_or(request.source, |main| &request.source[main.inside]);
    let inside = RunRequest {
        source: inside,
        ..*request
    };
    let mut pointers = HashSet::new();
    let mut words = words_of(&inside).peekable();
    let mut is_external = false;
    while let Some(word) = words.next() {
        if word.is("VAR_EXTERNAL") {
            is_external = true;
        } else if word.is("END_VAR") {
            is_external = false;
        // AT is a keyword, so no name.
        } else if is_external || words.peek().is_some_and(|next| next.is("AT")) {
            pointers.insert(word.text.to_ascii_uppercase());
        }
    }
    pointers
}

/// Tells whether the compiler has values of a type.
fn has(ty: ElementaryType) -> bool {
    !ty.is_third_edition() && ty != ElementaryType::Wstring
}

/// Returns the statement that sets the clock, in seconds and nanoseconds of the same sign.
fn set_clock(nanoseconds: i64) -> String {
    let (seconds, rest) = (nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000);
    format!("__CURRENT_TIME = (TIME){{{seconds}, {rest}}};")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Observation;
    use stickler_types::DialectName;

    #[test]
    fn several_programs_have_a_number_each_and_one_place() {
        let observe = [Observation::last("x", "INT")];
        let request = RunRequest::once(DialectName::MATIEC, "", &observe);
        let probes = ProbeVariables::of(&request);
        let subjects = ["first", "second"].map(|program| MatiecSubject::of(&request, &probes, program));
        let text = driver(&subjects).unwrap().text().text;
        for line in [
            "    union {\n        FIRST p0;\n        SECOND p1;\n    } program;\n",
            "static int run_1(void) {\n    SECOND_init__(&memory.program.p1, 0);\n    SECOND_body__(&memory.program.p1);\n    \
             printf(\"x = %d\\n\", (int)memory.program.p1.X.value);\n    return 0;\n}\n",
            "    case 1: return run_1();\n",
            "#define PROGRAMS 2\n",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
    }
}
