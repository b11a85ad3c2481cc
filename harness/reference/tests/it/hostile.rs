//! Input that nobody would write: diagnostics, never a panic, a hang or memory without bound.

use stickler_reference::{Limits, RequestError, check, check_bytes, render, run};
use stickler_types::Dialect;
use stickler_types::{
    Code, Diagnostic, DialectName, Fault, Observation, Outcome, RunRequest, TextReading, Value,
};

const DIALECT: DialectName = DialectName::IRONPLC_ED3;

/// `PROGRAM main` around declarations and statements.
fn program(variables: &str, body: &str) -> String {
    format!("PROGRAM main\nVAR\n{variables}\nEND_VAR\n{body}\nEND_PROGRAM\n")
}

/// Runs a program for one scan, and observes a variable.
fn attempt(source: &str) -> Result<Outcome, RequestError> {
    let observe = [Observation::last("x", "")];
    run(
        &RunRequest::once(DIALECT, source, &observe),
        Limits { steps: 100_000 },
    )
}

fn code(diagnostic: &Diagnostic) -> Code {
    diagnostic.registered_code().expect("a code of the registry")
}

/// Everything that can be asked about a source text; gives its codes in the ordinary dialect.
fn codes(source: &str) -> Vec<Code> {
    for dialect in DialectName::ALL {
        let _ = (check(source, dialect), render(source, dialect));
    }
    let outcome = attempt(source);
    let found = check(source, DIALECT);
    assert!(
        found
            .iter()
            .all(|found| found.line > Some(0) && found.column > Some(0)),
        "{found:?}"
    );
    assert!(
        found.is_empty() || matches!(outcome, Ok(Outcome::Rejected { .. })),
        "{outcome:?}"
    );
    found.iter().map(code).collect()
}

#[test]
fn nesting_without_end_meets_a_limit() {
    let deep = 100_000;
    let parentheses = format!("x := {}1{};", "(".repeat(deep), ")".repeat(deep));
    assert_eq!(codes(&program("x : INT;", &parentheses)), [Code::LimitExceeded]);
    let branches = format!("{}{}", "IF TRUE THEN ".repeat(deep), "END_IF; ".repeat(deep));
    assert_eq!(codes(&program("x : INT;", &branches)), [Code::LimitExceeded]);
    for opened in [
        "(* ",
        "x := (",
        "IF TRUE THEN ",
        "x[",
        "F(a := ",
        "NOT ",
        "- ",
        "CASE x OF 1: ",
        "ARRAY[1..2] OF ",
    ] {
        assert!(
            !codes(&program("x : INT;", &opened.repeat(deep))).is_empty(),
            "{opened}"
        );
        assert!(!codes(&opened.repeat(deep)).is_empty(), "{opened}");
    }
}

#[test]
fn long_chains_are_no_nesting() {
    let sum = format!("x := 0{};", " + 1".repeat(100_000));
    let source = program("x : DINT;", &sum);
    match attempt(&source) {
        Ok(
            Outcome::Executed { .. }
            | Outcome::Faulted {
                fault: Fault::StepLimit,
                ..
            },
        ) => {}
        other => panic!("{other:?}"),
    }
    let elsifs = format!(
        "IF x = 1 THEN ; {} END_IF;",
        "ELSIF x = 2 THEN x := 3; ".repeat(20_000)
    );
    assert_eq!(codes(&program("x : DINT;", &elsifs)), []);
}

#[test]
fn numbers_and_names_of_any_length_are_read() {
    let digits = "9".repeat(1_000);
    assert_eq!(
        codes(&program("x : INT;", &format!("x := {digits};"))),
        [Code::ConstantOverflow]
    );
    assert!(!codes(&program(&format!("x : ARRAY[0..{}] OF INT;", 1_u128 << 127), ";")).is_empty());
    assert!(
        !codes(&program(
            "x : ARRAY[0..340282366920938463463374607431768211456] OF INT;",
            ";"
        ))
        .is_empty()
    );
    assert!(
        !codes(&program(
            "x : ARRAY[0..2000000000, 0..2000000000] OF ARRAY[0..9] OF LINT;",
            ";"
        ))
        .is_empty()
    );
    let name = "n".repeat(1_000_000);
    assert_eq!(
        codes(&program(
            &format!("{name} : INT; x : INT;"),
            &format!("x := {name};")
        )),
        []
    );
}

