//! Where a value stands, and which code is given where it does not fit.

use super::{ED2, ED3, MATIEC, PLCNEXT, RUSTY, codes, codes_in, diagnose, says};

#[test]
fn each_context_has_its_code() {
    let text = "FUNCTION F : INT VAR_INPUT p : INT; END_VAR VAR_OUTPUT q : DINT; END_VAR
F := d;
END_FUNCTION
TYPE S : STRUCT x : INT := 1.5; END_STRUCT; END_TYPE
FUNCTION_BLOCK B VAR_INPUT p : INT; END_VAR END_FUNCTION_BLOCK
VAR_GLOBAL d : DINT; END_VAR
PROGRAM main
VAR
i : INT := d;
a : ARRAY[0..1] OF INT := [1, d];
s : S := (x := d);
b : B;
END_VAR
i := d;
i := F(d);
i := F(1) + F(p := d);
b(p := d);
a[0] := d;
s.x := d;
i := F(p := 1, q => i);
IF i THEN ; END_IF;
WHILE d DO ; END_WHILE;
REPEAT ; UNTIL i END_REPEAT;
i := DINT_TO_INT(d);
i := INT_TO_DINT(i);
END_PROGRAM";
    let expected = [
        "2 P4035", "4 P4022", "9 P4022", "10 P4022", "11 P4022", "14 P4035", "15 P4026", "16 P4026",
        "17 P4026", "18 P4035", "19 P4035", "20 P4035", "21 P4072", "22 P4072", "23 P4072", "25 P4027",
    ];
    let mut said = says(text);
    said.sort_by_key(|said| said.split(' ').next().and_then(|line| line.parse::<u32>().ok()));
    assert_eq!(said, expected);
}

#[test]
fn an_integer_literal_is_a_real_by_dialect() {
    for dialect in [ED2, ED3, RUSTY, PLCNEXT] {
        assert!(
            codes_in(
                dialect,
                "r : REAL := 1; l : LREAL;",
                "r := 5; l := -5; r := r + 1;"
            )
            .is_empty()
        );
    }
    assert_eq!(codes_in(MATIEC, "r : REAL := 1;", ""), ["P4022"]);
    assert_eq!(codes_in(MATIEC, "r : REAL;", "r := 5;"), ["P4035"]);
    assert_eq!(codes_in(MATIEC, "r : REAL;", "r := r + 1;"), ["P4049"]);
    assert_eq!(codes_in(MATIEC, "r : REAL;", "r := 1 + 1.5;"), ["P4049"]);
    assert_eq!(codes_in(MATIEC, "r : REAL; b : BOOL;", "b := r < 1;"), ["P4049"]);
    assert_eq!(codes_in(MATIEC, "r : REAL;", "r := MAX(r, 1);"), ["P4026"]);
}

#[test]
fn an_integer_literal_is_a_bit_string_by_context_and_dialect() {
    for dialect in [ED2, ED3, RUSTY, MATIEC, PLCNEXT] {
        assert!(
            codes_in(
                dialect,
                "b : BYTE := 16#FF; x : BOOL;",
                "b := b AND 16#0F; x := b = 3;"
            )
            .is_empty()
        );
    }
    for dialect in [RUSTY, MATIEC, PLCNEXT] {
        assert!(
            codes_in(
                dialect,
                "b : BYTE; i : INT;",
                "b := 5; i := BYTE_TO_INT(5); b := 1 OR 2;"
            )
            .is_empty()
        );
    }
    for dialect in [ED2, ED3] {
        assert_eq!(codes_in(dialect, "b : BYTE;", "b := 5;"), ["P4035"]);
        assert_eq!(codes_in(dialect, "b : BYTE;", "b := 16#05;"), ["P4035"]);
        assert_eq!(codes_in(dialect, "i : INT;", "i := BYTE_TO_INT(5);"), ["P4026"]);
        assert_eq!(
            codes_in(dialect, "b : ARRAY[0..1] OF BYTE := [1, 2];", ""),
            [] as [&str; 0]
        );
    }
}

