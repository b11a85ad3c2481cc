//! Variables, elements, fields and bits.

use super::{ED2, ED3, MATIEC, PLCNEXT, codes, codes_in, gives, says, says_in};

const VARIABLES: &str = "s : SINT; i, k : INT; l : LINT; y : BYTE; w : WORD; b : BOOL; r : REAL; t : TIME; st : STRING; x : SINT(0..5);
    a : ARRAY[0..3] OF INT; m : ARRAY[1..2, -1..1] OF BYTE; p : STRUCT f : INT; g : ARRAY[0..1] OF WORD; END_STRUCT;
    e : (UP, DOWN); END_VAR VAR CONSTANT c : INT := 3; cb : BYTE := 5; ca : ARRAY[0..1] OF INT := [1, 2];";

#[test]
fn places_are_read_and_written() {
    for sound in [
        "a[0] := a[3]; a[i] := 1; a[a[i]] := p.f; m[1, -1] := m[i, 0]; p.g[1] := w; a[s] := l.0 = b;",
        "y.0 := b; b := s.7; l.63 := TRUE; a[i].15 := b; p.f.3 := p.g[i].2; m[2, 0].7 := y.%X3; x.1 := b; k := ca[1];",
        "b := c.0; b := cb.7; a[c] := c;",
    ] {
        let said = codes(VARIABLES, sound);
        assert!(
            said.is_empty() || sound.starts_with("a[0]") && said == ["P4035"],
            "{sound}: {said:?}"
        );
    }
    for (wrong, code) in [
        ("b := y.8;", "P4025"),
        ("b := s.8;", "P4025"),
        ("b := i.16;", "P4025"),
        ("b := l.64;", "P4025"),
        ("b := y.%X8;", "P4025"),
        ("b := y.99999999999999999999999;", "P4025"),
        ("y.8 := b;", "P4025"),
        ("b := b.0;", "P4069"),
        ("b := r.0;", "P4069"),
        ("b := t.0;", "P4069"),
        ("b := st.0;", "P4069"),
        ("b := a.0;", "P4069"),
        ("b := p.0;", "P4069"),
        ("b := e.0;", "P4069"),
        ("b := y.0.0;", "P4069"),
        ("y := y.0;", "P4035"),
        ("y.0 := y;", "P4035"),
        ("y.0 := 2;", "P2026"),
        ("c := 4;", "S0001"),
        ("c.0 := b;", "S0001"),
        ("ca[0] := 1;", "S0001"),
        ("FOR c := 1 TO 2 DO ; END_FOR;", "S0001"),
        ("a[4] := 1;", "P2027"),
        ("a[-1] := 1;", "P2027"),
        ("i := a[c + 1];", "P2027"),
        ("y := m[0, 0];", "P2027"),
        ("i := a[1, 2];", "P2024"),
        ("y := m[1];", "P2024"),
        ("i := i[0];", "P4049"),
        ("i := a[r];", "P4035"),
        ("i := a[1.5];", "P4035"),
        ("i := a[b];", "P4035"),
        ("i := a[w];", "P4035"),
        ("i := p.h;", "P4007"),
        ("i := i.f;", "P4007"),
        ("i := q;", "P4007"),
        ("q.f[1].3 := TRUE;", "P4007"),
        ("i := UP.3;", "P4007"),
        ("UP := 1;", "P4007"),
        ("main := 1;", "P4007"),
    ] {
        assert_eq!(codes(VARIABLES, wrong), [code], "{wrong}");
    }
}

