//! Tests sessions of functions: what no literal says, and what an engine refuses.

use stickler_conversions::{FunctionSession, Refusal, RefusalKind};
use stickler_engines::{ClosureEngine, Engine, Outcome, Reference};
use stickler_types::{DialectName, Value};

fn value(literal: &str) -> Value {
    Value::parse(literal).unwrap()
}

/// Returns what an engine gives for some operands of a function in matiec.
fn results(engine: &dyn Engine, function: &str, operands: &[&str]) -> Vec<Result<Value, Refusal>> {
    let signature = &stickler_exact::signatures(function, DialectName::MATIEC)[0];
    let calls: Vec<_> = operands.iter().map(|literal| vec![value(literal)]).collect();
    FunctionSession::open(engine)
        .unwrap()
        .results(DialectName::MATIEC, signature, &calls)
}

#[test]
fn what_no_literal_says_is_computed_in_the_program() {
    let operands = ["REAL#NaN", "REAL#Infinity", "REAL#-Infinity", "REAL#-0.0"];
    let results = results(&Reference::default(), "REAL_TO_LREAL", &operands);
    let expected = ["LREAL#NaN", "LREAL#Infinity", "LREAL#-Infinity", "LREAL#-0.0"];
    assert_eq!(results, expected.map(|literal| Ok(value(literal))));
}

#[test]
fn a_sign_that_a_literal_cannot_have_hides_no_result() {
    // Reads no sign behind the type of a literal.
    let engine = ClosureEngine::new("reference", |reference, request| {
        match request.source.contains("#-") {
            true => Outcome::rejected(Vec::new()),
            false => reference.run(request),
        }
    });
    for (function, operands, expected) in [
        ("REAL_TO_INT", ["REAL#-2.5", "REAL#1.0"], ["INT#-2", "INT#1"]),
        ("SINT_TO_INT", ["SINT#-128", "SINT#5"], ["INT#-128", "INT#5"]),
    ] {
        let given = results(&engine, function, &operands);
        assert_eq!(given, expected.map(|result| Ok(value(result))));
    }
}

#[test]
fn a_call_that_is_rejected_does_not_take_the_others_with_it() {
    // An enumeration is no operand of any conversion function.
    let results = results(&Reference::default(), "INT_TO_DINT", &["INT#5", "COLOR#RED"]);
    assert_eq!(results[0], Ok(value("DINT#5")));
    assert_eq!(results[1].clone().unwrap_err().kind, RefusalKind::Rejected);
}
