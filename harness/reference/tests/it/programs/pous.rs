//! Functions, function blocks and their parameters.

use super::support::{DIALECT, assert_values, assert_values_in};
use stickler_types::DialectName;

const SCALE: &str = "
FUNCTION SCALE : REAL
VAR_INPUT in : DINT; factor : REAL := 2.0; END_VAR
VAR_OUTPUT negative : BOOL; END_VAR
VAR calls : INT; END_VAR
    calls := calls + 1;
    negative := in < 0;
    SCALE := DINT_TO_REAL(in) * factor + INT_TO_REAL(calls) - 1.0;
END_FUNCTION
";

#[test]
fn a_function_takes_arguments_by_position_and_by_name() {
    let source = format!(
        "{SCALE} PROGRAM main VAR a, b : REAL; n : BOOL; i : INT := -3; END_VAR
         a := SCALE(i, 1.5); b := SCALE(in := i, negative => n); END_PROGRAM"
    );
    assert_values(&source, &["a = REAL#-4.5", "b = REAL#-6.0", "n = BOOL#TRUE"]);
}

#[test]
fn a_function_forgets_its_variables() {
    let source = format!(
        "{SCALE} PROGRAM main VAR a : REAL; END_VAR a := SCALE(in := 1) + SCALE(in := 1); END_PROGRAM"
    );
    assert_values(&source, &["a = REAL#4.0"]);
}

#[test]
fn instances_keep_their_own_variables() {
    let source = "
FUNCTION_BLOCK COUNTER
VAR_INPUT step : DINT := 1; END_VAR
VAR_OUTPUT count : DINT; END_VAR
    count := count + step;
END_FUNCTION_BLOCK
PROGRAM main
VAR first, second : COUNTER; many : ARRAY[1..2] OF COUNTER; i : INT := 7; out : LINT; END_VAR
    first(); first(); second(step := i); many[2](step := 5, count => out);
    i := DINT_TO_INT(second.count);
END_PROGRAM";
    let expected = [
        "first.count = DINT#2",
        "second.count = DINT#7",
        "many[1].count = DINT#0",
        "out = LINT#5",
        "i = INT#7",
    ];
    assert_values(source, &expected);
}

#[test]
fn an_in_out_variable_is_the_caller_s() {
    let source = "
FUNCTION SWAP : BOOL
VAR_IN_OUT a, b : INT; END_VAR
VAR t : INT; END_VAR
    t := a; a := b; b := t; SWAP := TRUE;
END_FUNCTION
FUNCTION_BLOCK FILLER
VAR_IN_OUT data : ARRAY[0..2] OF INT; END_VAR
VAR i : INT; END_VAR
    FOR i := 0 TO 2 DO data[i] := data[i] + i; END_FOR;
END_FUNCTION_BLOCK
PROGRAM main
VAR x : INT := 1; y : ARRAY[0..2] OF INT := [5, 6, 7]; done : BOOL; f : FILLER; END_VAR
    done := SWAP(x, y[1]); f(data := y);
END_PROGRAM";
    assert_values(
        source,
        &["x = INT#6", "y[0] = INT#5", "y[1] = INT#2", "y[2] = INT#9"],
    );
}

#[test]
fn globals_are_shared_by_all_programs_of_a_configuration() {
    let source = "
PROGRAM writer VAR_EXTERNAL total : DINT; END_VAR VAR n : DINT := 3; END_VAR total := total + n; END_PROGRAM
PROGRAM main VAR_EXTERNAL total : DINT; END_VAR VAR seen : DINT; END_VAR seen := total; END_PROGRAM
CONFIGURATION plant
VAR_GLOBAL total : DINT := 10; END_VAR
RESOURCE cpu ON PLC
    TASK slow(INTERVAL := T#100ms, PRIORITY := 1);
    PROGRAM w WITH slow : writer;
    PROGRAM m WITH slow : main;
END_RESOURCE
END_CONFIGURATION";
    assert_values(source, &["seen = DINT#13", "total = DINT#13"]);
}

#[test]
fn the_documents_example_of_widening_runs() {
    let source = "
FUNCTION TAKES_DINT : BOOL
VAR_INPUT
    in : DINT;
END_VAR
    TAKES_DINT := in > 0;
END_FUNCTION
PROGRAM main
VAR
    i : INT := 5;
    r : BOOL;
END_VAR
    (* Accepted: INT widens to DINT *)
    r := TAKES_DINT(in := i);
END_PROGRAM";
    for dialect in [
        DIALECT,
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_RUSTY,
        DialectName::PLCNEXT,
    ] {
        assert_values_in(dialect, source, &["r = BOOL#TRUE"]);
    }
}
