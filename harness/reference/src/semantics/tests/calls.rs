//! Calls: which arguments are for which parameters, and what is wrong with them.

use super::{ED3, MATIEC, codes, codes_in, diagnose, gives, says};

const ADD: &str = "FUNCTION ADD2 : INT VAR_INPUT a : INT; b : INT := 10; END_VAR VAR_OUTPUT q : DINT; END_VAR
  q := a; ADD2 := a + b; END_FUNCTION ";
const COUNT: &str =
    "FUNCTION_BLOCK COUNT VAR_INPUT inc : INT := 1; END_VAR VAR_OUTPUT n : INT; odd : BOOL; END_VAR
  VAR_IN_OUT sum : DINT; END_VAR n := n + inc; odd := n.0; sum := sum + inc; END_FUNCTION_BLOCK ";

fn add(statement: &str) -> Vec<String> {
    says(&format!(
        "{ADD}\nPROGRAM main VAR x : INT; d : DINT; END_VAR\n{statement}\nEND_PROGRAM"
    ))
}

fn count(statement: &str) -> Vec<String> {
    says(&format!(
        "{COUNT}\nPROGRAM main VAR c : COUNT; x : INT; s : SINT; d : DINT; b : BOOL; END_VAR\n{statement}\nEND_PROGRAM"
    ))
}

#[test]
fn a_function_takes_its_inputs_by_position_or_by_name() {
    for sound in [
        "x := ADD2(1, 2);",
        "x := ADD2(a := 1);",
        "x := ADD2(b := 1, a := x, q => d);",
        "ADD2(1, 2);",
        "ADD2(q => d);",
    ] {
        assert!(add(sound).is_empty(), "{sound}");
    }
    for (wrong, code) in [
        ("x := ADD2(1);", "P4018"),
        ("x := ADD2();", "P4018"),
        ("x := ADD2(1, 2, 3);", "P4018"),
        ("x := ADD2(1, b := 2);", "P4001"),
        ("x := ADD2(a := 1, c := 2);", "P4023"),
        ("x := ADD2(a := 1, q := 2);", "P4023"),
        ("x := ADD2(a := 1, a := 2);", "P4024"),
        ("x := ADD2(a := 1, c => d);", "P4023"),
        ("x := ADD2(a := 1, a => d);", "P4023"),
        ("x := ADD2(a := 1, ADD2 => d);", "P4023"),
        ("x := ADD2(a := d);", "P4026"),
        ("x := ADD2(a := 1, q => x);", "P4035"),
        ("x := ADD2(1.5, 2);", "P4026"),
        ("x := ADD2(40000, 2);", "P2026"),
        ("x := ADDD(1, 2);", "P4017"),
        ("x := x(1);", "P4012"),
        ("x := main(1);", "P4017"),
    ] {
        assert_eq!(add(wrong), [format!("4 {code}")], "{wrong}");
    }
}

#[test]
fn everything_wrong_with_a_call_is_said_at_once() {
    let said = add("x := ADD2(a := d, c := y, q => x);");
    assert_eq!(said, ["4 P4007", "4 P4023", "4 P4026", "4 P4035"]);
    assert_eq!(add("x := ADDD(y, z);"), ["4 P4007", "4 P4007", "4 P4017"]);
    assert_eq!(add("x := ADD2(y, 1, 2);"), ["4 P4007", "4 P4018"]);
}

