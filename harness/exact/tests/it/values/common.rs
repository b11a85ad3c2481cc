//! Helpers for the tests of single values.

use stickler_exact::{Signature, expected, signatures, value};
use stickler_types::{ConversionChoices, DialectName, Value};

/// Reads a typed literal.
pub fn literal(text: &str) -> Value {
    Value::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Returns the signature of a function that takes an operand of this type; the first if it has several result types.
pub fn taking(function: &str, operand: &Value, dialect: DialectName) -> Signature {
    signatures(function, dialect)
        .into_iter()
        .find(|signature| signature.operands[0].name() == operand.type_name())
        .unwrap_or_else(|| panic!("{function} takes no {operand}"))
}

/// Checks calls in a dialect: function, operand and result, both as typed literals.
#[track_caller]
pub fn check(dialect: DialectName, rows: &[(&str, &str, &str)]) {
    for (function, operand, result) in rows {
        let operand = literal(operand);
        let signature = taking(function, &operand, dialect);
        let given = expected(&signature, std::slice::from_ref(&operand), dialect).value;
        assert_eq!(given, literal(result), "{function}({operand}) is {given}");
    }
}

/// Checks calls by choices that no dialect makes: function, operand and result, both as typed literals.
#[track_caller]
pub fn check_by(choices: ConversionChoices, rows: &[(&str, &str, &str)]) {
    for (function, operand, result) in rows {
        let operand = literal(operand);
        let signature = taking(function, &operand, DialectName::IRONPLC_ED3);
        let given = value(&signature, std::slice::from_ref(&operand), &choices);
        assert_eq!(given, literal(result), "{function}({operand}) is {given}");
    }
}
