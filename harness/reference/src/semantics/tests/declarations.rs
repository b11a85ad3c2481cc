//! Declarations: names, duplicates, what is missing and what has no place.

use super::{ED2, ED3, PLCNEXT, RUSTY};
use super::{codes, gives, gives_in, says, says_in};

#[test]
fn names_are_declared_once() {
    for (text, code) in [
        ("PROGRAM p VAR a : INT;\nA : BOOL; END_VAR END_PROGRAM", "2 P4014"),
        (
            "PROGRAM p VAR a : INT; END_VAR VAR_INPUT\na : INT; END_VAR END_PROGRAM",
            "2 P4014",
        ),
        (
            "FUNCTION f : INT VAR_INPUT\nF : INT; END_VAR END_FUNCTION",
            "2 P4014",
        ),
        (
            "VAR_GLOBAL a : INT; END_VAR VAR_GLOBAL\na : INT; END_VAR",
            "2 P4014",
        ),
        (
            "FUNCTION f : INT END_FUNCTION\nFUNCTION F : INT END_FUNCTION",
            "2 P4016",
        ),
        ("PROGRAM f END_PROGRAM\nPROGRAM F END_PROGRAM", "2 P4013"),
        (
            "FUNCTION_BLOCK f END_FUNCTION_BLOCK\nFUNCTION_BLOCK f END_FUNCTION_BLOCK",
            "2 P4013",
        ),
        ("PROGRAM f END_PROGRAM\nFUNCTION f : INT END_FUNCTION", "2 P4011"),
        ("TYPE f : INT; END_TYPE\nFUNCTION f : INT END_FUNCTION", "2 P4011"),
        (
            "FUNCTION_BLOCK f END_FUNCTION_BLOCK\nTYPE f : INT; END_TYPE",
            "2 P4011",
        ),
        ("TYPE t : INT;\nT : BOOL; END_TYPE", "2 P2007"),
        (
            "TYPE t : STRUCT a : INT;\nA : BOOL; END_STRUCT; END_TYPE",
            "2 P2001",
        ),
        ("TYPE t : (A, B,\na); END_TYPE", "2 P2003"),
    ] {
        assert_eq!(says(text), [code], "{text}");
    }
}

#[test]
fn a_variable_may_hide_a_global_one_and_have_the_name_of_a_type_or_a_standard_function() {
    let text = "TYPE T : INT; END_TYPE VAR_GLOBAL g : INT; END_VAR FUNCTION f : INT END_FUNCTION
        PROGRAM main VAR g, t, abs, len : INT; x : T; END_VAR g := t + abs + x; END_PROGRAM";
    assert!(says(text).is_empty());
}

#[test]
fn types_are_looked_for_wherever_they_stand() {
    for (text, code) in [
        (
            "PROGRAM p VAR\na : NIX; END_VAR a := 1; a.b := a[3]; END_PROGRAM",
            "2 P2008",
        ),
        (
            "PROGRAM p VAR\na : ARRAY[0..1] OF NIX; END_VAR a[0] := 1; END_PROGRAM",
            "2 P2008",
        ),
        (
            "TYPE t : STRUCT\na : NIX; END_STRUCT; END_TYPE PROGRAM p VAR x : t; END_VAR x.a := 1; END_PROGRAM",
            "2 P2008",
        ),
        (
            "TYPE t :\nNIX; END_TYPE PROGRAM p VAR x : t; END_VAR x := 1; END_PROGRAM",
            "2 P2008",
        ),
        (
            "FUNCTION f :\nNIX VAR_INPUT a : INT; END_VAR f := a; END_FUNCTION",
            "2 P2008",
        ),
        (
            "FUNCTION f : INT VAR_IN_OUT\na : NIX; END_VAR f := a; END_FUNCTION",
            "2 P2008",
        ),
        (
            "FUNCTION f : INT VAR_INPUT\na : p; END_VAR f := a; END_FUNCTION PROGRAM p END_PROGRAM",
            "2 P2008",
        ),
        ("TYPE t :\nNIX(0..5); END_TYPE", "2 P2008"),
    ] {
        assert_eq!(says(text), [code], "{text}");
    }
}

#[test]
fn types_and_functions_may_stand_in_any_order() {
    gives(
        "PROGRAM main VAR p : PAIR; n : INT; f : OUTER; END_VAR p.a := 3; n := TWICE(p.a); f(); n := n + f.inner.q; END_PROGRAM
         FUNCTION_BLOCK OUTER VAR_OUTPUT inner : INNER; END_VAR inner(); END_FUNCTION_BLOCK
         FUNCTION TWICE : NUMBER VAR_INPUT x : NUMBER; END_VAR TWICE := 2 * x; END_FUNCTION
         TYPE PAIR : STRUCT a, b : NUMBER; END_STRUCT; NUMBER : INT; END_TYPE
         FUNCTION_BLOCK INNER VAR_OUTPUT q : INT := 10; END_VAR END_FUNCTION_BLOCK",
        &["n = INT#16"],
    );
}

