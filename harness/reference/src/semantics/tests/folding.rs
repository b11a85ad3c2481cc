//! Conversion functions of constants are constants themselves, and mean what they mean as the program runs.

use super::{MATIEC, PLCNEXT, codes, diagnose, gives, gives_in, says};
use stickler_types::{ElementaryType, MomentUnits};

/// Asserts that an expression stands for a number wherever a constant may stand, and gives it as the program runs,
/// whether the constants in it are global or local.
fn is_constant(constants: &str, expression: &str, number: i64) {
    let global = format!(
        "VAR_GLOBAL CONSTANT {constants} n : LINT := {expression}; END_VAR
         TYPE E : (RED := {expression}, GREEN); END_TYPE PROGRAM main"
    );
    let local = format!(
        "TYPE E : (RED := {number}); END_TYPE
         PROGRAM main VAR CONSTANT {constants} n : LINT := {expression}; END_VAR"
    );
    stands_for(&global, expression, number);
    stands_for(&local, expression, number);
}

fn stands_for(beginning: &str, expression: &str, number: i64) {
    let text = format!(
        "{beginning}
         VAR a : ARRAY[{expression}..200] OF SINT; b : ARRAY[n..200] OF SINT; sized : STRING[{expression}];
             r : LINT({expression}..200); hit, named : BOOL; e : E; ran : LINT; selector : LINT := {number};
             c : ARRAY[1..200] OF SINT := [{number}(1), 7]; last : SINT;
         END_VAR
             CASE selector OF {expression}: hit := TRUE; END_CASE;
             CASE selector OF n: named := TRUE; END_CASE;
             ran := {expression}; last := c[{expression} + 1];
             a[{number}] := 1; b[{number}] := 1; r := {number};
         END_PROGRAM"
    );
    let ran = format!("ran = LINT#{number}");
    gives(
        &text,
        &[
            "hit = BOOL#TRUE",
            "named = BOOL#TRUE",
            &ran,
            "last = SINT#7",
            "e = E#RED",
        ],
    );
}

#[test]
fn a_conversion_of_a_constant_stands_wherever_a_constant_may() {
    for (constants, expression, number) in [
        ("", "DINT_TO_LINT(5)", 5),
        ("", "DINT_TO_INT(65541)", 5),
        ("", "TRUNC(2.7)", 2),
        ("", "LREAL_TO_DINT(-2.9) + DINT#4", 2),
        ("", "TO_INT('12')", 12),
        ("", "STRING_TO_DINT('12')", 12),
        ("", "WSTRING_TO_INT(STRING_TO_WSTRING('12'))", 12),
        ("", "STRING_TO_INT(INT_TO_STRING(12))", 12),
        ("", "TIME_TO_DINT(T#12ms)", 12),
        ("", "BCD_TO_INT(WORD#16#12)", 12),
        ("", "CHAR_TO_INT(CHAR#'A')", 65),
        ("", "BOOL_TO_INT(TRUE)", 1),
        ("", "DATE_TO_DINT(D#1970-01-01) + 1", 1),
        ("", "DT_TO_LINT(CONCAT_DATE_TOD(D#1970-01-01, TOD#0:0:9))", 9),
        ("", "DINT_TO_INT(IN := INT#3)", 3),
        ("", "WORD_TO_INT(WORD#16#7F)", 127),
        ("d : DINT := 100;", "DINT_TO_INT(d)", 100),
        ("d : DINT := 100;", "DINT_TO_INT(d - 2 * -d) - 200", 100),
        ("x : REAL := 2.5;", "TRUNC(x)", 2),
        ("x : REAL := -2.5;", "TRUNC(-x)", 2),
        ("x : LREAL := 7;", "ROUND(x)", 7),
        ("s : STRING[2] := '123';", "STRING_TO_INT(s)", 12),
        ("t : TIME := T#3s;", "TIME_TO_LINT(t) / 1000", 3),
        ("w : WORD := 16#21;", "WORD_TO_UINT(w)", 33),
        ("w : BYTE := INT_TO_BCD(21);", "BCD_TO_INT(w)", 21),
        (
            "x : REAL := INT_TO_REAL(3); y : INT := REAL_TO_INT(x);",
            "INT_TO_SINT(y)",
            3,
        ),
    ] {
        is_constant(constants, expression, number);
    }
}

