//! Tests of the reduction of texts: the results are small, well-formed, and keep their symptom.

use crate::{Interestingness, Reduction, ReductionBudget, StopReason, text};
use stickler_types::DialectName;

/// A text with one of everything.
const MACHINE: &str = include_str!("tests/machine.st");

/// Reduces a text while it contains all of these words.
fn reduce(start: &str, words: &[&str]) -> Reduction<String> {
    let has = |text: &str| Interestingness::from(words.iter().all(|word| text.contains(word)));
    text(start, DialectName::IRONPLC_ED3, has, &ReductionBudget::default())
}

fn accepted(text: &str) {
    let diagnostics = stickler_reference::errors(text, DialectName::IRONPLC_ED3);
    assert!(diagnostics.is_empty(), "{diagnostics:?}\n{text}");
}

#[test]
fn what_remains_of_a_program_is_what_the_symptom_needs() {
    accepted(MACHINE);
    for (words, most) in [
        (&["MOD"][..], 6),
        (&["REPEAT"], 8),
        (&["CASE", ".."], 9),
        (&["XOR"], 6),
        (&["Counter", "count :="], 15),
        (&["Scale("], 13),
        (&["STRUCT", "corner.y :="], 12),
        (&["FOR", "IF"], 14),
        (&["list["], 6),
    ] {
        let found = reduce(MACHINE, words);
        accepted(&found.value);
        let lines = found.value.lines().count();
        assert_eq!(found.ended, StopReason::Smallest);
        assert!(lines <= most, "{words:?}: {lines} lines\n{}", found.value);
    }
}

#[test]
fn a_base_stays_where_it_matters() {
    let start = "PROGRAM main\nVAR\n    x : BYTE;\nEND_VAR\n    x := BYTE#2#101 XOR 16#7F;\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["XOR"]);
    assert!(
        !found.value.contains("2#") && !found.value.contains("16#"),
        "{}",
        found.value
    );
    let found = reduce(start, &["XOR", "16#"]);
    assert!(
        found.value.contains("16#0") && !found.value.contains("2#1"),
        "{}",
        found.value
    );
}

#[test]
fn a_location_goes_where_it_does_not_matter() {
    let start = "PROGRAM main\nVAR\n    x AT %MW5 : INT;\nEND_VAR\n    x := x MOD 3;\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["MOD"]);
    assert!(!found.value.contains("AT"), "{}", found.value);
    let found = reduce(start, &["MOD", "%MW5"]);
    assert!(found.value.contains("AT %MW5"), "{}", found.value);
}