#[test]
fn a_wrong_subscript_hides_nothing_else_that_is_wrong() {
    for (wrong, expected) in [
        ("b := a[4];", &["P2027", "P4035"][..]),
        ("a[4] := b;", &["P2027", "P4035"]),
        ("a[4] := r;", &["P2027", "P4035"]),
        ("a[r] := b;", &["P4035", "P4035"]),
        ("m[3, r] := i;", &["P2027", "P4035", "P4035"]),
        ("ca[2] := 1;", &["P2027", "S0001"]),
        ("FOR a[4] := r TO 5 DO ; END_FOR;", &["P2027", "P4035"]),
        ("b := p.g[2].16;", &["P2027", "P4025"]),
        // How many subscripts there must be may well depend on what is wanted.
        ("b := a[1, 2];", &["P2024"]),
        ("a[1, 2] := b;", &["P2024"]),
    ] {
        let mut said = codes(VARIABLES, wrong);
        said.sort_unstable();
        assert_eq!(said, expected, "{wrong}");
    }
}

#[test]
fn a_bit_outside_its_type_hides_nothing_that_is_wrong_with_a_bool() {
    for (wrong, expected) in [
        ("b := y.8;", &["P4025"][..]),
        ("i := y.8;", &["P4025", "P4035"]),
        ("y.8 := i;", &["P4025", "P4035"]),
        ("c.99 := b;", &["P4025", "S0001"]),
        ("i := i + y.8;", &["P4025", "P4049"]),
        ("b := y.8.0;", &["P4025", "P4069"]),
        ("i := r.0;", &["P4069"]),
    ] {
        let mut said = codes(VARIABLES, wrong);
        said.sort_unstable();
        assert_eq!(said, expected, "{wrong}");
    }
}

#[test]
fn bits_are_a_matter_of_the_dialect() {
    assert!(codes_in(ED2, "y : BYTE; b : BOOL;", "b := y.3;").is_empty());
    assert!(codes_in(PLCNEXT, "y : BYTE; b : BOOL;", "b := y.3; y.%X3 := b;").is_empty());
    // What the parser refuses is refused there only.
    for (dialect, access) in [(ED2, "y.%X9"), (ED3, "y.%B0"), (MATIEC, "y.9")] {
        let text =
            format!("PROGRAM main VAR y : BYTE; b : BOOL; END_VAR b := {access}; {access} := 5; END_PROGRAM");
        let (unit, said) = stickler_syntax::parse(&text, stickler_types::Dialect::of(dialect));
        assert_eq!(said.len(), 2, "{dialect}");
        let lines = stickler_syntax::source::LineIndex::new(&text);
        let (_, more) = crate::semantics::check(&unit, &text, &lines, stickler_types::Dialect::of(dialect));
        assert_eq!(more, [], "{dialect}");
    }
}