#[test]
fn a_global_constant_and_an_alias_keep_their_types() {
    gives(
        "TYPE Length : INT; Text : STRING[3]; END_TYPE
         VAR_GLOBAL CONSTANT d : DINT := 65540; n : Length := DINT_TO_INT(d); t : Text := '7890'; END_VAR
         PROGRAM main VAR a : ARRAY[1..n] OF INT; b : ARRAY[1..STRING_TO_INT(t)] OF INT; END_VAR
             a[4] := INT_TO_INT_2(n); b[789] := 1; END_PROGRAM
         FUNCTION INT_TO_INT_2 : INT VAR_INPUT x : INT; END_VAR INT_TO_INT_2 := x; END_FUNCTION",
        &["a[4] = INT#4", "b[789] = INT#1"],
    );
}

#[test]
fn a_constant_of_a_declared_type_is_known_in_the_types_around_it() {
    gives(
        "TYPE T : INT; END_TYPE
         PROGRAM main VAR pad : INT := 9; END_VAR VAR CONSTANT k : T := 4; x : REAL := 2.5; END_VAR
         VAR s : STRUCT a : INT := k; b : INT := TRUNC_INT(x); END_STRUCT; END_VAR END_PROGRAM",
        &["s.a = INT#4", "s.b = INT#2"],
    );
}

#[test]
fn the_dialect_decides_in_constants_too() {
    let text = "PROGRAM main VAR CONSTANT x : REAL := 3.5; END_VAR
        VAR n : INT; a : ARRAY[0..REAL_TO_INT(x)] OF SINT := [3(0), 3, 4]; END_VAR n := REAL_TO_INT(x); END_PROGRAM";
    assert_eq!(diagnose(MATIEC, text).len(), 1, "five values for four elements");
    gives_in(PLCNEXT, text, 1, &["n = INT#4", "a[4] = SINT#4"]);
}

#[test]
fn folding_forbids_nothing_that_variables_may() {
    gives(
        "PROGRAM main VAR i, j, k : INT; r : INT(0..10); END_VAR
         VAR CONSTANT n : INT := DINT_TO_INT(32767) + 1; END_VAR
         i := DINT_TO_INT(32767) + 1; j := n; k := -DINT_TO_INT(-32768); END_PROGRAM",
        &["i = INT#-32768", "j = INT#-32768", "k = INT#-32768"],
    );
    gives(
        "PROGRAM main VAR x, y : LINT; END_VAR
         VAR CONSTANT n : LINT := DINT_TO_INT(32767) + 1; m : LINT := DINT_TO_UINT(3) - 5; END_VAR
         x := n; y := m; END_PROGRAM",
        &[
            "n = LINT#-32768",
            "m = LINT#65534",
            "x = LINT#-32768",
            "y = LINT#65534",
        ],
    );
    assert!(codes("i : INT;", "i := 1 / DINT_TO_INT(0);").is_empty());
    assert!(codes("r : INT(0..10);", "r := DINT_TO_INT(20);").is_empty());
    let unknown =
        "END_VAR VAR CONSTANT n : INT := DINT_TO_INT(32767) + 1; END_VAR VAR a : ARRAY[0..n] OF INT;";
    assert_eq!(
        codes(unknown, ""),
        ["P4031"],
        "what the program computes is no limit of an array"
    );
}

#[test]
fn what_is_wrong_in_a_constant_conversion_is_said_once() {
    for (variables, expected) in [
        ("a : ARRAY[0..DINT_TO_INT(x)] OF INT;", "P4030"),
        ("v : DINT; a : ARRAY[0..DINT_TO_INT(v)] OF INT;", "P4010"),
        ("a : ARRAY[0..DINT_TO_INT(1, 2)] OF INT;", "P4018"),
        ("a : ARRAY[0..DINT_TO_INT()] OF INT;", "P4018"),
        ("a : ARRAY[0..DINT_TO_INT(X := 1)] OF INT;", "P4023"),
        ("a : ARRAY[0..DINT_TO_INT(LINT#1)] OF INT;", "P4026"),
        ("a : ARRAY[0..DINT_TO_INT(TRUE)] OF INT;", "P4026"),
        ("a : ARRAY[0..TRUNC('a')] OF INT;", "P4026"),
        ("a : ARRAY[0..DINT_TO_INT(3000000000)] OF INT;", "P2026"),
        ("a : ARRAY[0..DINT_TO_INT(DINT#2147483647 + 1)] OF INT;", "P4040"),
        ("a : ARRAY[0..DINT_TO_INT(1 / DINT#0)] OF INT;", "P4039"),
        ("a : ARRAY[0..INT_TO_REAL(1)] OF INT;", "P4031"),
        ("a : ARRAY[0..REAL_TO_INT(1.5 + 1.5)] OF INT;", "P4010"),
        ("a : ARRAY[0..INT_TO_DNIT(1)] OF INT;", "P4017"),
        ("a : ARRAY[0..ABS(1)] OF INT;", "P4010"),
        ("s : STRING[TRUNC(0.5)];", "P2041"),
        ("i : INT(0..DINT_TO_LINT(40000));", "P2016"),
    ] {
        let found = codes(variables, "");
        assert_eq!(found.len(), 1, "{variables}: {found:?}");
        assert_eq!(found, [expected], "{variables}");
    }
}