#[test]
fn a_function_block_takes_its_inputs_by_name() {
    for sound in [
        "c(sum := d);",
        "c(inc := s, sum := d, n => d, odd => b);",
        "c(5, d);",
        "c(sum := d, NOT odd => b);",
        "d := c.n; c.inc := 3;",
    ] {
        assert!(count(sound).is_empty(), "{sound}");
    }
    for (wrong, code) in [
        ("c();", "P4002"),
        ("c(sun := d);", "P4023"),
        ("c(5);", "P4003"),
        ("c(1, 2, 3);", "P4003"),
        ("c(5, sum := d);", "P4001"),
        ("c(inc := d, sum := d);", "P4026"),
        ("c(inc := 1.0, sum := d);", "P4026"),
        ("c(n := 1, sum := d);", "P4023"),
        ("c(sum := d, m => d);", "P4004"),
        ("c(sum := d, inc => x);", "P4004"),
        ("c(sum := d, n => s);", "P4035"),
        ("c(sum := d, n => x, n => x);", "P4024"),
        ("c(sum := d, NOT n => x);", "P4049"),
        ("c(sum := x);", "P4059"),
        ("c(sum := 5);", "P4058"),
        ("c(sum := d + d);", "P4058"),
        ("c(sum := (d));", "P4058"),
        ("COUNT(sum := d);", "P4012"),
        ("x(sum := d);", "P4012"),
        ("e(sum := d);", "P4017"),
        ("d := c.sum;", "P4007"),
        ("d := c.m;", "P4007"),
        ("x := c(sum := d);", "P4027"),
        ("x := 1 + c(sum := d);", "P4049"),
    ] {
        assert_eq!(count(wrong), [format!("4 {code}")], "{wrong}");
    }
}

#[test]
fn an_in_out_argument_is_a_whole_variable_that_can_be_written() {
    let text = |argument: &str| {
        format!(
            "FUNCTION F : BOOL VAR_IN_OUT p : BOOL; END_VAR END_FUNCTION
             PROGRAM main VAR b : BOOL; w : WORD; a : ARRAY[0..1] OF BOOL; END_VAR
             VAR CONSTANT k : BOOL := TRUE; END_VAR
             b := F({argument}); END_PROGRAM"
        )
    };
    for (argument, said) in [
        ("b", None),
        ("a[0]", None),
        ("p := a[1]", None),
        ("w.3", Some("4 P4058")),
        ("TRUE", Some("4 P4058")),
        ("k", Some("4 P4060")),
        ("w", Some("4 P4059")),
        ("nobody", Some("4 P4007")),
    ] {
        assert_eq!(
            says(&text(argument)),
            said.into_iter().collect::<Vec<_>>(),
            "{argument}"
        );
    }
}

#[test]
fn the_bare_result_of_a_call_has_a_code_of_its_own() {
    let variables = "s : SINT; d : DINT; r : REAL;";
    assert_eq!(codes(variables, "s := DINT_TO_INT(d);"), ["P4027"]);
    assert_eq!(codes(variables, "s := (DINT_TO_INT(d));"), ["P4027"]);
    assert_eq!(codes(variables, "s := DINT_TO_INT(d) + 1;"), ["P4035"]);
    assert_eq!(codes(variables, "s := MAX(d, 1);"), ["P4027"]);
    assert_eq!(codes(variables, "d := INT_TO_REAL(s);"), ["P4027"]);
}

