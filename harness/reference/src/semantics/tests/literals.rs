//! Literals: the types they take, and the values that these hold.

use super::{ED2, ED3, MATIEC, codes, codes_in, gives};
use stickler_types::DialectName;

#[test]
fn a_literal_that_does_not_fit_is_said_where_it_stands() {
    let variables =
        "s : SINT; u : USINT; i : INT; b : BYTE := 0; l : LINT; ul : ULINT; r : REAL; lr : LREAL;";
    for sound in [
        "s := 127; s := -128; s := +127; u := 255; u := 0; i := -32768; l := -9223372036854775808;",
        "ul := 18446744073709551615; i := 16#7FFF; i := INT#-32768; r := -3.4028234E38; lr := 1.7E308; u := -0;",
        "r := 340282346638528859811704183484516925440; r := 16#FFFF; s := s + -128;",
    ] {
        assert!(
            codes(variables, sound).is_empty(),
            "{sound}: {:?}",
            codes(variables, sound)
        );
    }
    for (wrong, code) in [
        ("s := 128;", "P2026"),
        ("s := -129;", "P2026"),
        ("s := - 129;", "P2026"),
        ("s := 16#FF;", "P2026"),
        ("s := -(128);", "P2026"),
        ("u := -1;", "P2026"),
        ("u := 256;", "P2026"),
        ("i := -32769;", "P2026"),
        ("i := INT#40000;", "P2026"),
        ("i := INT#16#8000;", "P2026"),
        ("i := USINT#-1;", "P2026"),
        ("i := s + 128;", "P2026"),
        ("i := s - 128;", "P2026"),
        ("b := b AND 256;", "P2026"),
        ("ul := 18446744073709551616;", "P2026"),
        ("l := 99999999999999999999999999999999999999999999;", "P2026"),
        ("IF s > 128 THEN ; END_IF;", "P2026"),
        ("r := 3.5E38;", "P2040"),
        ("r := REAL#1.0E39;", "P2040"),
        ("lr := 1.0E309;", "P2040"),
        ("r := 99999999999999999999999999999999999999999;", "P2040"),
        ("i := INT#1.5;", "P2026"),
        ("IF BOOL#2 THEN ; END_IF;", "P2026"),
        ("i := 1.0;", "P4035"),
        ("l := 1.0;", "P4035"),
        ("i := INT_TO_DINT(5);", "P4027"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
}

#[test]
fn dates_and_durations_have_ranges_of_their_own() {
    let variables = "t : TIME; d : DATE; n : DT; o : TOD;";
    assert!(
        codes(
            variables,
            "t := T#-5d3h2ms; d := D#2024-02-29; n := DT#2262-04-11-23:47:16; o := TOD#23:59:59.999;"
        )
        .is_empty()
    );
    assert_eq!(codes(variables, "t := T#106752d;"), ["P2039"]);
    assert_eq!(codes(variables, "d := D#2023-02-29;"), ["P2038"]);
    assert_eq!(codes(variables, "d := D#2300-01-01;"), ["P2038"]);
    assert_eq!(codes(variables, "n := DT#2024-01-01-24:00:00;"), ["P2038"]);
    assert_eq!(codes(variables, "o := TOD#24:00:00;"), ["P2038"]);
    assert_eq!(codes(variables, "t := D#2024-01-01;"), ["P4035"]);
    assert_eq!(codes(variables, "t := 5;"), ["P4035"]);
}

#[test]
fn typed_literals_have_exactly_their_type() {
    let variables =
        "s : SINT; d : DINT; r : REAL; b : BYTE; w : WORD; x : BOOL; st : STRING; ws : WSTRING; c : CHAR;";
    for sound in [
        "s := SINT#-128; d := SINT#5; d := DINT#16#FF; r := INT#5; r := REAL#5; r := REAL#1.5; w := BYTE#16#FF;",
        "x := BOOL#1; x := BOOL#FALSE; x := BOOL#TRUE; st := STRING#'a'; ws := WSTRING#\"a\"; c := CHAR#'a';",
    ] {
        assert!(
            codes(variables, sound).is_empty(),
            "{sound}: {:?}",
            codes(variables, sound)
        );
    }
    for (wrong, code) in [
        ("s := INT#5;", "P4035"),
        ("d := REAL#5;", "P4035"),
        ("b := WORD#5;", "P4035"),
        ("b := USINT#5;", "P4035"),
        ("st := STRING#\"a\";", "P4034"),
        ("ws := WSTRING#'a';", "P4034"),
        ("c := CHAR#'ab';", "P2026"),
        ("c := CHAR#'';", "P2026"),
        ("s := ENUM#X;", "P2004"),
    ] {
        assert_eq!(codes(variables, wrong), [code], "{wrong}");
    }
    assert_eq!(
        codes_in(MATIEC, variables.trim_end_matches(" c : CHAR;"), "d := SINT#5;"),
        ["P4035"]
    );
}

#[test]
fn later_types_are_said_to_be_later_and_nothing_else_is() {
    assert_eq!(
        codes_in(ED2, "t : LTIME := 5;", "t := TRUE; t := t + 1;"),
        ["P0010"]
    );
    assert_eq!(codes_in(ED2, "t : TIME;", "t := LTIME#5s;"), ["P0010"]);
    assert_eq!(codes_in(ED2, "t, u : LTIME := LTIME#5s;", "t := u;"), ["P0010"]);
    let inside = "s : STRUCT t : LTIME := LTIME#5s; END_STRUCT;";
    assert_eq!(codes_in(ED2, inside, "s.t := x;"), ["P0010", "P4007"]);
    assert_eq!(codes_in(ED2, "t : TIME;", "t := LT#5s + T#1s;"), ["P0010"]);
    assert_eq!(codes_in(ED2, "t : BOOL;", "t := CHAR#'a';"), ["P0010"]);
    assert_eq!(
        codes_in(
            ED2,
            "t : ARRAY[0..1] OF WCHAR; s : STRUCT a : LDT; END_STRUCT;",
            "t[0] := s.a;"
        ),
        ["P0010", "P0010"]
    );
    assert!(codes_in(ED3, "t : LTIME; c : CHAR;", "t := LTIME#5s; c := 'a'; t := T#1s;").is_empty());
    let own =
        "TYPE LTIME : (A, B); END_TYPE PROGRAM main VAR t : LTIME; END_VAR t := LTIME#B; t := A; END_PROGRAM";
    assert!(super::says_in(ED2, own).is_empty());
}

#[test]
fn integer_literals_become_reals_with_one_rounding() {
    gives(
        "PROGRAM main VAR a, b, c, d, e : REAL; f : LREAL; END_VAR
         a := 16777217; b := 33554435; c := 16#1000001; d := -16777217; e := 9007199791611905;
         f := 9007199254740993; END_PROGRAM",
        &[
            "a = REAL#16777216.0",
            "b = REAL#33554436.0",
            "c = REAL#16777216.0",
            "d = REAL#-16777216.0",
            // By way of LREAL this would be rounded twice, to 9007199254740992.
            "e = REAL#9007200328482816.0",
            "f = LREAL#9007199254740992.0",
        ],
    );
}

#[test]
fn untyped_literals_take_their_type_from_around_them() {
    gives(
        "PROGRAM main VAR a : LINT; b : REAL; c : LREAL; d : ULINT; e, f : BOOL; g : DINT; END_VAR
         a := 2000000000 + 2000000000; b := 0.1 + 0.2; c := 0.1 + 0.2; d := 10000000000000000000 + 1;
         e := 3000000000 > 2000000000; f := -1 < 0.5; g := -7 / 2 * 2; END_PROGRAM",
        &[
            "a = LINT#4000000000",
            "b = REAL#0.3",
            "c = LREAL#0.30000000000000004",
            "d = ULINT#10000000000000000001",
            "e = BOOL#TRUE",
            "f = BOOL#TRUE",
            "g = DINT#-6",
        ],
    );
}

#[test]
fn strings_are_read_with_their_escapes_and_cut_to_their_targets() {
    gives(
        "PROGRAM main VAR a : STRING; b : WSTRING[2] := \"abc\"; c : CHAR; d : WCHAR; e : STRING[3]; END_VAR
         a := 'it$'s$N'; c := '$41'; d := \"$20AC\"; e := 'abcdef'; END_PROGRAM",
        &[
            "a = STRING#'it$'s$0A'",
            "b = WSTRING#\"ab\"",
            "c = CHAR#'A'",
            "d = WCHAR#\"$20AC\"",
            "e = STRING#'abc'",
        ],
    );
    assert_eq!(codes("s : STRING;", "s := '€';"), ["P4052"]);
}

#[test]
fn a_real_literal_is_an_integer_where_the_dialect_takes_it_for_every_number() {
    let strucpp = DialectName::STRUCPP;
    assert_eq!(
        codes_in(strucpp, "i : INT;", "i := 1.5;"),
        ["S0003"],
        "taken, with a warning"
    );
    assert_eq!(codes_in(strucpp, "r : REAL;", "r := 1.5;"), [""; 0]);
    assert_eq!(codes_in(strucpp, "b : BOOL;", "b := 1.5;"), ["P4035"]);
    assert_eq!(codes_in(ED3, "i : INT;", "i := 1.5;"), ["P4035"]);
    // An operand has the type of the other one, and no document says that a real literal is an integer there.
    assert_eq!(
        codes_in(strucpp, "i : INT; r : REAL;", "r := i + 1.5;"),
        ["P4049"]
    );
}
