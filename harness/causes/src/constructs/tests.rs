//! Tests of `constructs.rs`.

use super::Constructs;

/// Returns whether a body may become another, both with the same variables.
fn may_become(body: &str, smaller: &str) -> bool {
    let variables = "VAR a, b : ARRAY[0..3] OF WORD; w, v : WORD; r : REAL; n : INT; s : R; END_VAR";
    let whole = |body: &str| Constructs::of(&format!("PROGRAM p {variables} {body} END_PROGRAM"));
    whole(body).may_become(&whole(smaller))
}

#[test]
fn an_element_a_bit_and_a_field_stay_what_they_are() {
    for (body, smaller) in [
        ("a[1] := b[2];", "a := b;"),
        ("a[1] := b[2];", "a[1] := b;"),
        ("w.3 := v.4;", "w := v;"),
        ("w.%X3 := v.%X4;", "w := v;"),
        ("a[1].3 := b[2].3;", "a[1] := b[2];"),
        ("s.f := s.g;", "s := s;"),
        ("s(in := n); n := s.out;", "n := s;"),
        ("w := data.%W1;", "w := a.%W1; q := w;"),
    ] {
        assert!(!may_become(body, smaller), "{body} {smaller}");
    }
    for (body, smaller) in [
        ("a[1] := b[2]; w := v;", "a[0] := b[2];"),
        ("a := b; a[1] := w;", "a := b;"),
        ("n := f(w.3); r := w;", "n := f(w);"),
    ] {
        assert!(may_become(body, smaller), "{body} {smaller}");
    }
}

#[test]
fn a_variable_of_another_type_has_lost_what_belongs_to_the_former_type() {
    let of = |declared: &str, body: &str| {
        Constructs::of(&format!(
            "PROGRAM p VAR x, a : {declared}; END_VAR {body} END_PROGRAM"
        ))
    };
    let whole = of("ARRAY[0..1] OF INT", "x[0] := a[1];");
    assert!(whole.may_become(&of("INT", "x := a;")));
    assert!(!whole.may_become(&of("ARRAY[0..1] OF INT", "x := a;")));
}

#[test]
fn no_form_of_literal_takes_the_place_of_another() {
    for (body, smaller) in [
        ("r := 0.0;", "r := 0;"),
        ("r := REAL#0.5;", "r := 0.5;"),
        ("n := INT#5;", "n := 5;"),
        ("n := INT#5;", "n := UINT#5;"),
        ("n := 16#F;", "n := 5;"),
        ("n := w;", "n := 0;"),
        ("n := w;", "n := FALSE;"),
        ("s := \"a\";", "s := 'a';"),
        // The numbers of a repetition, a subscript and a bit are no values.
        ("a[1] := w.2;", "r := 1;"),
    ] {
        assert!(!may_become(body, smaller), "{body} {smaller}");
    }
    assert!(may_become("r := -1.5E-3; n := 7;", "n := 0; r := 1.0;"));
    assert!(may_become("n := INT#-5;", "n := INT#0;"));
    // The program has such literals, and gives none to a number or to an integer.
    assert!(!may_become("IF TRUE THEN n := 5; END_IF;", "n := FALSE;"));
    assert!(!may_become("r := 0.5; n := 5;", "n := 0.5;"));
    assert!(may_become("n := 0.5; r := 0.5;", "n := 0.5;"));
    assert!(may_become(
        "WHILE n < w DO n := w; END_WHILE;",
        "WHILE TRUE DO n := w; END_WHILE;"
    ));
}

#[test]
fn an_operator_between_two_operands_does_not_become_one_before_an_operand() {
    for (body, smaller) in [("n := n - w;", "n := -w;"), ("n := (n) + 5;", "n := +5;")] {
        assert!(!may_become(body, smaller), "{body} {smaller}");
    }
    assert!(may_become("n := n - -w;", "n := -w;"));
    assert!(may_become("n := -n - w;", "n := n - w;"));
}

#[test]
fn a_comparison_stays_one_of_numbers() {
    let may_become = |body: &str, smaller: &str| {
        let of = |body: &str| {
            Constructs::of(&format!(
                "PROGRAM p VAR o : BOOL; b, c : BYTE; END_VAR {body} END_PROGRAM"
            ))
        };
        of(body).may_become(&of(smaller))
    };
    for (body, smaller) in [
        ("o := b <= c;", "o := b;"),
        ("o := b < c;", "o := b < FALSE;"),
        ("o := b = 1;", "o := TRUE = 1;"),
    ] {
        assert!(!may_become(body, smaller), "{body} {smaller}");
    }
    assert!(may_become("o := b; o := b <= c;", "o := b;"));
    assert!(may_become("o := b <= c; c := b;", "o := o; c := b;"));
    assert!(may_become("o := o = TRUE;", "o := FALSE = o;"));
}

#[test]
fn a_constant_with_which_a_variable_begins_stays_one() {
    let of = |section: &str, value: &str| {
        Constructs::of(&format!(
            "PROGRAM p {section} a, b : INT := 5; END_VAR VAR x : INT := {value}; END_VAR x := a; END_PROGRAM"
        ))
    };
    let whole = of("VAR CONSTANT", "a");
    assert!(!whole.may_become(&of("VAR", "a")));
    assert!(whole.may_become(&of("VAR", "5")));
    assert!(of("VAR", "a").may_become(&of("VAR", "b")));
    assert!(whole.may_become(&of("VAR CONSTANT", "b")));
}

#[test]
fn what_begins_keeps_its_end() {
    let of = |end: &str| Constructs::of(&format!("PROGRAM p VAR n : TIME; END_VAR n := T#1s; {end}"));
    assert!(!of("END_PROGRAM").may_become(&of("ENDPROGRAM")));
    assert!(of("ENDPROGRAM").may_become(&of("ENDPROGRAM")));
    assert!(!may_become(
        "IF n THEN n := w; END_IF;",
        "IF n THEN n := w; ENDIF;"
    ));
}

