//! Operators: for which operands they are defined, and what they give.

use super::{ED2, ED3, MATIEC, PLCNEXT, RUSTY, codes, codes_in, gives, gives_in};

const VARIABLES: &str = "s : SINT; i : INT; d : DINT; l : LINT; us : USINT; u : UINT; ul : ULINT; r : REAL; lr : LREAL;
    b : BOOL; y : BYTE; w : WORD; t : TIME; lt : LTIME; da : DATE; td : TOD; moment : DT; long_moment : LDT; st : STRING; ws : WSTRING;
    c : CHAR; e : (UP, DOWN); a : ARRAY[0..1] OF INT; p : STRUCT x : INT; END_STRUCT;";

#[test]
fn operators_are_defined_for_their_operands() {
    for sound in [
        "i := i + s; d := i * d; r := i / r; lr := l + lr; r := r - 1; i := i MOD 3; i := -i; i := +i; us := -us;",
        "b := NOT b; w := NOT w; w := w AND y; b := b XOR TRUE; b := b & b; w := w OR 16#F;",
        "b := i < d; b := r >= i; b := t > T#1s; b := da = D#2024-01-01; b := st < 'abc'; b := c = 'a'; b := w = y;",
        "b := e = UP; b := DOWN <> e; b := b = TRUE; b := td < TOD#12:00:00; b := 1 < 2; b := 1.5 = 1; b := 'a' = 'b';",
        "t := t + t; t := t - T#1s; t := -t; t := t * 2; t := 2 * t; t := t * r; t := t / i; t := t * 1.5; t := i * t;",
        "t := moment - moment; t := da - da; t := td - td; moment := moment + t; moment := moment - t; td := td + T#1h; td := td - t;",
        "lt := long_moment - long_moment; long_moment := long_moment + lt; long_moment := long_moment - T#1s; lt := lt + t;",
        "r := r ** 2; r := r ** i; i := i ** 2; lr := 2.0 ** lr; d := 2 ** d; r := r ** 0.5; i := 2 ** 3;",
        "r := 2.0 ** i; lr := 2.0 ** i; r := 2.0 ** 3; r := 2.0 * 3.0 ** 2 + 1.0; b := 2.0 ** i > r; r := r * 2.0 ** i;",
    ] {
        assert!(
            codes(VARIABLES, sound).is_empty(),
            "{sound}: {:?}",
            codes(VARIABLES, sound)
        );
    }
}

#[test]
fn operators_are_not_defined_for_others() {
    for wrong in [
        "i := i + u;",
        "l := l + ul;",
        "i := us + s;",
        "r := r + d;",
        "i := i AND i;",
        "i := NOT i;",
        "i := i OR 1;",
        "w := w + w;",
        "w := w + 1;",
        "w := -w;",
        "b := b + b;",
        "b := -b;",
        "r := r MOD r;",
        "r := NOT r;",
        "w := w AND b;",
        "w := w AND i;",
        "b := w = i;",
        "b := b AND 2.0;",
        "st := st + st;",
        "b := st = ws;",
        "b := c = st;",
        "b := e < UP;",
        "b := e = 0;",
        "e := e + 1;",
        "b := a = a;",
        "b := p = p;",
        "i := a + 1;",
        "b := i = a;",
        "i := -a;",
        "t := t * t;",
        "t := t + 1;",
        "t := 2 / t;",
        "t := t MOD 2;",
        "moment := moment + moment;",
        "t := t + moment;",
        "da := da + t;",
        "t := moment - da;",
        "moment := moment * 2;",
        "b := t = 5;",
        "b := da = moment;",
        "i := 'a' + 'b';",
        "b := TRUE + 1;",
        "i := i + 1.5;",
        "i := i + b;",
        "b := b < 1.5;",
        "r := r ** b;",
        "b := NOT 'a';",
        "st := -'a';",
        "b := 5 = 'a';",
        "r := r ** t;",
    ] {
        assert_eq!(codes(VARIABLES, wrong), ["P4049"], "{wrong}");
    }
}

#[test]
fn mixed_operands_follow_the_dialect() {
    for (dialect, sound, undefined) in [
        (
            ED2,
            "w := w OR y; d := d + us; lr := lr * ul;",
            &["d := d + w;", "w := b OR w;"][..],
        ),
        (
            RUSTY,
            "d := d + w; d := y + d; b := i > y;",
            &["i := i + w;", "w := b OR w;"],
        ),
        (
            PLCNEXT,
            "w := b OR w; r := r + i;",
            &["lr := lr + l;", "d := d + w;", "r := r + d;"],
        ),
        (
            MATIEC,
            "d := d + d; d := d + 1; w := w OR 1;",
            &["d := d + i;", "lr := lr + r;", "w := w OR y;", "b := d > i;"],
        ),
    ] {
        let variables = "i : INT; d : DINT; l : LINT; us : USINT; ul : ULINT; r : REAL; lr : LREAL; b : BOOL; y : BYTE; w : WORD;";
        assert!(
            codes_in(dialect, variables, sound).is_empty(),
            "{dialect}: {:?}",
            codes_in(dialect, variables, sound)
        );
        for wrong in undefined {
            assert_eq!(
                codes_in(dialect, variables, wrong),
                ["P4049"],
                "{dialect}: {wrong}"
            );
        }
    }
}