#[test]
fn zero_and_one_are_the_literals_of_bool() {
    for dialect in [ED2, ED3, RUSTY, MATIEC, PLCNEXT] {
        let sound = "b := 1; b := b AND 0; IF 1 THEN ; END_IF; b := b = 0;";
        assert!(codes_in(dialect, "b : BOOL := 0;", sound).is_empty());
        assert_eq!(codes_in(dialect, "b : BOOL;", "b := 2;"), ["P2026"]);
        assert_eq!(codes_in(dialect, "b : BOOL;", "b := 1 + 0;"), ["P4049"]);
    }
}

#[test]
fn what_is_wrong_inside_is_said_too() {
    assert_eq!(codes("b : BOOL; i : INT;", "b := i + x;"), ["P4007"]);
    assert_eq!(
        codes("b : BOOL; i : INT;", "b := i + INT#40000;"),
        ["P2026", "P4035"]
    );
    assert_eq!(codes("t : TIME;", "t := 99999999999999999999;"), ["P2026"]);
    assert_eq!(
        codes(
            "s : SINT; i : INT; a : ARRAY[0..1] OF INT;",
            "s := i + a[x] + a[2];"
        ),
        ["P2027", "P4007", "P4035"]
    );
    assert_eq!(codes("", "x := y + z;"), ["P4007", "P4007", "P4007"]);
}

#[test]
fn the_span_of_a_misfit_is_the_value() {
    let text = "PROGRAM main VAR a : DINT; b : INT; END_VAR b := (a + 1); END_PROGRAM";
    let diagnostics = diagnose(ED3, text);
    assert_eq!(diagnostics[0].span.text(text), "(a + 1)");
}

#[test]
fn texts_of_the_two_kinds_do_not_mix() {
    let variables = "s : STRING; w : WSTRING; c : CHAR; wc : WCHAR;";
    assert!(
        codes(
            variables,
            "s := 'abc'; w := \"abc\"; c := 'a'; wc := \"a\"; s := 'a';"
        )
        .is_empty()
    );
    for wrong in [
        "s := w;",
        "w := s;",
        "s := \"abc\";",
        "w := 'abc';",
        "c := 'ab';",
        "c := \"a\";",
        "wc := c;",
        "c := s;",
        "s := 5;",
        "c := 5;",
    ] {
        assert_eq!(codes(variables, wrong), ["P4035"], "{wrong}");
    }
    assert!(codes(variables, "IF c = 'a' AND s = 'a' AND w <> \"x\" THEN ; END_IF;").is_empty());
    assert_eq!(codes(variables, "IF s = w THEN ; END_IF;"), ["P4049"]);
    assert_eq!(codes(variables, "IF c = 'ab' THEN ; END_IF;"), ["P4049"]);
}

#[test]
fn enumerations_structures_and_arrays_convert_to_nothing_but_themselves() {
    let text = |statement: &str| {
        format!(
            "TYPE C : (RED, GREEN); D : (UP, DOWN); E : C; P : STRUCT x : INT; END_STRUCT; Q : STRUCT x : INT; END_STRUCT;
             R : P; T : ARRAY[0..1] OF INT; END_TYPE
             PROGRAM main VAR c : C; d : D; e : E; p : P; q : Q; r : R; t : T; u : ARRAY[0..1] OF INT;
             v : ARRAY[1..2] OF INT; i : INT; END_VAR {statement} END_PROGRAM"
        )
    };
    let sound = "c := e; e := c; c := RED; e := E#GREEN; p := r; r := p; t := u; u := t;";
    assert!(says(&text(sound)).is_empty());
    for wrong in [
        "c := d;",
        "c := 0;",
        "i := c;",
        "c := i;",
        "c := UP;",
        "p := q;",
        "t := v;",
        "p := i;",
        "i := p;",
        "t := i;",
        "i := RED;",
    ] {
        assert_eq!(says(&text(wrong)), ["4 P4035"], "{wrong}");
    }
}
