//! Writes programs that call a conversion function with a list of operands.

use stickler_engines::Observation;
use stickler_types::{ElementaryType, Value};

/// The length, in characters, up to which a STRING of default length holds a text in every system.
const DEFAULT_LENGTH: usize = 80;

/// A program, and the variables that hold its results.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConversionProgram {
    /// The declarations of its variables, one on each line.
    pub declarations: String,
    /// The statements, one on each line.
    pub statements: String,
    /// The names of the variables that hold the results.
    pub observed: Vec<String>,
    /// The type of these variables.
    pub ty: ElementaryType,
}

impl ConversionProgram {
    /// Returns the source text.
    pub fn source(&self) -> String {
        let (declarations, statements) = (&self.declarations, &self.statements);
        format!("PROGRAM main\nVAR\n{declarations}END_VAR\n{statements}END_PROGRAM\n")
    }

    /// Returns what is asked of an engine that runs the program: the values of its results at the end.
    pub fn observations(&self) -> Vec<Observation> {
        let names = self.observed.iter();
        names
            .map(|name| Observation::last(name, self.ty.name()))
            .collect()
    }
}

/// Writes a program that calls the function with each of these operands, which `literal` writes as initial values.
///
/// NaN and the infinities, which have no literal, are computed before the calls: an engine that computes them otherwise
/// than IEC 60559 gives the function other operands.
pub fn listed(
    function: &str,
    result: ElementaryType,
    calls: &[Vec<Value>],
    literal: fn(&Value) -> String,
) -> ConversionProgram {
    let (mut declarations, mut statements) = infinity(calls);
    let mut observed = Vec::with_capacity(calls.len());
    for (number, call) in (1..).zip(calls) {
        let mut arguments = Vec::with_capacity(call.len());
        for (value, letter) in call.iter().zip(["a", "b"]) {
            let name = format!("operand{number}{letter}");
            let ty = declared(value.type_name(), longest(call));
            declarations.push_str(&match not_finite(value) {
                Some(term) => {
                    statements.push_str(&format!("    {name} := {term};\n"));
                    format!("    {name} : {ty};\n")
                }
                None => format!("    {name} : {ty} := {};\n", literal(value)),
            });
            arguments.push(name);
        }
        let name = format!("given{number}");
        let ty = match result.is_text() {
            true => declared(result.name(), longest(call)),
            false => result.name().to_owned(),
        };
        declarations.push_str(&format!("    {name} : {ty};\n"));
        statements.push_str(&format!("    {name} := {function}({});\n", arguments.join(", ")));
        observed.push(name);
    }
    ConversionProgram {
        declarations,
        statements,
        observed,
        ty: result,
    }
}

/// Returns the expression that computes a NaN or an infinity from the variable `infinite`; `None` for finite values.
fn not_finite(value: &Value) -> Option<&'static str> {
    match value.real()? {
        number if number.is_nan() => Some("infinite - infinite"),
        f64::INFINITY => Some("infinite"),
        f64::NEG_INFINITY => Some("-infinite"),
        _ => None,
    }
}

/// Returns the declarations and the statement that compute `infinite`; both empty where no call needs it.
fn infinity(calls: &[Vec<Value>]) -> (String, String) {
    let mut operands = calls.iter().flatten();
    let Some(operand) = operands.find(|value| not_finite(value).is_some()) else {
        return (String::new(), String::new());
    };
    let ty = operand.type_name();
    let large = if ty == ElementaryType::Real.name() {
        "3.0E38"
    } else {
        "1.0E308"
    };
    (
        format!("    large : {ty} := {ty}#{large};\n    infinite : {ty};\n"),
        "    infinite := large * large;\n".to_owned(),
    )
}

/// Returns the number of characters of the longest text among the operands of a call.
fn longest(call: &[Value]) -> usize {
    let lengths = call.iter().map(|value| match value {
        Value::Text { units, .. } => units.len(),
        _ => 0,
    });
    lengths.max().unwrap_or(0)
}

/// Returns a type for a declaration: with a length only where a text is longer than [`DEFAULT_LENGTH`].
fn declared(ty: &str, length: usize) -> String {
    match length {
        ..=DEFAULT_LENGTH => ty.to_owned(),
        _ => format!("{ty}[{length}]"),
    }
}
