//! Statements.

use super::support::assert_body;

#[test]
fn a_case_takes_values_ranges_and_the_rest() {
    let body = "FOR i := 0 TO 6 DO
        CASE i OF 1: a[i] := 10; 2, 4: a[i] := 20; 5..6: a[i] := 30; ELSE a[i] := 40; END_CASE;
    END_FOR;";
    let expected = [
        "a[0] = INT#40",
        "a[1] = INT#10",
        "a[2] = INT#20",
        "a[3] = INT#40",
        "a[4] = INT#20",
        "a[6] = INT#30",
    ];
    assert_body("i : INT; a : ARRAY[0..6] OF INT;", body, &expected);
}

#[test]
fn a_for_loop_ends_at_the_limits_of_its_type() {
    assert_body(
        "i : SINT; j : USINT; n : INT; m : INT;",
        "FOR i := 120 TO 127 DO n := n + 1; END_FOR; FOR j := 3 TO 0 BY -1 DO m := m + 1; END_FOR;",
        &["n = INT#8", "m = INT#4"],
    );
}

#[test]
fn loops_can_be_left_and_continued() {
    assert_body(
        "i : INT; odd : INT; w : INT; r : INT;",
        "FOR i := 1 TO 100 DO IF i > 9 THEN EXIT; END_IF; IF i MOD 2 = 0 THEN CONTINUE; END_IF; odd := odd + i; END_FOR;
         WHILE w < 5 DO w := w + 2; END_WHILE;
         REPEAT r := r + 1; UNTIL TRUE END_REPEAT;",
        &["odd = INT#25", "i = INT#10", "w = INT#6", "r = INT#1"],
    );
}

#[test]
fn the_first_true_branch_runs_and_return_ends_the_body() {
    assert_body(
        "a : INT := 2; b : INT; c : INT;",
        "IF a = 1 THEN b := 1; ELSIF a = 2 THEN b := 2; ELSIF a = 2 THEN b := 3; ELSE b := 4; END_IF;
         RETURN; c := 1;",
        &["b = INT#2", "c = INT#0"],
    );
}

#[test]
fn bits_are_read_and_written() {
    assert_body(
        "b : BYTE := 16#80; s : SINT; r : BOOL; a : ARRAY[1..2] OF WORD; i : INT := 2;",
        "r := b.7; b.0 := r; b.%X7 := FALSE; s.7 := TRUE; a[i].15 := NOT a[1].0;",
        &[
            "r = BOOL#TRUE",
            "b = BYTE#16#01",
            "s = SINT#-128",
            "a[2] = WORD#16#8000",
        ],
    );
}
