//! Faults: what stops, on which line, and what remains.

use super::support::{assert_body, assert_fault, program};
use stickler_types::Fault;

#[test]
fn dividing_by_zero_faults_on_its_line() {
    let source = program("a : INT := 7; b : INT; z : INT;", "b := 1;\na := a / z;\nb := 2;");
    assert_fault(&source, (Fault::DivisionByZero, 6), &["a = INT#7", "b = INT#1"]);
    let source = program("a : UDINT := 7; z : UDINT;", "a := a MOD z;");
    assert_fault(&source, (Fault::DivisionByZero, 5), &["a = UDINT#7"]);
}

#[test]
fn a_subscript_outside_its_dimension_faults() {
    let declarations = "a : ARRAY[1..3, -1..1] OF INT; i : INT := 4; u : ULINT := 18446744073709551615;";
    let source = program(declarations, "a[3, 1] := 9;\na[i, 0] := 1;");
    assert_fault(&source, (Fault::SubscriptRange, 6), &["a[3,1] = INT#9"]);
    let source = program(declarations, "a[1, u] := 1;");
    assert_fault(&source, (Fault::SubscriptRange, 5), &[]);
    assert_body(declarations, "a[i - 1, -1] := 5;", &["a[3,-1] = INT#5"]);
}

#[test]
fn a_subrange_is_guarded() {
    let source = program("p : INT(0..100) := 99; n : INT := 2;", "p := p + 1;\np := p + n;");
    assert_fault(&source, (Fault::Subrange, 6), &["p = INT#100"]);
}

#[test]
fn an_endless_loop_ends() {
    let source = program("n : LINT;", "WHILE TRUE DO\n  n := n + 1;\nEND_WHILE;");
    let outcome = super::support::attempt(super::support::DIALECT, &source, &[]);
    let ended = matches!(
        outcome,
        Ok(stickler_types::Outcome::Faulted {
            fault: Fault::StepLimit,
            line: Some(5..=7),
            ..
        })
    );
    assert!(ended, "{outcome:?}");
}

#[test]
fn a_fault_inside_a_function_has_the_function_s_line() {
    let source = "FUNCTION RATIO : INT\nVAR_INPUT a, b : INT; END_VAR\n    RATIO := a / b;\nEND_FUNCTION
PROGRAM main VAR x : INT := 5; z : INT; END_VAR\n    x := RATIO(x, z);\nEND_PROGRAM";
    assert_fault(source, (Fault::DivisionByZero, 3), &["x = INT#5"]);
}

#[test]
fn an_initial_value_may_fault() {
    let source = "PROGRAM main\nVAR z : INT; n : INT := 4;\n  q : INT := n / z; END_VAR\nEND_PROGRAM";
    assert_fault(source, (Fault::DivisionByZero, 3), &["n = INT#4"]);
}
