//! Several scans: variables stay, the environment writes, and values are observed in between.

use super::support::{DIALECT, attempt_scans, program, spelled};
use stickler_reference::RequestError;
use stickler_types::{Fault, Outcome};

const SOURCE: &str = "
TYPE COLOR : (RED, GREEN); END_TYPE
PROGRAM main
VAR n : INT := 10; in : BOOL; held : INT; s : STRING[3]; c : COLOR; d : DINT := 2; END_VAR
    n := n + 1;
    IF in THEN held := n; END_IF;
    d := 100 / (d - 1);
END_PROGRAM";

fn executed(scans: u32, observe: &[(&str, Option<u32>)], set: &[(u32, &str, &str)]) -> Vec<String> {
    let source = SOURCE.replace("d := 100 / (d - 1);", "");
    match attempt_scans(DIALECT, &source, scans, observe, set) {
        Ok(Outcome::Executed { values, .. }) => spelled(&values),
        other => panic!("not executed: {other:#?}"),
    }
}

#[test]
fn variables_keep_their_values_from_scan_to_scan() {
    let observed = executed(
        3,
        &[("n", None), ("n", Some(1)), ("n", Some(0)), ("n", Some(3))],
        &[],
    );
    assert_eq!(
        observed,
        ["n = INT#13", "n@1 = INT#11", "n@0 = INT#10", "n@3 = INT#13"]
    );
    assert_eq!(executed(0, &[("n", None)], &[]), ["n = INT#10"]);
}

#[test]
fn the_environment_writes_before_a_scan() {
    let set = [
        (3, "in", "BOOL#FALSE"),
        (2, "in", "BOOL#TRUE"),
        (1, "s", "STRING#'abcdef'"),
        (2, "c", "color#green"),
    ];
    let observed = executed(
        4,
        &[("held", None), ("s", None), ("c", Some(1)), ("c", Some(2))],
        &set,
    );
    assert_eq!(
        observed,
        [
            "held = INT#12",
            "s = STRING#'abc'",
            "c@1 = COLOR#RED",
            "c@2 = COLOR#GREEN"
        ]
    );
}

#[test]
fn a_fault_keeps_what_was_observed_before_it() {
    // d becomes 100, 1, and then the divisor is 0.
    let observe = [("n", None), ("n", Some(1)), ("n", Some(3)), ("d", Some(2))];
    match attempt_scans(DIALECT, SOURCE, 4, &observe, &[]) {
        Ok(Outcome::Faulted {
            fault, line, values, ..
        }) => {
            assert_eq!((fault, line), (Fault::DivisionByZero, Some(7)));
            assert_eq!(spelled(&values), ["n = INT#13", "n@1 = INT#11", "d@2 = DINT#1"]);
        }
        other => panic!("no fault: {other:#?}"),
    }
}

#[test]
fn the_step_limit_holds_for_all_scans_together() {
    let outcome = attempt_scans(DIALECT, &program("n : LINT;", "n := n + 1;"), u32::MAX, &[], &[]);
    assert!(
        matches!(
            outcome,
            Ok(Outcome::Faulted {
                fault: Fault::StepLimit,
                line: Some(5),
                ..
            })
        ),
        "{outcome:?}"
    );
}

#[test]
fn a_request_that_does_not_fit_the_program_is_an_error() {
    let attempt = |observe: &[_], set: &[_]| attempt_scans(DIALECT, SOURCE, 2, observe, set);
    let no_such_scan = |scan| {
        Err(RequestError::NoSuchScan {
            name: "n".to_owned(),
            scan,
        })
    };
    assert_eq!(attempt(&[("n", Some(3))], &[]), no_such_scan(3));
    assert_eq!(attempt(&[], &[(0, "n", "INT#5")]), no_such_scan(0));
    assert_eq!(attempt(&[], &[(3, "n", "INT#5")]), no_such_scan(3));
    for (name, literal) in [
        ("n", "DINT#5"),
        ("s", "INT#5"),
        ("n", "STRING#'5'"),
        ("c", "COLOR#BLUE"),
        ("c", "PAINT#RED"),
    ] {
        let outcome = attempt(&[], &[(1, name, literal)]);
        assert!(
            matches!(outcome, Err(RequestError::WrongType { .. })),
            "{name}, {literal}: {outcome:?}"
        );
    }
    assert!(matches!(
        attempt(&[], &[(1, "x", "INT#5")]),
        Err(RequestError::UnknownName { .. })
    ));
}
