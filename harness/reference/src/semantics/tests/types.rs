//! Declared types: enumerations, subranges, arrays, texts.

use super::{codes, gives, says, says_in};
use stickler_types::DialectName;

#[test]
fn enumerated_values_are_found_by_name() {
    let text = |statement: &str| {
        format!(
            "TYPE C : (RED, GREEN := 5, BLUE); K : (RED, BLACK); E : C := BLUE; S : STRUCT c : C; END_STRUCT; END_TYPE
             PROGRAM main VAR c : C; d : K; e : E; s : S; b : BOOL; loc : (UP, DOWN); a : ARRAY[0..1] OF C := [2(RED)]; END_VAR
             {statement} END_PROGRAM"
        )
    };
    for sound in [
        "c := GREEN; c := C#RED; c := RED; d := RED; d := BLACK; e := GREEN; s.c := BLUE; loc := UP; a[1] := RED;",
        "b := c = RED; b := RED = d; b := c = C#RED; b := c <> e; CASE d OF RED: ; BLACK: ; END_CASE; b := loc = DOWN;",
    ] {
        assert!(says(&text(sound)).is_empty(), "{sound}: {:?}", says(&text(sound)));
    }
    for (wrong, code) in [
        ("c := BLACK;", "P4035"),
        ("c := K#RED;", "P4035"),
        ("c := PINK;", "P2006"),
        ("c := C#PINK;", "P2006"),
        ("c := X#RED;", "P2004"),
        ("c := S#RED;", "P2004"),
        ("b := RED;", "P2043"),
        ("b := RED = RED;", "P2043"),
        ("b := c = BLACK;", "P4049"),
        ("b := c = PINK;", "P4007"),
        ("c := c.x;", "P4007"),
        ("loc := LEFT;", "P2006"),
        ("CASE c OF BLACK: ; END_CASE;", "P4035"),
        ("CASE c OF PINK: ; END_CASE;", "P2006"),
        ("CASE c OF 1: ; END_CASE;", "P4035"),
        ("CASE c OF e: ; END_CASE;", "P4010"),
    ] {
        let mut said = says(&text(wrong));
        said.dedup();
        assert_eq!(said, [format!("3 {code}")], "{wrong}");
    }
    gives(
        &text("d := BLACK; s.c := GREEN;"),
        &[
            "c = C#RED",
            "e = C#BLUE",
            "d = K#BLACK",
            "s.c = C#GREEN",
            "a[1] = C#RED",
        ],
    );
}

#[test]
fn enumerations_have_numbers_that_fit() {
    for (ty, code) in [
        ("(A := 9223372036854775807, B)", "P2026"),
        ("SINT (A := 128)", "P2026"),
        ("REAL (A, B)", "P4056"),
        ("(A := n)", "P4030"),
    ] {
        assert_eq!(codes(&format!("e : {ty};"), ""), [code], "{ty}");
    }
    assert!(codes("e : SINT (A := -128, B := 127);", "").is_empty());
}

#[test]
fn subranges_are_integers_with_limits() {
    let text = "TYPE PCT : SINT(0..100); HI : INT(10..20); END_TYPE
        PROGRAM main VAR p : INT(0..100) := 5; q : PCT; i : INT; END_VAR VAR CONSTANT n : INT := 7; END_VAR
        p := 100; q := 0; i := p + q; p := i; p := n; END_PROGRAM";
    assert!(says(text).is_empty(), "{:?}", says(text));
    for (variables, code) in [
        ("p : INT(5..1);", "P2002"),
        ("p : INT(0..0);", "P2002"),
        ("p : INT(0..40000);", "P2016"),
        ("p : USINT(-1..1);", "P2016"),
        ("p : REAL(0..1);", "P2015"),
        ("p : INT(0..n);", "P4030"),
        ("p : INT(0..1.5);", "P4031"),
    ] {
        assert_eq!(codes(variables, ""), [code], "{variables}");
    }
    for wrong in ["p := 101;", "p := -1;", "p := 50 + 51;", "p := n;"] {
        assert_eq!(
            codes("p : INT(0..100); END_VAR VAR CONSTANT n : INT := 200;", wrong),
            ["P2026"],
            "{wrong}"
        );
    }
    gives(
        "TYPE HI : INT(10..20); OWN : HI := 15; S : STRUCT h : HI; END_STRUCT; END_TYPE
         PROGRAM main VAR h : HI; o : OWN; s : S; a : ARRAY[0..2] OF HI; z : INT(-5..5); END_VAR h := h + 1; END_PROGRAM",
        &["h = INT#11", "o = INT#15", "s.h = INT#10", "a[2] = INT#10", "z = INT#0"],
    );
}