#[test]
fn a_constant_made_of_one_that_the_program_computes_is_no_limit() {
    let text = "END_VAR VAR CONSTANT m : INT := DINT_TO_INT(32767) + 1; n : INT := m; x : REAL := 1.5 + 1.5; END_VAR VAR";
    assert!(codes(text, "").is_empty());
    assert_eq!(codes(&format!("{text} a : ARRAY[0..n] OF INT;"), ""), ["P4031"]);
    assert_eq!(
        codes(&format!("{text} a : ARRAY[0..TRUNC(x)] OF INT;"), ""),
        ["P4031"]
    );
}

#[test]
fn a_function_block_that_is_called_like_a_conversion_function_gives_no_constant() {
    let text = "FUNCTION_BLOCK B END_FUNCTION_BLOCK VAR_GLOBAL INT_TO_DINT : B; END_VAR
        PROGRAM main VAR_EXTERNAL INT_TO_DINT : B; END_VAR VAR CONSTANT\nn : DINT := INT_TO_DINT(1); END_VAR END_PROGRAM";
    assert_eq!(says(text), ["3 P4003", "3 P4022"]);
}

#[test]
fn a_function_of_the_text_is_no_constant() {
    let text = "FUNCTION DINT_TO_INT : INT VAR_INPUT x : DINT; END_VAR DINT_TO_INT := 1; END_FUNCTION
        PROGRAM main VAR\na : ARRAY[0..DINT_TO_INT(5)] OF INT; END_VAR END_PROGRAM";
    assert_eq!(says(text), ["3 P4010"]);
}

#[test]
fn a_suggestion_for_a_constant_that_is_a_limit_makes_the_program_acceptable() {
    let value = |ty: ElementaryType, counts: bool| match ty.name() {
        "BOOL" => "TRUE",
        "STRING" => "'3'",
        "WSTRING" => "\"3\"",
        "CHAR" => "'$03'",
        "WCHAR" => "\"$0003\"",
        "TIME" => "T#3ms",
        // Some dialects count nanoseconds of the long types.
        "LTIME" if counts => "LTIME#3ns",
        "LTOD" if counts => "LTOD#0:0:0.000000003",
        "LDT" if counts => "LDT#1970-01-01-00:00:00.000000003",
        "LTIME" => "LTIME#3ms",
        "DATE" => "D#1970-01-01",
        "LDATE" => "LDATE#1970-01-01",
        "TOD" => "TOD#0:0:0.003",
        "LTOD" => "LTOD#0:0:0.003",
        "DT" => "DT#1970-01-01-00:00:00.003",
        "LDT" => "LDT#1970-01-01-00:00:00.003",
        "REAL" | "LREAL" => "3.0",
        _ => "3",
    };
    let mut repaired = 0;
    for name in stickler_types::DialectName::ALL {
        let dialect = stickler_types::Dialect::of(name);
        let types = || ElementaryType::ALL.into_iter().filter(|&ty| dialect.has(ty));
        let counts = dialect.conversions.moment_units == MomentUnits::Counts;
        for (from, to) in types().flat_map(|from| types().map(move |to| (from, to))) {
            let text = format!(
                "PROGRAM main VAR CONSTANT d : {0} := {2}; n : {1} := d; END_VAR
                 VAR a : ARRAY[0..n] OF BOOL; hit : BOOL; END_VAR
                 CASE 3 OF n: hit := TRUE; END_CASE; END_PROGRAM",
                from.name(),
                to.name(),
                value(from, counts),
            );
            let Some(wrong) = diagnose(name, &text)
                .into_iter()
                .find(|one| one.suggestion.is_some() && to.is_integer())
            else {
                continue;
            };
            let mut fixed = text.clone();
            let span = wrong.span.start as usize..wrong.span.end as usize;
            fixed.replace_range(span, wrong.suggestion.as_deref().expect("a suggestion"));
            assert_eq!(diagnose(name, &fixed), [], "{name}: {fixed}");
            repaired += 1;
        }
    }
    assert!(repaired > 400, "only {repaired} were repaired");
}
