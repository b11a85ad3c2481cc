//! The programs that ask: one that counts and adds up, one that counts and tells each result, one that lists operands.

use super::plan::Counting;
use crate::literals;
use std::fmt::Write;
use std::ops::Range;
use stickler_exact::Signature;
use stickler_types::{ElementaryType, Value};

/// The longest text that a STRING of default length holds in every system.
const DEFAULT_LENGTH: usize = 80;

/// A source text, and the variables in which its results are.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Program {
    /// The text.
    pub source: String,
    /// The names of the variables.
    pub observed: Vec<String>,
    /// Their type.
    pub ty: ElementaryType,
}

/// A program that adds up the results for the operands at these places of a stretch; there must be fewer than 2^31.
#[must_use]
pub fn summed(signature: &Signature, counting: &Counting, places: &Range<u64>) -> Program {
    let Signature { function, result, .. } = signature;
    let inputs = places.end - places.start;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let making = if making.is_empty() {
        making
    } else {
        format!("        {making}\n")
    };
    let source = format!(
        "PROGRAM main\nVAR\n{}    given  : {result};\n    passed : DINT := DINT#0;\n{}END_VAR\n    REPEAT\n\
         {making}        given := {function}(operand);\n{}        passed := passed + DINT#1;\n        \
         IF passed < DINT#{inputs} THEN\n            {advancing}\n        END_IF;\n    \
         UNTIL passed >= DINT#{inputs}\n    END_REPEAT;\nEND_PROGRAM\n",
        counting.counter.declarations(places.start),
        counting.checksum.declarations(),
        counting.checksum.statements(),
    );
    Program {
        source,
        observed: vec!["total".to_owned()],
        ty: ElementaryType::Lint,
    }
}

/// A program that counts through these places of a stretch in the same way, and keeps each result for itself.
#[must_use]
pub fn unrolled(signature: &Signature, counting: &Counting, places: &Range<u64>) -> Program {
    let Signature { function, result, .. } = signature;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let observed: Vec<String> = (1..=places.end - places.start)
        .map(|number| format!("given{number}"))
        .collect();
    let mut source = format!(
        "PROGRAM main\nVAR\n{}",
        counting.counter.declarations(places.start)
    );
    // Writing to a String cannot fail, here and below.
    for name in &observed {
        let _ = writeln!(source, "    {name} : {result};");
    }
    source.push_str("END_VAR\n");
    for (index, name) in observed.iter().enumerate() {
        if index > 0 {
            let _ = writeln!(source, "    {advancing}");
        }
        if !making.is_empty() {
            let _ = writeln!(source, "    {making}");
        }
        let _ = writeln!(source, "    {name} := {function}(operand);");
    }
    source.push_str("END_PROGRAM\n");
    Program {
        source,
        observed,
        ty: *result,
    }
}

/// A program that calls the function with each of these operands; `None` where one of them has no literal.
#[must_use]
pub fn listed(signature: &Signature, calls: &[Vec<Value>]) -> Option<Program> {
    let Signature { function, result, .. } = signature;
    let (mut declarations, mut statements) = (String::new(), String::new());
    let mut observed = Vec::with_capacity(calls.len());
    for (number, call) in (1..).zip(calls) {
        let mut arguments = Vec::with_capacity(call.len());
        for (value, letter) in call.iter().zip(["a", "b"]) {
            let name = format!("operand{number}{letter}");
            let (ty, literal) = (
                declared(value.type_name(), longest(call)),
                literals::literal(value)?,
            );
            let _ = writeln!(declarations, "    {name} : {ty} := {literal};");
            arguments.push(name);
        }
        let name = format!("given{number}");
        let ty = match result.is_text() {
            true => declared(result.name(), longest(call)),
            false => result.name().to_owned(),
        };
        let _ = writeln!(declarations, "    {name} : {ty};");
        let _ = writeln!(statements, "    {name} := {function}({});", arguments.join(", "));
        observed.push(name);
    }
    Some(Program {
        source: format!("PROGRAM main\nVAR\n{declarations}END_VAR\n{statements}END_PROGRAM\n"),
        observed,
        ty: *result,
    })
}

/// How many characters the longest text has.
fn longest(call: &[Value]) -> usize {
    let lengths = call.iter().map(|value| match value {
        Value::Text { units, .. } => units.len(),
        _ => 0,
    });
    lengths.max().unwrap_or(0)
}

/// A type as a declaration has it: with a length only where it is a text too long for every system.
fn declared(ty: &str, length: usize) -> String {
    match length {
        ..=DEFAULT_LENGTH => ty.to_owned(),
        _ => format!("{ty}[{length}]"),
    }
}
