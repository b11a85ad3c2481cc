//! Statements.

use super::{ED3, codes, diagnose, gives};

#[test]
fn statements_stand_where_they_belong() {
    assert_eq!(codes("", "EXIT;"), ["P4021"]);
    assert_eq!(codes("", "CONTINUE;"), ["P4065"]);
    assert_eq!(codes("b : BOOL;", "IF b THEN EXIT; END_IF;"), ["P4021"]);
    assert!(
        codes(
            "b : BOOL;",
            "WHILE b DO IF b THEN EXIT; ELSE CONTINUE; END_IF; END_WHILE; RETURN;"
        )
        .is_empty()
    );
}

#[test]
fn conditions_are_bool() {
    let variables = "i : INT; b : BOOL; y : BYTE; r : REAL;";
    assert!(
        codes(
            variables,
            "IF b AND y.0 THEN ; ELSIF i > 0 THEN ; END_IF; REPEAT ; UNTIL TRUE END_REPEAT;"
        )
        .is_empty()
    );
    for wrong in [
        "IF i THEN ; END_IF;",
        "WHILE y DO ; END_WHILE;",
        "REPEAT ; UNTIL r END_REPEAT;",
        "IF b THEN ; ELSIF 1.5 THEN ; END_IF;",
        "IF i + 1 THEN ; END_IF;",
    ] {
        assert_eq!(codes(variables, wrong), ["P4072"], "{wrong}");
    }
}