#[test]
fn a_bit_leaves_the_others_alone_and_the_sign_bit_is_one() {
    gives(
        "TYPE P : STRUCT f : SINT; END_STRUCT; END_TYPE
         FUNCTION F : INT VAR_INPUT n : INT; END_VAR F := n; F.3 := TRUE; F.0 := NOT F.0; END_FUNCTION
         FUNCTION_BLOCK B VAR_OUTPUT out : WORD := 16#00FF; END_VAR out.8 := out.7; END_FUNCTION_BLOCK
         PROGRAM main VAR s : SINT := 5; u : ULINT; a : ARRAY[0..1] OF P; i : INT := 1; n : INT; fb : B; b : BOOL; l : LINT; END_VAR
         s.7 := TRUE; u.63 := TRUE; a[i].f.6 := TRUE; a[i].f.7 := a[i].f.6; n := F(16#10); fb(); fb.out.0 := FALSE; b := fb.out.8; l.63 := b;
         END_PROGRAM",
        &[
            "s = SINT#-123",
            "u = ULINT#9223372036854775808",
            "a[1].f = SINT#-64",
            "n = INT#25",
            "fb.out = WORD#16#01FE",
            "l = LINT#-9223372036854775808",
        ],
    );
}

#[test]
fn multi_dimensional_arrays_lie_in_rows() {
    gives(
        "PROGRAM main VAR m : ARRAY[1..2, -1..1, 0..1] OF INT; i, j, k, n : INT; END_VAR
         FOR i := 1 TO 2 DO FOR j := -1 TO 1 DO FOR k := 0 TO 1 DO n := n + 1; m[i, j, k] := n; END_FOR; END_FOR; END_FOR;
         m[2, i - 3, 1] := m[1, -1, 0] + 100; END_PROGRAM",
        &["m[1,-1,0] = INT#1", "m[1,1,1] = INT#6", "m[2,-1,0] = INT#7", "m[2,0,1] = INT#101", "m[2,1,1] = INT#12"],
    );
}

#[test]
fn only_variables_have_elements_fields_and_bits() {
    let text = "FUNCTION F : INT VAR_INPUT n : INT; END_VAR F := n; END_FUNCTION\nPROGRAM main VAR b : BOOL; END_VAR\nb := F(1).3;\nEND_PROGRAM";
    let (unit, said) = stickler_syntax::parse(text, stickler_types::Dialect::of(ED3));
    let lines = stickler_syntax::source::LineIndex::new(text);
    let (_, more) = crate::semantics::check(&unit, text, &lines, stickler_types::Dialect::of(ED3));
    assert_eq!(said.len() + more.len(), 1, "{said:?} {more:?}");
}

#[test]
fn names_are_found_from_the_inside_out() {
    let text = "TYPE C : (X, Y); END_TYPE VAR_GLOBAL x : INT := 1; g : INT := 2; END_VAR
        FUNCTION F : INT VAR_INPUT g : INT; END_VAR F := g + X; END_FUNCTION
        PROGRAM main VAR n : INT; y : INT := 7; END_VAR VAR_EXTERNAL g : INT; END_VAR n := F(10) + g + Y; END_PROGRAM";
    assert!(says(text).is_empty());
    gives(text, &["n = INT#20"]);
}

#[test]
fn external_variables_stand_for_global_ones() {
    let text = |external: &str| {
        format!(
            "VAR_GLOBAL g : INT; END_VAR VAR_GLOBAL CONSTANT c : INT := 1; END_VAR
PROGRAM main VAR_EXTERNAL
{external} END_VAR g := 1; END_PROGRAM"
        )
    };
    assert!(says(&text("g : INT;")).is_empty());
    assert_eq!(says(&text("g : DINT;")), ["3 P4035"]);
    assert_eq!(says(&text("h : INT;")), ["3 P4007"]);
    assert_eq!(
        says_in(
            ED2,
            "VAR_GLOBAL CONSTANT c : INT := 1; END_VAR PROGRAM main VAR_EXTERNAL c : INT; END_VAR
c := 2; END_PROGRAM"
        ),
        ["2 S0001"]
    );
}

#[test]
fn only_inputs_and_outputs_of_a_function_block_are_reached_from_outside() {
    let block = "FUNCTION_BLOCK B VAR_INPUT i : INT; END_VAR VAR l : INT; END_VAR VAR_TEMP t : INT; END_VAR
        VAR_OUTPUT o : INT; END_VAR o := l; l := i; END_FUNCTION_BLOCK
        PROGRAM main VAR b : B; x : INT; END_VAR\n";
    let said = |statement: &str| says(&format!("{block}{statement} END_PROGRAM"));
    for statement in ["x := b.o;", "x := b.i;", "b.i := 1;", "b(i := 1, o => x);"] {
        assert!(said(statement).is_empty(), "{statement}");
    }
    for statement in [
        "x := b.l;",
        "b.l := 1;",
        "x := b.t;",
        "x := b.l + 1;",
        "x := b.q;",
    ] {
        assert_eq!(said(statement), ["4 P4007"], "{statement}");
    }
    // A test observes what a program cannot reach.
    gives(
        "FUNCTION_BLOCK B VAR l : INT := 7; END_VAR END_FUNCTION_BLOCK
         PROGRAM main VAR b : B; END_VAR END_PROGRAM",
        &["b.l = INT#7"],
    );
}
