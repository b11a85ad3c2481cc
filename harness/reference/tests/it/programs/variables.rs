//! Declared types, initial values, and values of every shape by their names.

use super::support::{DIALECT, assert_body, assert_values, attempt, program};
use stickler_reference::RequestError;

const TYPES: &str = "
TYPE
    COLOR : (RED, GREEN := 5, BLUE) := GREEN;
    PERCENT : INT(0..100) := 50;
    POINT : STRUCT x : INT := 1; y : REAL; END_STRUCT;
    LINE : STRUCT ends : ARRAY[0..1] OF POINT; name : STRING[5] := 'line'; END_STRUCT;
END_TYPE
";

#[test]
fn variables_begin_with_what_their_types_and_initializers_say() {
    let source = format!(
        "{TYPES} PROGRAM main VAR
            c : COLOR; d : COLOR := BLUE; p : PERCENT; q : PERCENT := 7;
            a : LINE; b : LINE := (ends := [(x := 3), (y := 2)], name := 'another');
            n : ARRAY[1..2, 0..2] OF INT := [1, 2(7), 3];
        END_VAR END_PROGRAM"
    );
    let expected = [
        "c = COLOR#GREEN",
        "d = COLOR#BLUE",
        "p = INT#50",
        "q = INT#7",
        "a.ends[1].x = INT#1",
        "a.name = STRING#'line'",
        "b.ends[0].x = INT#3",
        "b.ends[1].x = INT#1",
        "b.ends[1].y = REAL#2.0",
        "b.name = STRING#'anoth'",
        "n[1,2] = INT#7",
        "n[2,0] = INT#3",
        "n[2,1] = INT#0",
    ];
    assert_values(&source, &expected);
}

#[test]
fn structures_and_arrays_are_assigned_whole() {
    let source = format!(
        "{TYPES} PROGRAM main VAR a, b : LINE; s : ARRAY[1..3] OF STRING[3]; t : ARRAY[1..3] OF STRING[3]; END_VAR
         a.ends[1].x := 9; a.name := 'first'; b := a; a.name := 'later'; a.ends[1].x := 8;
         s[2] := 'abc'; t := s; s[2] := 'xyz'; END_PROGRAM"
    );
    assert_values(
        &source,
        &[
            "b.ends[1].x = INT#9",
            "b.name = STRING#'first'",
            "t[2] = STRING#'abc'",
        ],
    );
}

#[test]
fn texts_are_cut_joined_and_measured() {
    assert_body(
        "a : STRING[3] := 'abcdef'; b : STRING := 'xy'; c : STRING[10]; n : INT; e : BOOL; w : WSTRING[4] := \"ä€\";",
        "c := CONCAT(a, b, '!'); n := LEN(c); e := b > a;",
        &[
            "a = STRING#'abc'",
            "c = STRING#'abcxy!'",
            "n = INT#6",
            "e = BOOL#TRUE",
            "w = WSTRING#\"$00E4$20AC\"",
        ],
    );
}

#[test]
fn names_are_found_in_any_case_and_unknown_ones_are_errors() {
    let source = program("Big : DINT := 5; arr : ARRAY[1..2] OF INT;", ";");
    assert_values(&source, &["BIG = DINT#5", "arr[2] = INT#0"]);
    for name in [
        "small", "arr", "arr[3]", "arr[1].x", "Big.3", "", "arr[", "Big[1]",
    ] {
        let outcome = attempt(DIALECT, &source, &[name]);
        assert!(
            matches!(outcome, Err(RequestError::UnknownName { .. })),
            "{name}: {outcome:?}"
        );
    }
}