#[test]
fn a_number_and_a_time_go_together_where_the_table_says_so() {
    let variables = "t : TIME := T#1s; u : UDINT := 500; b : BOOL; v : UDINT;";
    assert!(
        codes_in(
            PLCNEXT,
            variables,
            "t := t + u; t := u + t; b := t > u; u := t; t := u;"
        )
        .is_empty()
    );
    assert_eq!(codes_in(ED3, variables, "t := t + u;"), ["P4049"]);
    let text =
        format!("PROGRAM main VAR {variables} END_VAR v := u + t; t := u + t; b := t > u; END_PROGRAM");
    gives_in(
        PLCNEXT,
        &text,
        1,
        &["v = UDINT#1500", "t = TIME#1500ms", "b = BOOL#TRUE"],
    );
}

#[test]
fn the_target_never_widens_an_operation() {
    gives(
        "PROGRAM main VAR i : INT := 32767; d : DINT; s : SINT := 100; r : REAL; l : LINT; k : DINT := 2000000000; END_VAR
         d := i + 1; r := s + s; l := k + k; END_PROGRAM",
        &["d = DINT#-32768", "r = REAL#-56.0", "l = LINT#-294967296"],
    );
}

#[test]
fn one_complaint_is_enough() {
    assert_eq!(codes(VARIABLES, "i := (b + 1) * 2 - x + w;"), ["P4007", "P4049"]);
    assert_eq!(codes(VARIABLES, "b := NOT (i AND i) = 5;"), ["P4049"]);
    assert_eq!(
        codes(VARIABLES, "IF (w + 1) > 5 AND (st + 1) THEN ; END_IF;"),
        ["P4049", "P4049"]
    );
}

#[test]
fn constant_expressions_are_checked() {
    let variables =
        "s : SINT; i : INT; d : DINT; r : REAL; END_VAR VAR CONSTANT zero : INT := 0; big : INT := 32767;";
    let sound = "i := 100 * 300; i := big - 1; s := 100 - 50; i := i / zero; r := 1.0 / 0.0; d := i MOD 0; i := 2 ** 14;";
    assert!(
        codes(variables, sound).is_empty(),
        "{:?}",
        codes(variables, sound)
    );
    for (wrong, code) in [
        ("i := 1 / 0;", "P4039"),
        ("i := 1 MOD 0;", "P4039"),
        ("i := 10 / zero;", "P4039"),
        ("i := 10 / (5 - 5);", "P4039"),
        ("i := INT#1 / INT#0;", "P4039"),
        ("s := 100 + 100;", "P4040"),
        ("i := big + 1;", "P4040"),
        ("i := 200 * 200;", "P4040"),
        ("i := -(-32768);", "P4040"),
        ("i := 2 ** 15;", "P4040"),
        ("d := 65536 * 65536;", "P4040"),
        ("IF 1 / 0 = 1 THEN ; END_IF;", "P4039"),
        ("d := 9999999 * 9999999 * 9999999 / 0;", "P4040"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
}

#[test]
fn times_and_dates_are_computed() {
    gives(
        "PROGRAM main VAR t, u, v : TIME; d : DT := DT#2024-02-28-23:00:00; o, q : TOD := TOD#23:30:00; x : DATE := D#2024-03-01; END_VAR
         t := D#2024-03-01 - D#2024-02-28; d := d + T#2h; o := o + T#1h; q := q - T#24h; u := T#10s / 4; v := 1.5 * T#3s; END_PROGRAM",
        &[
            "t = TIME#172800000ms",
            "d = DT#2024-02-29-01:00:00",
            "o = TOD#00:30:00",
            "q = TOD#23:30:00",
            "u = TIME#2500ms",
            "v = TIME#4500ms",
        ],
    );
}

#[test]
fn precedence_and_long_chains_give_what_arithmetic_says() {
    gives(
        "PROGRAM main VAR a, b, c : DINT; x : BOOL; END_VAR
         a := 2 + 3 * 4 - -5 MOD 3; b := 2 ** 3 ** 2; c := -2 ** 2; x := 1 < 2 = (3 > 2) AND NOT (2 = 3) XOR FALSE; END_PROGRAM",
        &["a = DINT#16", "b = DINT#64", "c = DINT#4", "x = BOOL#TRUE"],
    );
}