#[test]
fn a_block_becomes_the_program_and_an_array_loses_dimensions_where_these_do_not_matter() {
    let start = "FUNCTION_BLOCK host\nVAR_INPUT\n    x : INT;\nEND_VAR\nVAR\n    list : ARRAY[0..1, 0..2, 0..3] OF INT;\n\
                 END_VAR\n    list[0, 1, x] := x MOD 3;\nEND_FUNCTION_BLOCK\nPROGRAM main\nVAR\n    inner : host;\nEND_VAR\n    \
                 inner(x := 2);\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["list[", "MOD", "END_PROGRAM"]);
    accepted(&found.value);
    assert!(
        !found.value.contains("FUNCTION_BLOCK") && !found.value.contains("VAR_INPUT"),
        "{}",
        found.value
    );
    assert!(!found.value.contains(','), "{}", found.value);
    assert!(
        reduce(start, &["MOD", "VAR_INPUT"])
            .value
            .contains("FUNCTION_BLOCK")
    );
}

#[test]
fn a_structure_becomes_its_element_where_it_does_not_matter() {
    let start = "TYPE\n    Pair : STRUCT\n        a : BOOL;\n        b : INT;\n    END_STRUCT;\nEND_TYPE\nPROGRAM main\nVAR\n    it : Pair := \
                 (b := 7);\nEND_VAR\n    it.b := it.b MOD 3;\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["it", "MOD"]);
    accepted(&found.value);
    assert!(found.value.contains("it : INT;"), "{}", found.value);
    let found = reduce(start, &["it.b", "MOD"]);
    assert!(found.value.contains("STRUCT"), "{}", found.value);
}

#[test]
fn one_variable_takes_the_place_of_others_and_of_calls() {
    let start = "PROGRAM main\nVAR\n    a : DWORD;\n    b : DWORD;\n    c : UDINT;\nEND_VAR\n    a := SEL(TRUE, b, \
                 UDINT_TO_DWORD(c));\nEND_PROGRAM\n";
    accepted(start);
    let without_literals =
        |text: &str| Interestingness::from(text.contains("SEL(TRUE, ") && !text.contains(['0', '1']));
    let dialect = DialectName::IRONPLC_ED3;
    let found = text(start, dialect, without_literals, &ReductionBudget::default());
    accepted(&found.value);
    assert!(found.value.contains("a := SEL(TRUE, a, a);"), "{}", found.value);
    assert_eq!(found.value.matches(" : ").count(), 1, "{}", found.value);
}

#[test]
fn the_result_of_a_function_becomes_plain_where_it_does_not_matter() {
    let start = "TYPE PAIR : ARRAY[0..1] OF REAL; END_TYPE\nFUNCTION take : PAIR\nVAR_INPUT\n    it : PAIR;\nEND_VAR\n    take := it;\n\
                 END_FUNCTION\nPROGRAM main\nVAR\n    into : PAIR;\n    from : PAIR;\nEND_VAR\n    into := take(it := from);\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["it : ", "ARRAY", "take(", "from"]);
    accepted(&found.value);
    assert!(found.value.contains("take : INT"), "{}", found.value);
    assert!(
        found.value.contains("into := take(it := from)"),
        "{}",
        found.value
    );
}

#[test]
fn a_function_becomes_the_program_with_the_literals_that_it_is_given() {
    let start = "FUNCTION combine : LINT\nVAR_INPUT\n    first, second : DINT;\nEND_VAR\n    combine := first * second;\nEND_FUNCTION\n\
                 PROGRAM main\nVAR\n    into : LINT;\nEND_VAR\n    into := combine(DINT#7, DINT#5);\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["into := ", "*", "7", "5"]);
    accepted(&found.value);
    for gone in ["FUNCTION", "combine", "VAR_INPUT"] {
        assert!(!found.value.contains(gone), "{gone}\n{}", found.value);
    }
}

#[test]
fn what_does_not_matter_in_initial_values_and_texts_goes() {
    let start = "TYPE\n    POINT : STRUCT\n        x : INT;\n        y : INT;\n    END_STRUCT;\n    BOX : STRUCT\n        list : ARRAY[0..1] OF \
                 DT;\n    END_STRUCT;\nEND_TYPE\nPROGRAM main\nVAR\n    it : ARRAY[0..1] OF POINT := [2((x := 1, y := 2))];\n    inner : \
                 BOX;\n    text : STRING := 'ab$R$$$L$0A';\nEND_VAR\n    it[0].x := 0;\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["[", "(x := "]);
    assert!(
        !found.value.contains('y') && !found.value.contains("2("),
        "{}",
        found.value
    );
    let found = reduce(start, &["inner :", "OF DT"]);
    assert!(!found.value.contains("STRUCT"), "{}", found.value);
    let found = reduce(start, &["$L"]);
    assert!(found.value.contains("'$L'"), "{}", found.value);
}

#[test]
fn an_array_gets_shorter_with_the_values_that_it_begins_with() {
    let start = "TYPE\n    BOX : STRUCT\n        list : ARRAY[0..2] OF INT;\n    END_STRUCT;\nEND_TYPE\nPROGRAM main\nVAR\n    it : BOX := (list := \
                 [7, 8, 9]);\n    other : ARRAY[1..3] OF INT := [4, 5, 6];\nEND_VAR\n    it.list[0] := other[1];\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["(list := [7", ":= [4", "it.list[0]"]);
    accepted(&found.value);
    for (kept, gone) in [
        ("[7])", "8"),
        ("[4];", "5"),
        ("[0..0]", "..2"),
        ("ARRAY[0..0] OF INT := [4]", "..3"),
    ] {
        assert!(
            found.value.contains(kept) && !found.value.contains(gone),
            "{kept} {gone}\n{}",
            found.value
        );
    }
}

#[test]
fn a_statement_that_does_nothing_assigns_the_initial_value() {
    // A value that does not fit, which no run shows.
    let start = "PROGRAM main\nVAR\n    r : BYTE := BYTE#256;\nEND_VAR\n    r := r;\nEND_PROGRAM\n";
    let found = reduce(start, &["r :=", "#256"]);
    assert!(found.value.contains("r : BYTE;"), "{}", found.value);
    assert!(found.value.contains("    r := BYTE#256;"), "{}", found.value);
}

#[test]
fn a_parameter_goes_with_its_arguments_where_it_does_not_matter() {
    let start = "FUNCTION_BLOCK host\nVAR_INPUT\n    first : INT;\n    second : BOOL;\nEND_VAR\nVAR_IN_OUT\n    third : INT;\nEND_VAR\n    \
                 third := first MOD 3;\nEND_FUNCTION_BLOCK\nFUNCTION twice : INT\nVAR_INPUT\n    a : INT;\n    b : INT;\nEND_VAR\n    \
                 twice := 0;\nEND_FUNCTION\nPROGRAM main\nVAR\n    inner : host;\n    n : INT;\nEND_VAR\n    inner(first := n, \
                 second := TRUE, third := n);\n    n := twice(n, 5);\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["inner(", "second :=", "twice("]);
    accepted(&found.value);
    for gone in ["first", "third", ", 5", "b : INT"] {
        assert!(!found.value.contains(gone), "{gone}\n{}", found.value);
    }
}

#[test]
fn a_real_number_keeps_its_exponent_and_loses_its_digits() {
    let start = "PROGRAM main\nVAR\n    a : LREAL;\nEND_VAR\n    a := 8.968310E-44;\nEND_PROGRAM\n";
    accepted(start);
    let found = reduce(start, &["a := ", "E-44"]);
    assert!(found.value.contains("a := 1.0E-44;"), "{}", found.value);
}

#[test]
fn a_text_that_nobody_can_parse_is_cut_down_to_what_matters() {
    let start =
        "PROGRAM main\nVAR x : INT; END_VAR\n  x := 1 + ;\n  y := 'open string\n  @@ z(\nEND_PROGRAM\n";
    let found = reduce(start, &["@@"]);
    assert_eq!(found.value.trim(), "@@");
}

#[test]
fn a_rejected_text_gets_no_new_faults() {
    let start = MACHINE.replace("total : DINT;", "total : INT;");
    let codes = |text: &str| {
        let diagnostics = stickler_reference::errors(text, DialectName::IRONPLC_ED3);
        let codes: Vec<String> = diagnostics.iter().filter_map(|one| one.code.clone()).collect();
        codes
    };
    let before = codes(&start);
    assert!(!before.is_empty());
    let mut all = Vec::new();
    let same = |text: &str| {
        let now = codes(text);
        all.extend(now.clone());
        Interestingness::from(now.contains(&before[0]))
    };
    let found = text(
        &start,
        DialectName::IRONPLC_ED3,
        same,
        &ReductionBudget::default(),
    );
    assert!(all.iter().all(|code| before.contains(code)), "{all:?}");
    assert!(found.value.lines().count() <= 8, "{}", found.value);
}