#[test]
fn a_repetition_repeats_something() {
    let of = |list: &str| {
        Constructs::of(&format!(
            "PROGRAM p VAR a : ARRAY[0..1] OF INT := {list}; END_VAR a[0] := a[1]; END_PROGRAM"
        ))
    };
    assert!(!of("[2(INT#5)]").may_become(&of("[0(INT#5)]")));
    assert!(!of("[2(INT#5)]").may_become(&of("[2()]")));
    assert!(of("[2(INT#5)]").may_become(&of("[1(INT#0)]")));
    assert!(of("[0(INT#5)]").may_become(&of("[0(INT#0)]")));
    let counting = |step: &str| format!("FOR n := 1 TO 5 BY {step} DO w := v; END_FOR;");
    assert!(!may_become(&counting("w"), &counting("0")));
}

#[test]
fn a_program_without_variables_or_statements_is_none_to_ask_about() {
    let is_whole = |program: &str| Constructs::of(program).is_whole;
    assert!(is_whole("PROGRAM p VAR x : INT; END_VAR x := 1; END_PROGRAM"));
    assert!(!is_whole("PROGRAM p VAR x : INT; END_VAR END_PROGRAM"));
    assert!(!is_whole("PROGRAM p VAR END_VAR x := 1; END_PROGRAM"));
    assert!(!is_whole("PROGRAM p x := 1; END_PROGRAM"));
    assert!(!may_become("n := 1;", ";"));
    assert!(!may_become(
        "CASE n OF 1: n := 2; END_CASE;",
        "CASE n OF 1: ; END_CASE;"
    ));
    assert!(may_become("n := 1; ;", ";"));
}

#[test]
fn what_no_document_promises_does_not_come_into_a_program() {
    let is_kept = |whole: &str, smaller: &str| Constructs::of(whole).may_become(&Constructs::of(smaller));
    let program = "PROGRAM p VAR x : INT; END_VAR x := x; END_PROGRAM";
    let with_type = |fields: &str| format!("TYPE r : STRUCT {fields} END_STRUCT; END_TYPE {program}");
    assert!(is_kept(&with_type("a, b : INT;"), &with_type("a : INT;")));
    assert!(!is_kept(&with_type("a, b : INT;"), &with_type("")));
    assert!(is_kept(&with_type(""), &with_type("")));
    let with_resource = |inside: &str| format!("{program} CONFIGURATION c {inside} END_CONFIGURATION");
    let resource = |inside: &str| with_resource(&format!("RESOURCE r ON PLC {inside} END_RESOURCE"));
    let whole = resource("TASK t(INTERVAL := T#1s, PRIORITY := 0); PROGRAM i WITH t : p;");
    assert!(is_kept(&whole, &resource("PROGRAM i : p;")));
    assert!(is_kept(&whole, program));
    assert!(!is_kept(
        &whole,
        &resource("TASK t(INTERVAL := T#1s); PROGRAM i WITH t : p;")
    ));
    // Without a use it needs no external variable.
    let unused = |body: &str| {
        format!(
            "PROGRAM p VAR x : INT; END_VAR {body} END_PROGRAM CONFIGURATION c VAR_GLOBAL g : INT; END_VAR RESOURCE r ON PLC PROGRAM i : p; END_RESOURCE END_CONFIGURATION"
        )
    };
    assert!(is_kept(&unused("x := x; x := x;"), &unused("x := x;")));
    let with_global = |section: &str| {
        format!(
            "PROGRAM p VAR_{section} g : INT; END_VAR g := g; END_PROGRAM CONFIGURATION c VAR_GLOBAL g : INT; END_VAR RESOURCE r ON PLC PROGRAM i : p; END_RESOURCE END_CONFIGURATION"
        )
    };
    assert!(!is_kept(&with_global("EXTERNAL"), &with_global("TEMP")));
    for smaller in [
        resource("TASK t(INTERVAL := T#1s, PRIORITY := 0);"),
        resource(""),
        with_resource(""),
    ] {
        assert!(!is_kept(&whole, &smaller), "{smaller}");
    }
    let block = |inputs: &str, body: &str| {
        format!(
            "FUNCTION_BLOCK b VAR_INPUT {inputs} END_VAR VAR o : WORD; f : c; END_VAR {body} END_FUNCTION_BLOCK {program}"
        )
    };
    let located =
        |place: &str| format!("PROGRAM p VAR x AT {place} : BOOL; y : BOOL; END_VAR x := y; END_PROGRAM");
    assert!(!is_kept(&located("%QX0.0"), &located("%QX00")));
    assert!(is_kept(&located("%QX0.0"), &located("%qx0.0")));
    assert!(!may_become("n := INT#5;", "INT#5;"));
    assert!(!may_become("n := INT#5;", "n = INT#5;"));
    assert!(!may_become("a[1] := INT#5;", "a[1] = INT#5;"));
    assert!(may_become("n = INT#5;", "n = INT#0;"));
    assert!(may_become(
        "CASE n OF 5: n := w; END_CASE;",
        "CASE n OF 5: n := n; END_CASE;"
    ));
    let whole = block("i : WORD;", "o := i; o.3 := i.2; f(i := i);");
    assert!(is_kept(&whole, &block("i : WORD;", "o := i; f(i := i);")));
    for body in ["o := i;", "o.3 := i.2;"] {
        assert!(is_kept(&whole, &block("i : WORD;", body)), "{body}");
        assert!(!is_kept(&whole, &block("i, o : WORD;", body)), "{body}");
    }
}
