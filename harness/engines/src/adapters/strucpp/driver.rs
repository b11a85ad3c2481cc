//! Writes the C++ program that runs a translated program and prints its observed values.
//!
//! Basis: strucpp: the C++ that it writes, and its run-time headers: a class for each program, its variables in upper case,
//! each with `get` but those of an alias or a subrange type; durations and times of day are nanoseconds, dates days, both together
//! nanoseconds.

use crate::RunRequest;
use crate::adapters::driver::{self, DrivenProgram, Driver};
use crate::adapters::printed::{self, PrintedKind};
use crate::adapters::probe_variable::ProbeVariables;
use crate::adapters::source::own_configuration;
use std::fmt::Write;
use stickler_types::{ElementaryType, Fault, Value};

/// The exit code by which the driver reports a subscript outside its array.
const SUBSCRIPT: i32 = 3;

/// A day in nanoseconds.
const DAY: i128 = 86_400_000_000_000;

/// The headers that every translated program includes; they are compiled once.
pub(super) const HEADER: &str = include_str!("driver/headers.hpp");

/// The C++ functions that read a variable: a class with `get`, or where its type is an alias or a subrange, a plain value.
pub(super) const VALUE_OF: &str = include_str!("driver/value_of.cpp");

/// The C++ functions that print values, one for each printed form.
const PRINTERS: &str = include_str!("driver/printers.cpp");

/// A translated program that a driver runs: its request, the copies of observed values, and the name of its main program.
pub(super) struct StrucppSubject<'r> {
    pub(super) request: RunRequest<'r>,
    pub(super) probes: ProbeVariables,
    pub(super) program: String,
}

/// Returns the driver of translated programs: of the only one in `program.cpp`, or of several in `program_0.cpp` and so on,
/// each in a namespace of its own.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn driver<'r>(subjects: &[&StrucppSubject<'r>]) -> Result<Driver<'r>, String> {
    let mut text = format!("#include \"stickler.hpp\"\n{VALUE_OF}{PRINTERS}");
    let mut driven = Vec::with_capacity(subjects.len());
    for (number, subject) in subjects.iter().enumerate() {
        let kinds = kinds(&subject.request)?;
        if subjects.len() > 1 {
            // Writing into a String does not fail.
            let _ = write!(
                text,
                "namespace pack_{number} {{\nnamespace strucpp {{ using namespace ::strucpp; }}\n\
                 #include \"program_{number}.cpp\"\n"
            );
            write_run(&mut text, subject, &kinds);
            text.push_str("}\n");
        } else {
            text.push_str("#include \"program.cpp\"\n");
            write_run(&mut text, subject, &kinds);
        }
        driven.push(DrivenProgram {
            request: subject.request,
            kinds,
        });
    }
    let several = subjects.len() > 1;
    text.push_str(&driver::main(subjects.len(), |number| match several {
        true => format!("pack_{number}::run_subject()"),
        false => "run_subject()".to_owned(),
    }));
    Ok(Driver {
        text,
        subjects: driven,
        read: value,
        faults: &[(SUBSCRIPT, Fault::SubscriptRange)],
    })
}

/// Returns the kinds of the observed values.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn kinds<'r>(request: &RunRequest<'r>) -> Result<Vec<PrintedKind<'r>>, String> {
    if !request.set.is_empty() {
        return Err("its driver writes no variables between scans".to_owned());
    }
    printed::kinds(request, |_| true)
}

/// Writes the functions that run a program and print the values observed after a scan; 0 stands for the end.
fn write_run(text: &mut String, subject: &StrucppSubject<'_>, kinds: &[PrintedKind<'_>]) {
    text.push_str(&instance(&subject.request, &subject.program));
    text.push_str("static void look(unsigned long scan) {\n");
    for (number, (asked, kind)) in subject.request.observe.iter().zip(kinds).enumerate() {
        let variable = place(subject.probes.variable(asked));
        let printer = match kind {
            PrintedKind::Elementary(ty) if ty.is_text() => "print_text",
            _ => "print_bits",
        };
        let _ = writeln!(
            text,
            "    if (scan == {}UL) {printer}({number}, {variable});",
            asked.after.unwrap_or(0)
        );
    }
    let _ = write!(
        text,
        "}}\nstatic int run_subject() try {{\n    for (unsigned long scan = 1; scan <= {}UL; scan++) {{\n",
        subject.request.scans
    );
    for (scan, statement) in before(&subject.request) {
        let _ = writeln!(text, "        if (scan == {scan}UL) {statement}");
    }
    let _ = write!(
        text,
        "        program.run();\n        look(scan);\n    }}\n    look(0);\n    return 0;\n\
         }} catch (const std::out_of_range &) {{\n    return {SUBSCRIPT};\n}}\n"
    );
}

