//! Requests that no program answers, and what is asked about a text besides its diagnostics.

use stickler_reference::{Limits, RequestError, check_bytes, render, run};
use stickler_types::{
    Code, Diagnostic, DialectName, Fault, Observation, Outcome, RunRequest, Setting, Value,
};

const ED3: DialectName = DialectName::IRONPLC_ED3;

const PROGRAM: &str = include_str!("requested.st");

fn attempt(
    source: &str,
    scans: u32,
    observe: &[Observation],
    set: &[Setting],
) -> Result<Outcome, RequestError> {
    let request = RunRequest {
        scans,
        set,
        ..RunRequest::once(ED3, source, observe)
    };
    run(&request, Limits { steps: 100_000 })
}

/// Sets a variable before a scan of a program with two.
fn attempt_to_set(before: u32, name: &str, literal: &str) -> Result<Outcome, RequestError> {
    let value = Value::parse(literal).expect("a typed literal");
    let name = name.into();
    attempt(PROGRAM, 2, &[], &[Setting { before, name, value }])
}

#[track_caller]
fn assert_unknown(outcome: &Result<Outcome, RequestError>) {
    let is_unknown = matches!(outcome, Err(RequestError::UnknownName { .. }));
    assert!(is_unknown, "{outcome:?}");
}

#[test]
fn a_name_that_no_variable_has_is_an_error() {
    let observed = |name: &str| attempt(PROGRAM, 1, &[Observation::last(name, "")], &[]);
    for name in ["small", "a", "a[3]", "a[1].x", "n.3", "", "a[", "n[1]"] {
        assert_unknown(&observed(name));
    }
    assert!(observed("N").is_ok() && observed("A[2]").is_ok());
}

#[test]
fn a_request_that_does_not_fit_the_program_is_an_error() {
    let no_scan = |scan| {
        Err(RequestError::NoSuchScan {
            name: "n".to_owned(),
            scan,
        })
    };
    let third = Observation {
        after: Some(3),
        ..Observation::last("n", "")
    };
    assert_eq!(attempt(PROGRAM, 2, &[third], &[]), no_scan(3));
    assert_eq!(attempt_to_set(0, "n", "INT#5"), no_scan(0));
    assert_eq!(attempt_to_set(3, "n", "INT#5"), no_scan(3));
    let misfits = "n := DINT#5, s := INT#5, n := STRING#'5', c := COLOR#BLUE, c := PAINT#RED";
    for setting in misfits.split(", ") {
        let (name, literal) = setting.split_once(" := ").expect("a setting");
        let outcome = attempt_to_set(1, name, literal);
        assert!(
            matches!(outcome, Err(RequestError::WrongType { .. })),
            "{name}, {literal}: {outcome:?}"
        );
    }
    assert_unknown(&attempt_to_set(1, "x", "INT#5"));
}

#[test]
fn the_step_limit_holds_for_all_scans_together() {
    let outcome = attempt(PROGRAM, u32::MAX, &[], &[]);
    let Ok(Outcome::Faulted { fault, line, .. }) = outcome else {
        panic!("{outcome:?}")
    };
    assert_eq!((fault, line), (Fault::StepLimit, Some(4)));
}

fn code_and_line(diagnostic: &Diagnostic) -> (Option<Code>, Option<u32>) {
    (diagnostic.registered_code(), diagnostic.line)
}

#[test]
fn a_text_without_a_program_is_acceptable_and_cannot_be_run() {
    let source = "FUNCTION F : INT\n    F := 1;\nEND_FUNCTION\n\n(* the end *)\n";
    assert_eq!(stickler_reference::check(source, ED3), []);
    let outcome = attempt(source, 1, &[], &[]);
    let Ok(Outcome::Rejected { diagnostics }) = outcome else {
        panic!("{outcome:?}")
    };
    let places: Vec<_> = diagnostics.iter().map(code_and_line).collect();
    assert_eq!(places, [(Some(Code::NoProgramDeclaration), Some(3))]);
}

#[test]
fn bytes_that_are_no_text_are_diagnosed() {
    let bytes = b"\xEF\xBB\xBFPROGRAM main\nVAR b\xFFd : INT; END_VAR\nEND_PROGRAM";
    let (text, found) = check_bytes(bytes, ED3);
    assert!(text.starts_with("PROGRAM main"));
    assert_eq!(
        found.first().map(code_and_line),
        Some((Some(Code::UnexpectedToken), Some(2)))
    );
}

#[test]
fn rendering_is_stable_and_refuses_what_cannot_be_read() {
    let source =
        "PROGRAM main VAR b : ARRAY[1..2] OF BYTE; r : BOOL; END_VAR r := b[ 1 ].%X3; (* gone *) END_PROGRAM";
    let rendered = render(source, ED3).expect("it can be read");
    assert!(rendered.contains("r := b[1].3;"), "{rendered}");
    assert_eq!(render(&rendered, ED3).as_ref(), Ok(&rendered));
    let refused = render(source, DialectName::IRONPLC_ED2).expect_err("the form is not enabled");
    let codes: Vec<_> = refused.iter().filter_map(Diagnostic::registered_code).collect();
    assert_eq!(codes, [Code::PartialAccessSyntaxDisabled]);
    assert!(render("PROGRAM main x := ; END_PROGRAM", ED3).is_err());
}
