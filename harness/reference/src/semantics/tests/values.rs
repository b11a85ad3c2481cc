//! Values that programs compute where lowering could go wrong.

use super::{ED3, gives, gives_in};

#[test]
fn implicit_conversions_are_performed_in_every_context() {
    gives(
        "TYPE S : STRUCT r : LREAL := i5; END_STRUCT; END_TYPE VAR_GLOBAL CONSTANT i5 : INT := 5; END_VAR
         FUNCTION F : LREAL VAR_INPUT x : REAL; END_VAR VAR_OUTPUT o : INT; END_VAR VAR_IN_OUT v : REAL; END_VAR F := x; o := -3; v := o; END_FUNCTION
         FUNCTION_BLOCK B VAR_INPUT x : LREAL; END_VAR END_FUNCTION_BLOCK
         PROGRAM main VAR u : UDINT := 4000000000; i : INT := -7; l : LINT := u; r : REAL := i; s : S; t : S := (r := i); a : ARRAY[0..1] OF LREAL := [i, 2(u)];
         f : LREAL; o : LREAL; v : REAL; b : B; c : BOOL; k : LREAL; END_VAR
         l := l + u; f := F(x := i, v := v, o => o); b(x := i); c := r < i + 1; k := SEL(c, f, i); END_PROGRAM"
            .replace("[i, 2(u)]", "[i, 1(u)]")
            .as_str(),
        &[
            "l = LINT#8000000000", "r = REAL#-7.0", "s.r = LREAL#5.0", "t.r = LREAL#-7.0", "a[0] = LREAL#-7.0", "a[1] = LREAL#4.0E9",
            "f = LREAL#-7.0", "o = LREAL#-3.0", "v = REAL#-3.0", "b.x = LREAL#-7.0", "c = BOOL#TRUE", "k = LREAL#-7.0",
        ],
    );
}

#[test]
fn function_blocks_keep_what_they_are_not_given() {
    gives_in(
        ED3,
        "FUNCTION_BLOCK B VAR_INPUT a : INT := 1; b : INT := 2; END_VAR VAR_OUTPUT sum : INT; END_VAR VAR n : INT; END_VAR
         VAR_TEMP t : INT := 5; u : INT; END_VAR n := n + 1; t := t + 1; u := u + 1; sum := a * 100 + b * 10 + t + u - 7; END_FUNCTION_BLOCK
         PROGRAM main VAR x, y : B; first, second, third : INT; END_VAR
         x(b := 3, sum => first); x(a := 4); second := x.sum; y(); third := y.sum; END_PROGRAM",
        2,
        &["first = INT#430", "second = INT#430", "third = INT#120", "x.n = INT#4", "y.n = INT#2"],
    );
}

#[test]
fn instances_may_be_chosen_as_the_program_runs() {
    gives(
        "FUNCTION_BLOCK B VAR_INPUT a : INT; END_VAR VAR_OUTPUT q : INT; w : STRING[3]; END_VAR VAR_IN_OUT s : INT; END_VAR
         q := a + 1; s := s + q; w := 'abcd'; END_FUNCTION_BLOCK
         FUNCTION NEXT : INT VAR_IN_OUT n : INT; END_VAR n := n + 1; NEXT := n; END_FUNCTION
         TYPE H : STRUCT b : ARRAY[0..3] OF B; END_STRUCT; END_TYPE
         PROGRAM main VAR h : ARRAY[0..1] OF H; n, s : INT; o : ARRAY[0..3] OF DINT; t : STRING; END_VAR
         h[1].b[NEXT(n)](a := NEXT(n), s := s, q => o[NEXT(n)], w => t); END_PROGRAM",
        &["n = INT#3", "s = INT#3", "h[1].b[1].q = INT#3", "o[3] = DINT#3", "t = STRING#'abc'", "h[0].b[1].q = INT#0"],
    );
}