#[test]
fn user_defined_types_convert_to_no_other_in_plcnext() {
    let program = |statement: &str| {
        format!(
            "TYPE LENGTH : INT; PCT : INT(0..100); FAR : DINT; S : STRUCT f : LENGTH; END_STRUCT; END_TYPE
             FUNCTION GIVE : LENGTH VAR_INPUT in : INT; END_VAR GIVE := in; END_FUNCTION
             FUNCTION_BLOCK FB VAR_OUTPUT o : LENGTH; p : INT; END_VAR END_FUNCTION_BLOCK
             PROGRAM main VAR a : LENGTH; p : PCT; z : FAR; s : S; l : ARRAY[0..1] OF LENGTH; i : INT; d : DINT; b : BOOL; fb : FB; END_VAR
             {statement} END_PROGRAM"
        )
    };
    for same in [
        "i := a; a := i; i := p; p := i; d := z; z := d; l[0] := s.f; i := GIVE(a); i := a + i; fb(o => i); fb(p => a); z := 5;",
        "d := i; d := d + i; fb(p => d); d := INT_TO_DINT(a); b := a = i;",
    ] {
        assert!(says_in(DialectName::PLCNEXT, &program(same)).is_empty(), "{same}");
    }
    for (other, code) in [
        ("d := a;", "P4035"),
        ("d := p;", "P4035"),
        ("z := i;", "P4035"),
        ("d := (s.f);", "P4035"),
        ("d := l[1];", "P4035"),
        ("d := GIVE(i);", "P4027"),
        ("z := INT#5;", "P4035"),
        ("d := d + a;", "P4049"),
        ("b := p < d;", "P4049"),
        ("fb(o => d);", "P4035"),
        ("fb(p => z);", "P4035"),
        ("d := MAX(d, a);", "P4026"),
    ] {
        assert_eq!(
            says_in(DialectName::PLCNEXT, &program(other)),
            [format!("5 {code}")],
            "{other}"
        );
        assert!(
            says_in(DialectName::IRONPLC_ED3, &program(other)).is_empty(),
            "{other}"
        );
    }
}

#[test]
fn limits_of_arrays_are_integer_constants() {
    let declare = |limits: &str| {
        codes(
            &format!(
                "v : INT; END_VAR VAR CONSTANT n : INT := 3; r : REAL := 1.0; END_VAR VAR a : ARRAY[{limits}] OF INT;"
            ),
            "",
        )
    };
    for sound in [
        "0..n",
        "-n..n",
        "n * 2 - 1..2 ** n",
        "INT#0..16#F",
        "0..0, 1..n",
        "(1)..+5",
    ] {
        assert!(declare(sound).is_empty(), "{sound}: {:?}", declare(sound));
    }
    for (limits, code) in [
        ("1..0", "P2024"),
        ("0..v", "P4010"),
        ("0..q", "P4030"),
        ("0..r", "P4031"),
        ("0..1.5", "P4031"),
        ("0..1 / 0", "P4039"),
        ("0..99999999999999999999999999999999999999999999999999", "P2026"),
        ("0..340282366920938463463374607431768211456", "P2026"),
        ("-170141183460469231731687303715884105728..0", "P2026"),
        ("0..18446744073709551615", "P2026"),
        ("-9223372036854775808..9223372036854775807", "P2023"),
        ("0..4194304", "P2023"),
        ("0..65535, 0..65535, 0..65535, 0..65535, 0..65535", "P2023"),
    ] {
        assert_eq!(declare(limits), [code], "{limits}");
    }
    assert!(declare("1..4000000").is_empty());
    gives(
        "PROGRAM main VAR a : ARRAY[9223372036854775806..9223372036854775807] OF INT; i : LINT := 9223372036854775807; END_VAR a[i] := 5; END_PROGRAM",
        &["a[9223372036854775807] = INT#5"],
    );
}

#[test]
fn texts_have_lengths() {
    for sound in ["STRING[1]", "STRING[65535]", "WSTRING[n]", "STRING"] {
        assert!(
            codes(
                &format!("c : INT; END_VAR VAR CONSTANT n : INT := 5; END_VAR VAR s : {sound};"),
                ""
            )
            .is_empty(),
            "{sound}"
        );
    }
    for (wrong, code) in [
        ("STRING[0]", "P2041"),
        ("STRING[65536]", "P2041"),
        ("STRING[-1]", "P2041"),
        ("STRING[q]", "P4030"),
    ] {
        assert_eq!(codes(&format!("s : {wrong};"), ""), [code], "{wrong}");
    }
    gives(
        "PROGRAM main VAR a : STRING[3]; b : STRING := 'abcdef'; c : ARRAY[0..1] OF STRING[2] := [2('xyz')]; END_VAR a := b; b := a; END_PROGRAM",
        &["a = STRING#'abc'", "b = STRING#'abc'", "c[1] = STRING#'xy'"],
    );
}

#[test]
fn declared_types_carry_their_initial_values_along() {
    gives(
        "TYPE SPEED : INT := 42; FAST : SPEED; P : STRUCT x : SPEED; y : INT := 3; n : STRING[4] := 'abcdef'; END_STRUCT;
         Q : P := (y := 9); L : ARRAY[0..2] OF Q; M : ARRAY[0..1] OF L := [[(x := 1)], [2((y := 2))]]; W : STRUCT m : M; END_STRUCT; END_TYPE
         FUNCTION_BLOCK B VAR q : Q; END_VAR VAR_OUTPUT n : SPEED; END_VAR n := n + 1; END_FUNCTION_BLOCK
         FUNCTION F : FAST VAR q : Q; k : INT; END_VAR k := k + q.y; q.y := 100; F := F + k; END_FUNCTION
         PROGRAM main VAR f : FAST; w : W; bs : ARRAY[1..2] OF B; one, two : INT; b : B := (n := 7, q := (x := 6)); END_VAR
         bs[2](); one := F(); two := F(); b(); END_PROGRAM",
        &[
            "f = INT#42",
            "w.m[0][0].x = INT#1",
            "w.m[0][0].y = INT#9",
            "w.m[0][1].x = INT#42",
            "w.m[1][1].y = INT#2",
            "w.m[1][2].y = INT#9",
            "w.m[1][2].n = STRING#'abcd'",
            "bs[1].n = INT#42",
            "bs[2].n = INT#43",
            "bs[2].q.y = INT#9",
            "one = INT#51",
            "two = INT#51",
            "b.n = INT#8",
            "b.q.x = INT#6",
            "b.q.y = INT#9",
        ],
    );
}