#[test]
fn bytes_of_all_kinds_are_diagnosed() {
    let all_bytes: Vec<u8> = (0..=255).cycle().take(5_000).collect();
    for bytes in [
        &all_bytes[..],
        b"\0\0\0",
        b"\xEF\xBB\xBF",
        b"\xFF\xFE",
        b"PROGRAM main\r\n\0END_PROGRAM",
        b"'",
        b"\"$",
        b"16#",
    ] {
        for dialect in DialectName::ALL {
            let (_, found) = check_bytes(bytes, dialect);
            assert_eq!(found.is_empty(), bytes == b"\xEF\xBB\xBF", "{bytes:?}: {found:?}");
        }
    }
    assert_eq!(
        codes("PROGRAM main\r\nVAR x : INT; END_VAR\r\nx := 1;\r\nEND_PROGRAM\r\n"),
        []
    );
}

#[test]
fn a_line_of_a_megabyte_has_its_columns() {
    let source = program("x : INT;", &format!("{}x := y;", "x := 1; ".repeat(128 << 10)));
    let found = check(&source, DIALECT);
    let places: Vec<_> = found
        .iter()
        .map(|one| (code(one), one.line, one.column))
        .collect();
    assert_eq!(places, [(Code::VariableUndefined, Some(5), Some((1 << 20) + 6))]);
}

#[test]
fn recursion_is_rejected_and_a_cycle_of_types_too() {
    let source = "FUNCTION F : INT F := G(); END_FUNCTION FUNCTION G : INT G := F(); END_FUNCTION";
    assert!(
        codes(source).contains(&Code::RecursiveCycle),
        "{:?}",
        codes(source)
    );
    assert!(!codes("TYPE A : STRUCT b : B; END_STRUCT; B : STRUCT a : A; END_STRUCT; END_TYPE").is_empty());
    assert!(!codes("FUNCTION_BLOCK F VAR f : F; END_VAR END_FUNCTION_BLOCK").is_empty());
}

#[test]
fn texts_that_grow_meet_the_step_limit() {
    let source = program(
        "x : INT; s : ARRAY[1..100000] OF STRING[60000]; t : STRING[60000] := 'abcdefgh'; i : DINT;",
        "WHILE LEN(t) < 30000 DO t := CONCAT(t, t); END_WHILE;
         FOR i := 1 TO 100000 DO s[i] := t; END_FOR;",
    );
    match attempt(&source) {
        Ok(
            Outcome::Faulted {
                fault: Fault::StepLimit,
                ..
            }
            | Outcome::Rejected { .. },
        ) => {}
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_longest_texts_are_converted_in_constants_and_as_the_program_runs() {
    let digits = format!("{}12", "0".repeat(65_533));
    let spoilt = format!("{}x", "9".repeat(65_534));
    let source = format!(
        "PROGRAM main
         VAR CONSTANT k : STRING[65535] := '{digits}'; END_VAR
         VAR s : STRING[65535] := '{digits}'; t : STRING[65535] := '{spoilt}'; w : WSTRING[65535];
             a : ARRAY[0..STRING_TO_INT('{digits}')] OF INT; i, j, n, c : INT; r : REAL; l : LREAL; d : TIME; hit : BOOL;
         END_VAR
             i := STRING_TO_INT(s); j := STRING_TO_INT(k); n := STRING_TO_INT(t); r := STRING_TO_REAL(s);
             l := STRING_TO_LREAL(t); d := STRING_TO_TIME(t); w := STRING_TO_WSTRING(s); c := WSTRING_TO_INT(w);
             CASE i OF STRING_TO_INT('{digits}'): hit := TRUE; END_CASE; a[12] := 1;
         END_PROGRAM"
    );
    let expected = [
        ("i", "INT#12"),
        ("j", "INT#12"),
        ("n", "INT#0"),
        ("c", "INT#12"),
        ("r", "REAL#12.0"),
        ("l", "LREAL#0.0"),
        ("d", "TIME#0ms"),
        ("hit", "BOOL#TRUE"),
        ("a[12]", "INT#1"),
    ];
    // Some read the number before the letter.
    let reads_whole_texts =
        |dialect: &DialectName| Dialect::of(*dialect).conversions.text_reading == TextReading::WholeText;
    for dialect in DialectName::ALL.into_iter().filter(reads_whole_texts) {
        let observe = expected.map(|(name, _)| Observation::last(name, ""));
        let outcome = run(&RunRequest::once(dialect, &source, &observe), Limits::default());
        let values = expected.map(|(name, value)| {
            let value = Value::parse(value).expect("a typed literal");
            (name.to_owned(), value)
        });
        let values = values.to_vec();
        assert!(outcome == Ok(Outcome::executed(values)), "{dialect}");
    }
}