#[test]
fn what_contains_itself_is_said_once() {
    for (text, expected) in [
        ("TYPE a :\nSTRUCT x : a; y : a; END_STRUCT; END_TYPE", "2 P2010"),
        ("TYPE a : b; b : c; c :\na; END_TYPE", "2 P2010"),
        (
            "TYPE a : STRUCT x : b; END_STRUCT; b : ARRAY[0..1] OF\na; END_TYPE",
            "2 P2010",
        ),
        (
            "FUNCTION_BLOCK f VAR\nx : f; END_VAR END_FUNCTION_BLOCK",
            "2 P4005",
        ),
        (
            "FUNCTION_BLOCK f VAR x : g; END_VAR END_FUNCTION_BLOCK FUNCTION_BLOCK g VAR\nx : ARRAY[0..1] OF f; END_VAR END_FUNCTION_BLOCK",
            "2 P4005",
        ),
    ] {
        assert_eq!(says(text), [expected], "{text}");
    }
    let by_reference = "FUNCTION_BLOCK f VAR_IN_OUT next : f; END_VAR VAR_OUTPUT n : INT; END_VAR n := next.n; END_FUNCTION_BLOCK";
    assert!(says(by_reference).is_empty());
}

#[test]
fn constants_need_a_value_and_function_blocks_are_none() {
    assert_eq!(
        says("PROGRAM p VAR CONSTANT\na, b : INT; END_VAR END_PROGRAM"),
        ["2 P4008"]
    );
    assert_eq!(says("VAR_GLOBAL CONSTANT\na : INT; END_VAR"), ["2 P4008"]);
    let used = "END_VAR VAR CONSTANT a : INT; END_VAR VAR b : ARRAY[0..a] OF INT;";
    assert_eq!(codes(used, ""), ["P4008", "P4032"]);
    let text = "FUNCTION f : INT VAR_IN_OUT a : INT :=
5; END_VAR f := a; END_FUNCTION";
    assert_eq!(says(text), ["2 P4022"]);
    let block = "FUNCTION_BLOCK f END_FUNCTION_BLOCK PROGRAM p VAR CONSTANT\nx : f; END_VAR END_PROGRAM";
    assert_eq!(says(block), ["2 P4009"]);
    let function = "FUNCTION_BLOCK f END_FUNCTION_BLOCK FUNCTION g : INT VAR\nx : f; END_VAR END_FUNCTION";
    assert_eq!(says(function), ["2 P4054"]);
    let array = "FUNCTION_BLOCK f END_FUNCTION_BLOCK FUNCTION g : INT VAR\nx : ARRAY[0..1] OF f; END_VAR END_FUNCTION";
    assert_eq!(says(array), ["2 P4054"]);
}

#[test]
fn initial_values_know_what_was_declared_before_them() {
    gives(
        "VAR_GLOBAL CONSTANT n : INT := 3; END_VAR VAR_GLOBAL g : INT := n * 2; h : INT := g + 1; END_VAR
         FUNCTION f : INT VAR_INPUT x : INT; END_VAR f := x * x; END_FUNCTION
         PROGRAM main VAR a : INT := 5; b : INT := a + 1; c : ARRAY[1..n] OF INT := [a, b, h]; d, e : INT := f(b); END_VAR END_PROGRAM",
        &["a = INT#5", "b = INT#6", "c[3] = INT#7", "d = INT#36", "e = INT#36"],
    );
    assert_eq!(codes("a : INT := b; b : INT;", ""), ["P4007"]);
    assert_eq!(codes("a : INT := a;", ""), ["P4007"]);
    let own = "END_VAR VAR CONSTANT a : INT := a; END_VAR VAR b : ARRAY[0..a] OF INT;";
    assert_eq!(codes(own, ""), ["P4007"]);
    let unfit = "END_VAR VAR CONSTANT a : SINT := 300; END_VAR VAR b : ARRAY[0..a] OF INT;";
    assert_eq!(codes(unfit, ""), ["P2026"]);
    let variable = "v : INT; END_VAR VAR CONSTANT a : INT := v; END_VAR VAR b : ARRAY[0..a] OF INT;";
    assert_eq!(codes(variable, ""), ["P4031"]);
    assert_eq!(says("VAR_GLOBAL\na : INT := b; b : INT; END_VAR"), ["2 P4007"]);
}

#[test]
fn initial_values_in_a_structure_know_the_constants_around_it() {
    let declare = |name: &str| {
        format!(
            "END_VAR VAR CONSTANT k : INT := 4; END_VAR VAR v : INT; s : STRUCT x : INT := {name}; END_STRUCT;"
        )
    };
    gives(
        &format!("PROGRAM main VAR {} END_VAR END_PROGRAM", declare("k * 2")),
        &["s.x = INT#8"],
    );
    assert_eq!(codes(&declare("v"), ""), ["P4007"]);
}

#[test]
fn a_common_initial_value_is_complained_about_once() {
    assert_eq!(codes("a, b, c : INT := 1.5;", ""), ["P4022"]);
    assert_eq!(codes("a, b, c : NIX := 5;", ""), ["P2008"]);
    assert_eq!(
        codes("a, b : STRUCT x, y : INT := 40000; END_STRUCT;", ""),
        ["P2026"]
    );
}