#[test]
fn standard_functions_check_their_arguments() {
    let variables = "i : INT; d : DINT; r : REAL; b : BOOL; w : WORD; t : TIME; s : STRING; c : (UP, DOWN); f : ARRAY[0..1] OF INT;";
    for sound in [
        "i := SEL(b, 1, i); i := SEL(G := b, IN0 := i, IN1 := 2); c := SEL(b, UP, DOWN); c := SEL(b, c, UP);",
        "i := MUX(i, 1, 2, 3); r := MUX(K := 0, IN0 := r, IN1 := 1); t := MAX(t, T#1s);",
        "i := MIN(i, 3, i); d := MAX(IN1 := i, IN2 := d); r := LIMIT(0, r, 1); r := LIMIT(MN := 0, IN := r, MX := 1.5);",
        "r := ABS(-1); d := ABS(i); w := SHL(w, 1); w := ROR(IN := w, N := i); i := LEN(s); i := LEN('abc');",
        "s := CONCAT(s, 'x', s); s := SEL(b, s, 'x'); b := SEL(b, TRUE, b); w := SEL(b, w, 16#FF);",
        "r := r + SEL(r < 0.0, 0.5, -0.5);",
    ] {
        assert!(
            codes(variables, sound).is_empty(),
            "{sound}: {:?}",
            codes(variables, sound)
        );
    }
    for (wrong, code) in [
        ("i := SEL(b, 1);", "P4018"),
        ("i := SEL(b, 1, 2, 3);", "P4018"),
        ("i := SEL(i, 1, 2);", "P4026"),
        ("i := SEL(b, i, b);", "P4026"),
        ("i := SEL(b, 1.5, 2.5);", "P4027"),
        ("i := SEL(b, 1, 70000);", "P2026"),
        ("i := SEL(b, i, IN1 := 3);", "P4001"),
        ("i := SEL(G := b, IN1 := i, IN2 := i);", "P4023"),
        ("i := SEL(G := b, IN1 := i, IN1 := i);", "P4024"),
        ("i := MIN(i);", "P4018"),
        ("i := MAX(i, 'x');", "P4026"),
        ("i := MAX(i, r, s);", "P4026"),
        ("i := ABS(w);", "P4026"),
        ("i := ABS(f);", "P4026"),
        ("w := SHL(i, 1);", "P4026"),
        ("w := SHL(w, r);", "P4026"),
        ("w := SHL(w, w);", "P4026"),
        ("i := LEN(i);", "P4026"),
        ("i := LEN(5);", "P4026"),
        ("s := CONCAT(s, \"x\");", "P4026"),
        ("s := CONCAT(s, i);", "P4026"),
        ("i := MUX(r, 1, 2);", "P4026"),
        ("i := MUX(K := 0, IN0 := 1, IN2 := 3);", "P4018"),
        ("i := ABS(i, q => d);", "P4023"),
        ("i := SEL(b, i, f);", "P4026"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
}

#[test]
fn wrong_arguments_of_standard_functions_are_named_once() {
    assert_eq!(codes("i : INT;", "i := MAX(i, x, 1);"), ["P4007"]);
    assert_eq!(
        codes("i : INT; b : BOOL; r : REAL;", "i := LIMIT(i, b, r) + y;"),
        ["P4007", "P4026"]
    );
}

#[test]
fn of_texts_to_join_only_what_is_no_text_is_wrong() {
    let variables = "b : BOOL; s : STRING;";
    for wrong in [
        "s := CONCAT('x', b);",
        "s := CONCAT(b, 'x', s);",
        "s := CONCAT(s, b);",
    ] {
        assert_eq!(codes(variables, wrong), ["P4026"], "{wrong}");
    }
    assert_eq!(codes(variables, "s := CONCAT(b, b);"), ["P4026", "P4026"]);
}

#[test]
fn conversion_functions_check_their_argument() {
    let variables = "i : INT; d : DINT; r : REAL; w : WORD; s : STRING;";
    assert!(
        codes(
            variables,
            "d := INT_TO_DINT(5); d := INT_TO_DINT(IN := i); i := TO_INT(d); d := TRUNC(r);"
        )
        .is_empty()
    );
    for (wrong, code) in [
        ("i := DINT_TO_INT(r);", "P4026"),
        ("i := DINT_TO_INT();", "P4018"),
        ("i := DINT_TO_INT(d, d);", "P4018"),
        ("i := DINT_TO_INT(X := d);", "P4023"),
        ("i := DINT_TO_INT(5000000000);", "P2026"),
        ("i := DINT_TO_IMT(d);", "P4017"),
        ("d := TRUNC(s);", "P4026"),
        ("d := TO_DINT(x);", "P4007"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
    let nested = "d := INT_TO_DINT(i) + INT_TO_DINT(INT_TO_DINT(i) = d);";
    assert_eq!(codes(variables, nested), ["P4026"]);
    // The result's type is known whatever the argument is.
    assert_eq!(codes(variables, "i := INT_TO_REAL(d);"), ["P4026", "P4027"]);
    assert_eq!(codes(variables, "i := TO_REAL(x) + 1.0;"), ["P4007", "P4035"]);
}

#[test]
fn conversions_of_bcd_take_the_type_of_their_target() {
    let variables = "b : BYTE; w : WORD; i : INT; d : DINT; r : REAL;";
    let sound = "i := BCD_TO_INT(b); d := BCD_TO_INT(w); b := INT_TO_BCD(i); w := INT_TO_BCD(d);";
    assert!(codes_in(MATIEC, variables, sound).is_empty());
    assert_eq!(codes_in(MATIEC, variables, "r := BCD_TO_INT(b);"), ["P4027"]);
    assert_eq!(codes_in(MATIEC, variables, "d := BCD_TO_INT(b) + d;"), ["P4049"]);
}

#[test]
fn a_function_that_is_not_known_gets_a_hint() {
    let message = |dialect, name: &str| {
        let text = format!("PROGRAM main VAR i : DINT; r : REAL; END_VAR i := {name}(r); END_PROGRAM");
        diagnose(dialect, &text).remove(0).message
    };
    assert!(message(ED3, "LMIT").contains("LIMIT"), "{}", message(ED3, "LMIT"));
    assert!(message(MATIEC, "ROUND").contains("REAL_TO_DINT(x + SEL(x < 0.0, 0.5, -0.5))"));
    assert!(message(MATIEC, "floor").contains("TRUNC_DINT"));
}

#[test]
fn recursion_is_said_once_for_each_cycle() {
    let own = "FUNCTION F : INT VAR_INPUT n : INT; END_VAR\nF := F(n - 1);\nF := F(n);\nEND_FUNCTION";
    assert_eq!(says(own), ["2 P4005"]);
    let mutual = "FUNCTION F : INT VAR_INPUT n : INT; END_VAR\nF := G(n);\nEND_FUNCTION\n\
                  FUNCTION G : INT VAR_INPUT n : INT; END_VAR\nG := F(n);\nEND_FUNCTION";
    assert_eq!(says(mutual), ["5 P4005"]);
    let block = "FUNCTION_BLOCK B\nVAR inner : B; END_VAR\nEND_FUNCTION_BLOCK";
    assert_eq!(says(block), ["2 P4005"]);
    let through = "FUNCTION F : INT VAR_IN_OUT b : B; END_VAR\nb();\nEND_FUNCTION\n\
                   FUNCTION_BLOCK B VAR x : INT; END_VAR\nEND_FUNCTION_BLOCK";
    assert!(says(through).is_empty());
    let back = "FUNCTION F : INT VAR_IN_OUT b : B; END_VAR\nb();\nEND_FUNCTION\n\
                FUNCTION_BLOCK B VAR x : INT; c : C; END_VAR\nEND_FUNCTION_BLOCK\n\
                FUNCTION_BLOCK C VAR_IN_OUT b : B; END_VAR VAR x : INT; END_VAR\nx := F(b);\nEND_FUNCTION_BLOCK";
    assert_eq!(says(back), [] as [&str; 0], "B holds a C, but calls none");
}

#[test]
fn arguments_are_evaluated_before_any_is_stored() {
    gives(
        &format!(
            "{ADD} PROGRAM main VAR x, y : INT; END_VAR x := ADD2(ADD2(1, 2), ADD2(3, 4)); y := ADD2(a := ADD2(a := 1)); END_PROGRAM"
        ),
        &["x = INT#10", "y = INT#21"],
    );
}

#[test]
fn outputs_are_read_before_their_targets_are_looked_for() {
    gives(
        &format!(
            "{ADD} PROGRAM main VAR x : INT; a : ARRAY[0..9] OF DINT; END_VAR
             x := ADD2(a := 7, b := 1, q => a[ADD2(2, 1)]); END_PROGRAM"
        ),
        &["x = INT#8", "a[3] = DINT#7", "a[2] = DINT#0"],
    );
}

#[test]
fn aggregates_are_passed_and_returned_by_value() {
    gives(
        "TYPE P : STRUCT x : INT := 1; s : STRING[3]; END_STRUCT; END_TYPE
         FUNCTION MAKE : P VAR_INPUT x : INT; s : STRING; END_VAR MAKE.x := x; MAKE.s := s; END_FUNCTION
         FUNCTION SUM : INT VAR_INPUT a, b : P; END_VAR a.x := a.x + b.x; SUM := a.x + LEN(a.s); END_FUNCTION
         FUNCTION SWAP : BOOL VAR_IN_OUT a, b : P; END_VAR VAR t : P; END_VAR t := a; a := b; b := t; END_FUNCTION
         PROGRAM main VAR p, q : P; n : INT; b : BOOL; END_VAR
         p := MAKE(5, 'abcdef'); n := SUM(MAKE(10, 'a'), MAKE(20, 'bb')) + SUM(p, q); b := SWAP(p, q); END_PROGRAM",
        &["n = INT#40", "p.x = INT#1", "q.x = INT#5", "q.s = STRING#'abc'", "p.s = STRING#''"],
    );
}