#[test]
fn a_case_selects_by_integers_that_fit() {
    let variables = "s : SINT; i : INT; b : BOOL; y : BYTE; r : REAL; t : STRING; v : INT; END_VAR VAR CONSTANT n : INT := 5;";
    for sound in [
        "CASE i OF 1, 2: ; 3..5, -7: ; n: ; n + 1: ; 16#F: ; INT#8: ; DINT#9: ; ELSE ; END_CASE;",
        "CASE s OF -128..127: ; END_CASE; CASE i + 1 OF 1: ; END_CASE; CASE 5 OF 5: ; END_CASE;",
    ] {
        assert!(
            codes(variables, sound).is_empty(),
            "{sound}: {:?}",
            codes(variables, sound)
        );
    }
    for (wrong, code) in [
        ("CASE b OF 1: ; END_CASE;", "P4053"),
        ("CASE y OF 1: ; END_CASE;", "P4053"),
        ("CASE r OF 1: ; END_CASE;", "P4053"),
        ("CASE t OF 1: ; END_CASE;", "P4053"),
        ("CASE s OF 128: ; END_CASE;", "P2026"),
        ("CASE s OF -129..0: ; END_CASE;", "P2026"),
        ("CASE s OF DINT#1000: ; END_CASE;", "P2026"),
        ("CASE i OF 5..1: ; END_CASE;", "P4051"),
        ("CASE i OF v: ; END_CASE;", "P4010"),
        ("CASE i OF 1.5: ; END_CASE;", "P4035"),
        ("CASE i OF TRUE: ; END_CASE;", "P4035"),
        ("CASE x OF 1: ; END_CASE;", "P4007"),
        ("CASE i OF x: ; END_CASE;", "P4007"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
}

#[test]
fn a_label_of_another_type_may_be_converted_for_that_gives_a_constant_too() {
    let program = |label: &str| {
        format!(
            "PROGRAM main VAR i : INT; END_VAR VAR CONSTANT w : WORD := WORD#5; END_VAR
             CASE i OF {label}: ; END_CASE; END_PROGRAM"
        )
    };
    for (label, suggested) in [("TRUE", "BOOL_TO_INT(TRUE)"), ("w", "WORD_TO_INT(w)")] {
        let rejected = diagnose(ED3, &program(label));
        assert_eq!(rejected[0].suggestion.as_deref(), Some(suggested), "{label}");
        assert!(diagnose(ED3, &program(suggested)).is_empty(), "{suggested}");
    }
}

#[test]
fn a_case_takes_the_first_branch_that_fits() {
    gives(
        "PROGRAM main VAR i : INT; n : ARRAY[-3..12] OF INT; u : ULINT := 18446744073709551615; k : INT; END_VAR
         FOR i := -3 TO 12 DO CASE i OF 1, 3, -2: n[i] := 1; 3..5, 9..10: n[i] := 2; 11: ; ELSE n[i] := 9; END_CASE; END_FOR;
         CASE u OF 0..9: k := 1; 18446744073709551615: k := 2; END_CASE; END_PROGRAM",
        &[
            "n[-3] = INT#9", "n[-2] = INT#1", "n[1] = INT#1", "n[2] = INT#9", "n[3] = INT#1", "n[4] = INT#2", "n[5] = INT#2",
            "n[6] = INT#9", "n[9] = INT#2", "n[10] = INT#2", "n[11] = INT#0", "n[12] = INT#9", "k = INT#2",
        ],
    );
}

#[test]
fn a_for_loop_takes_integers() {
    let variables = "s : SINT; i : INT; u : USINT; l : LINT; r : REAL; b : BOOL; y : BYTE; a : ARRAY[0..1] OF INT; p : STRUCT f : INT; END_STRUCT;";
    for sound in [
        "FOR i := 1 TO 10 BY 2 DO ; END_FOR; FOR u := 255 TO 0 BY -1 DO ; END_FOR; FOR s := i TO l BY s DO ; END_FOR;",
        "FOR a[i] := 0 TO 1 DO ; END_FOR; FOR p.f := a[0] TO ABS(i) DO EXIT; END_FOR; FOR i := s TO 5 DO ; END_FOR;",
    ] {
        assert!(
            codes(variables, sound).is_empty(),
            "{sound}: {:?}",
            codes(variables, sound)
        );
    }
    for (wrong, code) in [
        ("FOR r := 1.0 TO 2.0 DO ; END_FOR;", "P4035"),
        ("FOR b := 0 TO 1 DO ; END_FOR;", "P4035"),
        ("FOR y := 0 TO 1 DO ; END_FOR;", "P4035"),
        ("FOR i := 1.5 TO 2 DO ; END_FOR;", "P4035"),
        ("FOR i := 1 TO r DO ; END_FOR;", "P4035"),
        ("FOR i := 1 TO 2 BY r DO ; END_FOR;", "P4035"),
        ("FOR s := 1 TO 128 DO ; END_FOR;", "P2026"),
        ("FOR u := -1 TO 5 DO ; END_FOR;", "P2026"),
        ("FOR x := 1 TO 5 DO ; END_FOR;", "P4007"),
        ("FOR i := 1 TO 5 DO i := x; END_FOR;", "P4007"),
        ("FOR 5 := 1 TO 5 DO ; END_FOR;", "P0002"),
    ] {
        let said = if wrong.starts_with("FOR 5")
            && stickler_syntax::parse(
                &format!("PROGRAM p {wrong} END_PROGRAM"),
                stickler_types::Dialect::of(ED3),
            )
            .1
            .len()
                == 1
        {
            vec!["P0002".to_owned()]
        } else {
            let mut said = codes(variables, wrong);
            said.dedup();
            said
        };
        assert!(said.contains(&code.to_owned()), "{wrong}: {said:?}");
    }
}

#[test]
fn for_loops_end_where_their_types_do() {
    gives(
        "PROGRAM main VAR u, v : USINT; s : SINT; l : LINT; ul : ULINT; n, m, k, j, h, g, i : DINT; w : INT(1..5); big : LINT := 1000; END_VAR
         FOR u := 250 TO 255 DO n := n + 1; END_FOR;
         FOR v := 5 TO 0 BY -1 DO m := m + 1; END_FOR;
         FOR s := -128 TO 127 BY 100 DO k := k + 1; END_FOR;
         FOR l := 9223372036854775805 TO 9223372036854775807 DO j := j + 1; END_FOR;
         FOR ul := 18446744073709551614 TO 18446744073709551615 DO h := h + 1; END_FOR;
         FOR w := 1 TO 5 DO g := g + 1; END_FOR;
         FOR i := 1 TO 0 DO g := 100; END_FOR;
         FOR s := 0 TO big BY 50 DO i := i + 1; END_FOR;
         END_PROGRAM",
        &["n = DINT#6", "m = DINT#6", "k = DINT#3", "j = DINT#3", "h = DINT#2", "g = DINT#5", "w = INT#5", "i = DINT#4"],
    );
}

#[test]
fn bounds_are_evaluated_once_and_exits_leave_the_innermost_loop() {
    gives(
        "PROGRAM main VAR i, j, n, m, limit : INT := 3; a : ARRAY[0..5] OF INT; k : INT := 2; END_VAR
         n := 0; m := 0; FOR i := 1 TO limit DO limit := 100; n := n + 1; END_FOR;
         FOR i := 1 TO 3 DO FOR j := 1 TO 10 DO IF j = 4 THEN EXIT; END_IF; IF j = 2 THEN CONTINUE; END_IF; m := m + 1; END_FOR; END_FOR;
         FOR a[k] := 10 TO 12 DO k := 3; END_FOR;
         WHILE TRUE DO n := n + 10; IF n > 40 THEN EXIT; END_IF; END_WHILE;
         REPEAT n := n + 1; IF n < 50 THEN CONTINUE; END_IF; n := n + 100; UNTIL n > 49 END_REPEAT; END_PROGRAM",
        &["n = INT#150", "m = INT#6", "a[2] = INT#13", "a[3] = INT#0", "i = INT#4"],
    );
}

#[test]
fn return_leaves_any_pou() {
    gives(
        "FUNCTION F : INT VAR_INPUT n : INT; END_VAR F := 1; IF n > 0 THEN RETURN; END_IF; F := 2; END_FUNCTION
         FUNCTION_BLOCK B VAR_OUTPUT n : INT; END_VAR WHILE TRUE DO n := n + 1; IF n = 3 THEN RETURN; END_IF; END_WHILE; END_FUNCTION_BLOCK
         PROGRAM main VAR a, b, c : INT; fb : B; END_VAR a := F(1); b := F(0); fb(); c := 5; RETURN; c := 6; END_PROGRAM",
        &["a = INT#1", "b = INT#2", "fb.n = INT#3", "c = INT#5"],
    );
}
