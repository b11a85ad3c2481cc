//! Operators: widths, wrapping, mixed operands.

use super::support::assert_body;

#[test]
fn integers_wrap_in_their_declared_width() {
    assert_body(
        "i : INT := 32767; u : USINT; l : LINT := 9223372036854775807; s : SINT := -128;",
        "i := i + 1; u := u - 1; l := l + 1; s := s / -1;",
        &[
            "i = INT#-32768",
            "u = USINT#255",
            "l = LINT#-9223372036854775808",
            "s = SINT#-128",
        ],
    );
}

#[test]
fn the_target_never_widens_an_operation() {
    assert_body(
        "i : INT := 32767; d : DINT; r : REAL;",
        "d := i + 1; r := i * 2;",
        &["d = DINT#-32768", "r = REAL#-2.0"],
    );
}

#[test]
fn mixed_operands_take_the_wider_type() {
    assert_body(
        "i : INT := 32767; d : DINT := 1; u : USINT := 200; e : DINT; f : INT; r : REAL := 0.5; q : REAL;",
        "e := i + d; f := u + i; q := i * r;",
        &["e = DINT#32768", "f = INT#-32569", "q = REAL#16383.5"],
    );
}

#[test]
fn division_and_modulo_go_toward_zero() {
    assert_body(
        "a : INT; b : INT; c : INT; n : INT := -7;",
        "a := n / 2; b := n MOD 2; c := 7 MOD -2;",
        &["a = INT#-3", "b = INT#-1", "c = INT#1"],
    );
}

#[test]
fn real_is_rounded_after_every_operation() {
    assert_body(
        "r : REAL := 16777216.0; s : REAL; l : LREAL; z : REAL; n : LREAL;",
        "s := r + 1.0 + 1.0; l := r; l := l + 1.0; z := 1.0 / (r - r); n := l * 0.0 / 0.0;",
        &[
            "s = REAL#16777216.0",
            "l = LREAL#16777217.0",
            "z = REAL#Infinity",
            "n = LREAL#NaN",
        ],
    );
}

#[test]
fn operators_bind_as_the_standard_says() {
    assert_body(
        "a : INT; b : BOOL; c : INT; d : REAL; t : INT := 2;",
        "a := 2 + 3 * 4 - t; b := NOT FALSE AND t = 2 XOR TRUE; c := -t ** 2; d := 2.0 ** 3.0 ** 2.0;",
        &["a = INT#12", "b = BOOL#FALSE", "c = INT#4", "d = REAL#64.0"],
    );
}

#[test]
fn bit_strings_have_logic_and_order() {
    assert_body(
        "w : WORD := 16#00FF; v : WORD; n : BYTE := 16#0F; b : BOOL;",
        "v := w AND 16#0FF0 OR 16#8000; n := NOT n; b := w > v;",
        &["v = WORD#16#80F0", "n = BYTE#16#F0", "b = BOOL#FALSE"],
    );
}

#[test]
fn durations_and_dates_are_computed_with() {
    assert_body(
        "t : TIME := T#1s; u : TIME; v : TIME; d : DT := DT#2024-02-28-23:59:59; e : DT; p : TIME;",
        "u := t + T#500ms; v := t * 2.5; e := d + T#1s; p := d - DT#2024-02-28-00:00:00;",
        &[
            "u = TIME#1500ms",
            "v = TIME#2500ms",
            "e = DT#2024-02-29-00:00:00",
            "p = TIME#86399000ms",
        ],
    );
}

#[test]
fn comparisons_with_nan_fail() {
    assert_body(
        "zero : REAL; n : REAL; equal : BOOL; unequal : BOOL; less : BOOL;",
        "n := zero / zero; equal := n = n; unequal := n <> n; less := n < 1.0;",
        &["equal = BOOL#FALSE", "unequal = BOOL#TRUE", "less = BOOL#FALSE"],
    );
}
