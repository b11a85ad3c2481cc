//! Writes the C++ program that runs a translated program and prints its observed values.
//!
//! Basis: strucpp: the C++ that it writes, and its run-time headers: a class for each program, its variables in upper case,
//! each with `get` but those of an alias or a subrange type, and the value of an enumeration with `to_int`; durations and
//! times of day are nanoseconds, dates days, both together nanoseconds.

use crate::RunRequest;
use crate::adapters::Compiler;
use crate::adapters::builder::CPP;
use crate::adapters::driver::{DrivenProgram, Driver, clock};
use crate::adapters::probe_variable::ProbeVariables;
use crate::adapters::source::own_configuration;
use crate::adapters::values::{self, ObservedKind, ValueExpression};
use stickler_types::ElementaryType;

/// The headers that every translated program includes; they are compiled once.
pub(super) const HEADER: &str = include_str!("driver/headers.hpp");

/// The C++ functions that read a variable: a class with `get`, or where its type is an alias or a subrange, a plain value. The
/// value of an enumeration is its number.
const VALUE_OF: &str = include_str!("driver/value_of.cpp");

/// A translated program that a driver runs: its request, the copies of observed values, and the name of its main program.
pub(super) struct StrucppSubject<'r> {
    request: RunRequest<'r>,
    pub(super) probes: ProbeVariables,
    kinds: Vec<ObservedKind<'r>>,
    program: String,
}

impl<'r> StrucppSubject<'r> {
    /// Returns the program of a request, whose main program has this name.
    ///
    /// # Errors
    /// A fragment that says what cannot be observed or set.
    pub(super) fn of(
        request: &RunRequest<'r>,
        probes: ProbeVariables,
        program: &str,
    ) -> Result<StrucppSubject<'r>, String> {
        Ok(StrucppSubject {
            request: *request,
            probes,
            kinds: values::kinds(request, |_| true)?,
            program: program.to_owned(),
        })
    }
}

/// Returns the driver of translated programs: of the only one in `program.cpp`, or of several in `program_0.cpp` and so on,
/// each in a namespace of its own.
pub(super) fn driver<'r>(subjects: &[&StrucppSubject<'r>]) -> Driver<'r> {
    let observes = subjects.iter().any(|subject| !subject.request.observe.is_empty());
    let printing = match observes {
        true => format!("#include <cstdio>\n#include <ctime>\n\n{VALUE_OF}"),
        false => "\n".to_owned(),
    };
    let (head, is_alone) = match subjects {
        [_] => (format!("#include \"program.cpp\"\n{printing}"), true),
        _ => (printing, false),
    };
    let programs = subjects.iter().enumerate();
    let programs = programs.map(|(number, subject)| driven(subject, number, is_alone));
    Driver {
        language: &CPP,
        head,
        programs: programs.collect(),
        compiler: Compiler::Strucpp,
    }
}

/// Returns a program as the driver runs it.
fn driven<'r>(subject: &StrucppSubject<'r>, number: usize, is_alone: bool) -> DrivenProgram<'r> {
    let StrucppSubject {
        request,
        probes,
        kinds,
        ..
    } = subject;
    let instance = instance(request, &subject.program);
    let namespace = format!("pack_{number}");
    let observed = request.observe.iter().zip(kinds);
    DrivenProgram {
        request: *request,
        kinds: kinds.clone(),
        declarations: match is_alone {
            true => format!("{instance}\n"),
            false => format!(
                "namespace {namespace} {{\nnamespace strucpp {{ using namespace ::strucpp; }}\n\
                 #include \"program_{number}.cpp\"\n{instance}"
            ),
        },
        start: Vec::new(),
        before: clock(request, |time| format!("strucpp::__CURRENT_TIME_NS = {time}LL;")),
        scan: "program.run();".to_owned(),
        after: observed
            .map(|(asked, kind)| {
                let value = expression(kind, place(probes.variable(asked)));
                (asked.after, values::statement(asked, kind, &value))
            })
            .collect(),
        namespace: (!is_alone).then_some(namespace),
    }
}

/// Returns the expression for the value of a variable.
fn expression(kind: &ObservedKind<'_>, variable: String) -> ValueExpression {
    match kind {
        ObservedKind::Elementary(ElementaryType::Date | ElementaryType::Ldate) => {
            ValueExpression::Days(variable)
        }
        ObservedKind::Elementary(ty) if ty.is_moment() => ValueExpression::Nanoseconds(variable),
        ObservedKind::Elementary(ty) if ty.is_text() => ValueExpression::Text {
            condition: format!("at < {variable}.length()"),
            unit: match ty {
                ElementaryType::Wstring => format!("{variable}[at]"),
                _ => format!("(unsigned char){variable}[at]"),
            },
        },
        _ => ValueExpression::Number(variable),
    }
}

/// Returns the declaration of `program`, the main program of a source text: an instance of its class, or where the text brings a
/// configuration, the one that this has, with the global variables that it takes from there.
fn instance(request: &RunRequest<'_>, program: &str) -> String {
    let class = format!("strucpp::Program_{}", program.to_ascii_uppercase());
    match own_configuration(request, program) {
        None => format!("static {class} program;\n"),
        Some(own) => format!(
            "static strucpp::Configuration_{} configuration;\nstatic {class} &program = configuration.{};\n",
            own.name.to_ascii_uppercase(),
            own.instance.to_ascii_uppercase()
        ),
    }
}

/// Returns the C++ expression for the value of a variable of the program.
fn place(variable: &str) -> String {
    format!("value_of(program.{}, 0)", variable.to_ascii_uppercase())
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    #[test]
    fn several_programs_have_a_namespace_each() {
        let request = RunRequest::once(DialectName::STRUCPP, "", &[]);
        let subject = StrucppSubject::of(&request, ProbeVariables::of(&request), "main").unwrap();
        let text = driver(&[&subject, &subject]).text().text;
        for line in [
            "namespace pack_1 {\nnamespace strucpp { using namespace ::strucpp; }\n#include \"program_1.cpp\"\n\
             static strucpp::Program_MAIN program;\nstatic int run_1(void) {\n    program.run();\n    return 0;\n}\n}\n",
            "    case 1: return pack_1::run_1();\n",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
    }
}