#[test]
fn nested_blocks_and_references_reach_the_right_cells() {
    gives(
        "FUNCTION_BLOCK INNER VAR_IN_OUT a : ARRAY[0..2] OF INT; END_VAR VAR_INPUT i : INT; END_VAR VAR_OUTPUT n : INT; END_VAR
         a[i] := a[i] + 10; n := n + a[i]; a[i].0 := TRUE; END_FUNCTION_BLOCK
         FUNCTION_BLOCK OUTER VAR one, two : INNER; END_VAR VAR_IN_OUT a : ARRAY[0..2] OF INT; END_VAR VAR k : ARRAY[0..2] OF INT := [5, 6, 7]; END_VAR
         one(a := a, i := 1); two(a := k, i := 2); two(a := a); k[0] := one.n; END_FUNCTION_BLOCK
         PROGRAM main VAR o : OUTER; x : ARRAY[0..2] OF INT := [1, 2, 4]; END_VAR o(a := x); END_PROGRAM",
        &["x[0] = INT#1", "x[1] = INT#13", "x[2] = INT#15", "o.k[2] = INT#17", "o.k[0] = INT#12", "o.two.n = INT#31"],
    );
}

#[test]
fn aggregates_are_copied_whole() {
    gives(
        "TYPE P : STRUCT n : STRING[5]; a : ARRAY[0..1] OF INT; END_STRUCT; END_TYPE
         PROGRAM main VAR p : ARRAY[0..2] OF P; q : P; i : INT := 1; m : ARRAY[0..1] OF ARRAY[0..1] OF INT; END_VAR
         q.n := 'q'; q.a[1] := 7; p[i] := q; p[i + 1] := p[i]; q.n := 'z'; p[0] := p[0]; m[0][1] := 3; m[1] := m[0]; m[i][0] := 4; END_PROGRAM",
        &["p[1].n = STRING#'q'", "p[2].n = STRING#'q'", "p[2].a[1] = INT#7", "q.n = STRING#'z'", "m[1][1] = INT#3", "m[1][0] = INT#4", "p[0].n = STRING#''"],
    );
}

#[test]
fn inputs_that_a_call_leaves_out_take_their_defaults_anew() {
    gives(
        "TYPE P : STRUCT x : INT := 3; s : STRING[9] := 'abc'; END_STRUCT; END_TYPE
         FUNCTION F : INT VAR_INPUT a : INT; p : P; b : INT := 2; s : STRING := 'xy'; END_VAR
         F := a * 1000 + p.x * 100 + b * 10 + LEN(s) + LEN(p.s); p.x := 9; b := 9; s := 'long'; a := 9; END_FUNCTION
         PROGRAM main VAR one, two, three : INT; q : P := (x := 1, s := ''); END_VAR
         one := F(a := 1); two := F(p := q, b := 5); three := F(b := F(a := 0) - 320); END_PROGRAM",
        &["one = INT#1325", "two = INT#152", "three = INT#355"],
    );
}

#[test]
fn texts_travel_through_calls_and_selections() {
    gives(
        "FUNCTION JOIN : STRING[10] VAR_INPUT a, b : STRING[4]; END_VAR VAR_OUTPUT n : INT; END_VAR JOIN := CONCAT(a, b, '!'); n := LEN(JOIN); END_FUNCTION
         PROGRAM main VAR s : STRING; n : DINT; b : BOOL; w : WSTRING; END_VAR
         s := JOIN(JOIN('abcdef', 'x'), SEL(TRUE, 'no', 'yes'), n => n); b := 'abc' < s AND s > 'ABC'; w := SEL(b, \"x\", \"y\"); END_PROGRAM"
            .replace("JOIN(JOIN('abcdef', 'x'), SEL(TRUE, 'no', 'yes'), n => n)", "JOIN(a := JOIN('abcdef', 'x'), b := SEL(TRUE, 'no', 'yes'), n => n)")
            .as_str(),
        &["s = STRING#'abcdyes!'", "n = DINT#8", "b = BOOL#TRUE", "w = WSTRING#\"y\""],
    );
}

#[test]
fn several_instances_of_a_program_keep_apart() {
    gives_in(
        ED3,
        "FUNCTION_BLOCK C VAR n : INT; END_VAR n := n + 1; END_FUNCTION_BLOCK
         PROGRAM p VAR n : INT := 10; c : C; s : STRING := 'a'; a : ARRAY[0..1] OF INT; i : INT; END_VAR
         n := n + 1; c(); s := CONCAT(s, 'b'); FOR i := 0 TO 1 DO a[i] := a[i] + n; END_FOR; n.8 := TRUE; END_PROGRAM
         CONFIGURATION k RESOURCE r ON x PROGRAM one : p; PROGRAM two : p; END_RESOURCE END_CONFIGURATION",
        2,
        &["one.n = INT#268", "two.n = INT#268", "two.c.n = INT#2", "two.s = STRING#'abb'", "one.a[1] = INT#279"],
    );
}
