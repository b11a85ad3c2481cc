//! Writes the C program that runs compiled programs, and the functions by which the programs show the observed values.
//!
//! The functions stand in a file of their own, so that the program under test is compiled as it is.
//!
//! Basis: rusty: book, *External Functions*: a function that is declared `{external}` is one of C; `VAR_INPUT {ref}` takes the
//! address. Integers and bit strings have their width, BOOL a byte, durations and dates are nanoseconds in 64 bits, texts end
//! with a zero. Access to the variables of a program from outside is a warning, E049.

use super::program::PackedProgram;
use crate::adapters::Compiler;
use crate::adapters::builder::C;
use crate::adapters::driver::{DrivenProgram, Driver};
use crate::adapters::values::{self, ObservedKind, ValueExpression};
use std::collections::BTreeMap;
use stickler_types::{ElementaryType, sorted};

/// The headers that the driver includes.
pub(super) const HEADER: &str =
    "#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n";

/// A driver, and the functions by which programs show it their values.
pub(super) struct RustyDriver<'r> {
    pub(super) driver: Driver<'r>,
    /// The functions of each program, in Structured Text.
    pub(super) functions: Vec<String>,
}

impl<'r> RustyDriver<'r> {
    /// Returns the driver of programs, the first of which is in the first file that the compiler is given. The function that sets
    /// the initial values of variables that the loader cannot set is named after that file.
    ///
    /// Basis: rusty: book, *Variables*, *Pointer Initialization*: a runtime has to call it. Linkers that know of constructors do
    /// so, too, and to do it again changes nothing.
    pub(super) fn of(programs: &[PackedProgram<'r>]) -> RustyDriver<'r> {
        let first = programs.first().map_or("", |first| &first.file);
        let initialise = format!("__init___{}", first.replace('.', "_"));
        let mut driver = Driver {
            language: &C,
            head: format!("{HEADER}#include <time.h>\n\n__attribute__((weak)) void {initialise}(void);\n\n"),
            programs: Vec::with_capacity(programs.len()),
            compiler: Compiler::Rusty,
        };
        let mut functions = Vec::with_capacity(programs.len());
        for (number, program) in programs.iter().enumerate() {
            let names = Names(match programs.len() {
                1 => "driver".to_owned(),
                _ => format!("driver_{number}"),
            });
            functions.push(names.functions(program));
            let start = format!("if ({initialise}) {initialise}();");
            driver.programs.push(names.driven(program, start));
        }
        RustyDriver { driver, functions }
    }

    /// Returns the number of the program whose functions have this line of all functions, from 1.
    pub(super) fn program_at(&self, line: u32) -> Option<usize> {
        let mut behind = 0;
        self.functions.iter().position(|functions| {
            behind += functions.matches('\n').count();
            line as usize <= behind
        })
    }
}

/// The names of the functions of one program, by what they begin with.
struct Names(String);

impl Names {
    fn scan(&self) -> String {
        format!("{}_scan", self.0)
    }

    /// Returns the name of the function of Structured Text that shows the values observed after a scan; `None` stands for the last.
    fn look(&self, after: Option<u32>) -> String {
        match after {
            Some(scan) => format!("{}_show_after_{scan}", self.0),
            None => format!("{}_show", self.0),
        }
    }

    /// Returns the name of the function of C that shows a value.
    fn show(&self, number: usize) -> String {
        format!("{}_show_{number}", self.0)
    }

    /// Returns the functions of Structured Text that pass the observed values to the driver.
    fn functions(&self, program: &PackedProgram<'_>) -> String {
        let main = program.main();
        let mut shown: BTreeMap<Option<u32>, String> = BTreeMap::from([(None, String::new())]);
        let mut external = String::new();
        for (number, (asked, kind)) in program.request.observe.iter().zip(&program.kinds).enumerate() {
            let (ty, show) = (shown_as(kind), self.show(number));
            let by = if ty.is_text() { " {ref}" } else { "" };
            let statements = shown.entry(asked.after).or_default();
            statements.push_str(&format!("  {show}({main}.{});\n", program.renamed(&asked.name)));
            external.push_str(&format!(
                "{{external}} FUNCTION {show} : DINT VAR_INPUT{by} value : {ty}; END_VAR END_FUNCTION\n"
            ));
        }
        let mut text = format!("FUNCTION {} : DINT\n  {main}();\nEND_FUNCTION\n", self.scan());
        for (after, statements) in shown {
            text.push_str(&format!(
                "FUNCTION {} : DINT\n{statements}END_FUNCTION\n",
                self.look(after)
            ));
        }
        text + &external
    }

    /// Returns a program as the driver runs it, with the functions of C that print its values.
    fn driven<'r>(&self, program: &PackedProgram<'r>, start: String) -> DrivenProgram<'r> {
        let request = program.request;
        let mut declarations = String::new();
        for (number, (asked, kind)) in request.observe.iter().zip(&program.kinds).enumerate() {
            declarations.push_str(&format!(
                "int32_t {}({}value) {{ {} return 0; }}\n",
                self.show(number),
                parameter(kind),
                values::statement(asked, kind, &expression(kind))
            ));
        }
        let after = sorted(request.observe.iter().map(|asked| asked.after).chain([None]));
        let scan = self.scan();
        declarations.push_str(&format!("\nint32_t {scan}(void);\n"));
        for after in &after {
            declarations.push_str(&format!("int32_t {}(void);\n", self.look(*after)));
        }
        declarations.push('\n');
        DrivenProgram {
            request,
            kinds: program.kinds.clone(),
            declarations,
            start: vec![start],
            before: Vec::new(),
            scan: format!("{scan}();"),
            after: after
                .into_iter()
                .map(|after| (after, format!("{}();", self.look(after))))
                .collect(),
            namespace: None,
        }
    }
}

/// Returns the type as which a value is shown. The values of an enumeration are numbers.
fn shown_as(kind: &ObservedKind<'_>) -> ElementaryType {
    match kind {
        ObservedKind::Elementary(ty) => *ty,
        ObservedKind::Enumerated(..) => ElementaryType::Dint,
    }
}

/// Returns the expression for a value in the function that prints it.
fn expression(kind: &ObservedKind<'_>) -> ValueExpression {
    let value = || "value".to_owned();
    match kind {
        ObservedKind::Elementary(ty) if ty.is_moment() => ValueExpression::Nanoseconds(value()),
        ObservedKind::Elementary(ty) if ty.is_text() => ValueExpression::Text {
            condition: "value[at]".to_owned(),
            unit: "value[at]".to_owned(),
        },
        _ => ValueExpression::Number(value()),
    }
}

/// Returns the C type of the parameter that takes a value, with the blank or star behind it. Numbers with a sign have one here.
fn parameter(kind: &ObservedKind<'_>) -> String {
    let ty = shown_as(kind);
    match ty {
        ElementaryType::String => "unsigned char *".to_owned(),
        ElementaryType::Wstring => "uint16_t *".to_owned(),
        _ if ty.is_signed() => format!("{} ", of_c(ty).trim_start_matches('u')),
        _ => format!("{} ", of_c(ty)),
    }
}

/// Returns the C type that has the bits of a value.
fn of_c(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Real => "float",
        ElementaryType::Lreal => "double",
        ElementaryType::Char => "uint8_t",
        ElementaryType::Wchar => "uint16_t",
        _ if ty.is_moment() => "int64_t",
        _ => match ty.bits() {
            0..=8 => "uint8_t",
            9..=16 => "uint16_t",
            17..=32 => "uint32_t",
            _ => "uint64_t",
        },
    }
}