#[test]
fn initial_values_have_the_form_of_their_types() {
    for (variables, code) in [
        ("a : INT := [1];", "P4022"),
        ("a : INT := (x := 1);", "P4022"),
        ("a : ARRAY[0..1] OF INT := 5;", "P4022"),
        ("a : ARRAY[0..1] OF INT := [1, 2, 3];", "P4022"),
        ("a : ARRAY[0..1] OF INT := [3(1)];", "P4022"),
        ("a : ARRAY[0..1] OF INT := [1, TRUE];", "P4022"),
        ("a : ARRAY[0..1] OF INT := [1, 40000];", "P2026"),
        ("a : STRUCT x : INT; END_STRUCT := 5;", "P4022"),
        ("a : STRUCT x : INT; END_STRUCT := (y := 5);", "P4007"),
        ("a : STRUCT x : INT; END_STRUCT := (x := 5, x := 6);", "P2001"),
        ("a : STRUCT x : INT; END_STRUCT := (x := 1.5);", "P4022"),
        ("a : (UP, DOWN) := LEFT;", "P2006"),
        ("a : (UP, DOWN) := 1;", "P4022"),
        ("a : INT(0..5) := 6;", "P2026"),
        ("a : ARRAY[0..1] OF INT := [q(1)];", "P4017"),
    ] {
        assert_eq!(codes(variables, ""), [code], "{variables}");
    }
}

#[test]
fn programs_run_as_the_configuration_says() {
    let programs = "PROGRAM p VAR n : INT; END_VAR total := total * 10 + 1; n := n + 1; END_PROGRAM
        PROGRAM main VAR n : INT; END_VAR total := total * 10 + 2; n := n + total; END_PROGRAM\n";
    let with = format!(
        "{programs} CONFIGURATION c VAR_GLOBAL total : INT; END_VAR RESOURCE r ON x TASK t(INTERVAL := T#1s, PRIORITY := 1);
         PROGRAM one WITH t : p; PROGRAM two WITH t : main; PROGRAM three WITH t : p; END_RESOURCE END_CONFIGURATION"
    );
    gives_in(
        ED3,
        &with,
        1,
        &[
            "total = INT#121",
            "n = INT#12",
            "one.n = INT#1",
            "three.n = INT#1",
            "MAIN.n = INT#12",
        ],
    );
    let without = format!("VAR_GLOBAL total : INT; END_VAR {programs}");
    gives_in(
        ED2,
        &without,
        2,
        &["total = INT#22", "n = INT#24", "main.N = INT#24"],
    );
}

#[test]
fn configurations_name_what_there_is() {
    let text = |instances: &str| {
        format!(
            "PROGRAM p END_PROGRAM CONFIGURATION c RESOURCE r ON x TASK t(PRIORITY := 1);\n{instances} END_RESOURCE END_CONFIGURATION"
        )
    };
    assert!(says(&text("PROGRAM a WITH t : p; PROGRAM b : p;")).is_empty());
    assert_eq!(says(&text("PROGRAM a WITH t : q;")), ["2 P2008"]);
    assert_eq!(says(&text("PROGRAM a WITH u : p;")), ["2 P4006"]);
    assert_eq!(says(&text("PROGRAM a : p; PROGRAM A : p;")), ["2 P4014"]);
    assert_eq!(says(&text("TASK t(PRIORITY := 2); PROGRAM a : p;")), ["2 P4019"]);
}

#[test]
fn located_variables_are_variables_in_sections_of_their_own() {
    let mixed = "PROGRAM main\nVAR\nx AT %MW5 : INT;\ny : INT; END_VAR y := x; END_PROGRAM";
    assert_eq!(says_in(ED2, mixed), ["3 P4036"]);
    assert!(says_in(RUSTY, mixed).is_empty() && says_in(PLCNEXT, mixed).is_empty());
    for (text, said) in [
        (
            "PROGRAM main\nVAR x AT %MW5 : INT := 3; y AT %QX0.0 : BOOL; END_VAR x := 4; END_PROGRAM",
            "",
        ),
        (
            "PROGRAM main\nVAR x AT %MW5 : INT := 100000; END_VAR END_PROGRAM",
            "2 P2026",
        ),
        (
            "PROGRAM main VAR x AT %MW5 : INT;\ny AT %MD1 : DINT; END_VAR END_PROGRAM",
            "2 P9999",
        ),
        (
            "FUNCTION f : INT VAR\nx AT %MW5 : INT; END_VAR f := x; END_FUNCTION PROGRAM main END_PROGRAM",
            "2 P9999",
        ),
        (
            "PROGRAM main VAR_TEMP\nx AT %MW5 : INT; END_VAR x := 1; END_PROGRAM",
            "2 P9999",
        ),
        (
            "PROGRAM main VAR x AT %MW5 : INT; END_VAR END_PROGRAM VAR_GLOBAL\ng AT %MW05 : INT; END_VAR",
            "2 P9999",
        ),
    ] {
        let expected: Vec<&str> = Some(said).filter(|said| !said.is_empty()).into_iter().collect();
        assert_eq!(says(text), expected, "{text}");
    }
}