/// Returns the declaration of `program`, the main program of a source text: an instance of its class, or where the text brings a
/// configuration, the one that this has, with the global variables that it takes from there.
pub(super) fn instance(request: &RunRequest<'_>, program: &str) -> String {
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
pub(super) fn place(variable: &str) -> String {
    format!("value_of(program.{}, 0)", variable.to_ascii_uppercase())
}

/// Returns the statements before scans, which advance the clock, each with the number of its scan.
pub(super) fn before(request: &RunRequest<'_>) -> Vec<(u32, String)> {
    let clock = request.clock.iter();
    clock
        .map(|step| {
            (
                step.before,
                format!("strucpp::__CURRENT_TIME_NS = {}LL;", step.nanoseconds),
            )
        })
        .collect()
}

/// Parses a printed value; `None` where the text is no such value.
fn value(kind: &PrintedKind<'_>, shown: &str) -> Option<Value> {
    let bits = || u64::from_str_radix(shown, 16).ok();
    match kind {
        PrintedKind::Enumerated(..) => kind.enumerated(bits()?),
        PrintedKind::Elementary(ty @ (ElementaryType::Date | ElementaryType::Ldate)) => {
            let days = i128::from(bits()?.cast_signed());
            Some(Value::of_nanoseconds(*ty, days * DAY))
        }
        PrintedKind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => {
            Some(Value::plain(*ty, bits()?))
        }
        PrintedKind::Elementary(ty) if ty.is_text() => {
            Some(Value::text(*ty, printed::units(shown.strip_prefix('\'')?)?))
        }
        PrintedKind::Elementary(ty) => Some(Value::plain(*ty, printed::raw(*ty, bits()?))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClockSetting, Observation};
    use stickler_types::DialectName;

    #[test]
    fn a_configuration_of_the_program_is_used() {
        let source = "PROGRAM main ; END_PROGRAM CONFIGURATION c RESOURCE r ON PLC PROGRAM i : main; END_RESOURCE END_CONFIGURATION";
        assert_eq!(
            instance(&RunRequest::once(DialectName::STRUCPP, source, &[]), "main"),
            "static strucpp::Configuration_C configuration;\nstatic strucpp::Program_MAIN &program = configuration.I;\n"
        );
    }

    #[test]
    fn values_are_read_as_the_driver_prints_them() {
        let observe = [
            "i INT",
            "r LREAL",
            "t TIME",
            "s STRING",
            "w WSTRING",
            "d DATE",
            "l[1] BYTE",
        ]
        .map(|asked| {
            let (name, type_name) = asked.split_once(' ').unwrap();
            Observation::last(name, type_name)
        });
        let request = RunRequest {
            dialect: DialectName::STRUCPP,
            source: "",
            scans: 2,
            observe: &observe,
            clock: &[ClockSetting {
                before: 2,
                nanoseconds: 5,
            }],
            set: &[],
        };
        let subject = StrucppSubject {
            request,
            probes: ProbeVariables::of(&request),
            program: "main".to_owned(),
        };
        let both = driver(&[&subject, &subject]).unwrap();
        for line in [
            "namespace pack_1 {",
            "#include \"program_1.cpp\"",
            "case 1: return pack_1::run_subject();",
        ] {
            assert!(both.text.contains(line), "{line}\n{}", both.text);
        }
        let driver = driver(&[&subject]).unwrap();
        for line in [
            "static strucpp::Program_MAIN program;",
            "if (scan == 0UL) print_text(3, value_of(program.S, 0));",
            "if (scan == 0UL) print_bits(6, value_of(program.STICKLER_PROBE_0, 0));",
            "if (scan == 2UL) strucpp::__CURRENT_TIME_NS = 5LL;",
        ] {
            assert!(driver.text.contains(line), "{line}\n{}", driver.text);
        }
        let printed = "0 ffff\n1 3ff8000000000000\n2 59682f00\n3 '00610027\n4 '00e4\n5 4d46\n6 ff\n";
        let values = driver.values(printed, &driver.subjects[0]).unwrap();
        let values: Vec<String> = values
            .iter()
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        assert_eq!(
            values,
            [
                "i=INT#-1",
                "r=LREAL#1.5",
                "t=TIME#1500ms",
                "s=STRING#'a$''",
                "w=WSTRING#\"$00E4\"",
                "d=DATE#2024-02-29",
                "l[1]=BYTE#16#FF"
            ]
        );
        for nonsense in ["0 ffff\n", "9 0\n", "0\n", "3 61\n"] {
            assert!(
                driver.values(nonsense, &driver.subjects[0]).is_err(),
                "{nonsense}"
            );
        }
    }
}
