//! Conversions inside expressions with implicit conversion around them, which only IronPLC's page describes.

use crate::call::Call;
use crate::inputs::integers::{ascending, limits};
use crate::operand::Operand;
use crate::sheet::owned;
use crate::table::{Probe, Table};
use stickler_types::DialectName::IronplcEd3;
use stickler_types::ElementaryType::{
    self, Byte, Dint, Dword, Int, Lint, Lreal, Lword, Real, Sint, Udint, Uint, Ulint, Usint, Word,
};

const IMPLICIT: &str = "ironplc-type-conversions: Implicit Type Widening";
const MATRICES: [&[(ElementaryType, ElementaryType)]; 3] = [
    &[
        (Sint, Int),
        (Sint, Lint),
        (Int, Dint),
        (Dint, Lint),
        (Usint, Int),
        (Uint, Dint),
        (Udint, Ulint),
        (Udint, Lint),
    ],
    &[
        (Sint, Real),
        (Int, Real),
        (Uint, Real),
        (Dint, Lreal),
        (Udint, Lreal),
    ],
    &[(Byte, Word), (Byte, Lword), (Word, Dword), (Dword, Lword)],
];

/// Types from which the tables convert.
const SOURCES: [ElementaryType; 4] = [Int, Lint, Ulint, Dword];

/// The tables of this family.
///
/// # Errors
/// A sentence, where no document says what a step gives.
pub fn tables() -> Result<Vec<Table>, String> {
    Ok(vec![results()?, arguments()?, operands()?])
}

fn table(name: &str, title: &str, columns: &[&str], rows: Vec<Vec<String>>, probes: Vec<Probe>) -> Table {
    Table {
        name: name.to_owned(),
        title: title.to_owned(),
        basis: IMPLICIT.to_owned(),
        dialects: owned(&["ironplc-ed3", "matiec"]),
        summary: "Elsewhere nothing widens by itself, so that the same program is rejected.".to_owned(),
        columns: owned(columns),
        rows,
        probes,
    }
}

fn widened(source: &str) -> Probe {
    Probe {
        name: "widened".to_owned(),
        observe: "into".to_owned(),
        expect: "{expected}".to_owned(),
        dialects: owned(&["ironplc-ed3"]),
        source: source.to_owned(),
        ..Probe::default()
    }
}

/// The same program where nothing widens, for one input of each pair of types.
fn rejected(source: &str, code: &str) -> Probe {
    Probe {
        name: "rejected".to_owned(),
        basis: "forgeiec-conversion-functions: matiec conformance".to_owned(),
        dialects: owned(&["matiec"]),
        source: source.replacen(");\n", &format!(");   (*! error {code} *)\n"), 1),
        ..Probe::default()
    }
}

/// What a call gives in IronPLC.
fn step(call: &Call) -> Result<Operand, String> {
    let said = call.expected(IronplcEd3);
    let said = said.filter(|said| said.basis.is_some());
    let value = said
        .ok_or_else(|| format!("no document says what {call} gives"))?
        .value;
    Ok(Operand::of(value))
}

/// Some numbers of a type, among them what a narrower one does not hold.
fn some(from: ElementaryType, through: ElementaryType) -> Vec<Operand> {
    ascending(from, [limits(from).0, 100, limits(through).1 + 1, limits(from).1])
}

const RESULT: &str = "\
PROGRAM main
VAR
    data : {from} := {input};
    into : {wide};
END_VAR
    into := {from}_TO_{narrow}(data);
END_PROGRAM
";

fn results() -> Result<Table, String> {
    let mut rows = Vec::new();
    for (narrow, wide) in MATRICES.concat() {
        for from in SOURCES.into_iter().filter(|from| *from != narrow) {
            for operand in some(from, narrow) {
                let literal = operand.literal.clone();
                let converted = step(&Call::convert(from, narrow, operand))?;
                let arrived = step(&Call::convert(narrow, wide, converted))?;
                rows.push(owned(&[
                    from.name(),
                    narrow.name(),
                    wide.name(),
                    &literal,
                    &arrived.typed,
                ]));
            }
        }
    }
    Ok(table(
        "expression-result-widens",
        "The result of a conversion widens to its target after it was wrapped",
        &["from", "narrow", "wide", "input", "expected"],
        rows,
        vec![widened(RESULT), rejected(RESULT, "P4027")],
    ))
}

const ARGUMENT: &str = "\
PROGRAM main
VAR
    data : {narrow} := {input};
    into : {to};
END_VAR
    into := {wide}_TO_{to}(data);
END_PROGRAM
";

fn arguments() -> Result<Table, String> {
    let mut rows = Vec::new();
    for (narrow, wide) in MATRICES.concat() {
        for to in [Usint, Int, Udint, Lreal]
            .into_iter()
            .filter(|to| *to != wide && !(wide.is_bit_string() && to.is_real()))
        {
            for operand in ascending(narrow, [limits(narrow).0, 100, limits(narrow).1]) {
                let literal = operand.literal.clone();
                let passed = step(&Call::convert(narrow, wide, operand))?;
                let call = Call::convert(wide, to, passed);
                // What a real outside the target gives IronPLC's page does not say.
                if let Ok(arrived) = step(&call) {
                    rows.push(owned(&[
                        narrow.name(),
                        wide.name(),
                        to.name(),
                        &literal,
                        &arrived.typed,
                    ]));
                }
            }
        }
    }
    Ok(table(
        "expression-argument-widens",
        "The argument of a conversion widens to its parameter first",
        &["narrow", "wide", "to", "input", "expected"],
        rows,
        vec![widened(ARGUMENT), rejected(ARGUMENT, "P4026")],
    ))
}

const OPERAND: &str = "\
PROGRAM main
VAR
    data : {from} := {input};
    wide : {wide} := 1;
    into : {wide};
END_VAR
    into := wide + {from}_TO_{narrow}(data);
END_PROGRAM
";

fn operands() -> Result<Table, String> {
    let mut rows = Vec::new();
    let integers = MATRICES[0].iter().copied();
    for (narrow, wide) in integers {
        for from in SOURCES.into_iter().filter(|from| *from != narrow) {
            for operand in some(from, narrow) {
                let literal = operand.literal.clone();
                let converted = step(&Call::convert(from, narrow, operand))?;
                // Every narrower number has a successor in the wider type.
                let sum = narrow.integer_value(converted.raw()) + 1;
                rows.push(owned(&[
                    from.name(),
                    narrow.name(),
                    wide.name(),
                    &literal,
                    &Operand::number(wide, sum).typed,
                ]));
            }
        }
    }
    Ok(table(
        "expression-operand-widens",
        "The result of a conversion widens to the other operand, and is added there without overflow",
        &["from", "narrow", "wide", "input", "expected"],
        rows,
        vec![widened(OPERAND), rejected(OPERAND, "P4049")],
    ))
}
