//! Tests of `symptom.rs`.

use super::Symptom;
use crate::{Fact, Grade, Verdict};
use stickler_types::{Diagnostic, Fault, Value};

fn value(name: &str, literal: &str) -> Fact {
    Fact::Value {
        name: name.to_owned(),
        value: Value::parse(literal).expect("a typed literal"),
    }
}

fn error(line: u32, code: &str) -> Fact {
    reported(line, code, "")
}

/// Returns a diagnostic; line 0 stands for none, and so does an empty code.
fn reported(line: u32, code: &str, message: &str) -> Fact {
    Fact::Diagnostic(Diagnostic {
        line: (line > 0).then_some(line),
        code: (!code.is_empty()).then(|| code.to_owned()),
        message: message.to_owned(),
        ..Diagnostic::default()
    })
}

fn rendered(line: &str) -> Fact {
    Fact::Rendered {
        lines: vec![line.to_owned()],
    }
}

fn symptom(expected: &[Fact], got: &[Fact], strict: Grade) -> Symptom {
    Symptom::of_facts(Verdict::Fail, (expected, got), strict)
}

/// Checks the words of the symptoms for these actual facts, where `expected` is expected.
fn are<const N: usize>(expected: &[Fact], rows: [(&[Fact], &str); N]) {
    for (got, word) in rows {
        assert_eq!(
            symptom(expected, got, Grade::Code).word(),
            word,
            "{expected:?} / {got:?}"
        );
    }
}

#[test]
fn what_must_be_rejected_is_accepted_or_rejected_wrongly() {
    let error_in_6 = || error(6, "P4025");
    are(
        &[error_in_6()],
        [
            (&[Fact::Accepted], "not-rejected-P4025"),
            (&[reported(1, "P4025", "out of range")], "line-of-P4025"),
            (&[reported(0, "P4025", "out of range")], "no-place-of-P4025"),
            (&[reported(9, "P0002", "m")], "not-P4025"),
            (&[error_in_6(), reported(9, "P0002", "m")], "surplus-P0002"),
            (&[error_in_6(), reported(6, "P4025", "m")], "surplus-P4025"),
        ],
    );
    are(&[Fact::Rejected], [(&[Fact::Accepted], "not-rejected")]);
    are(
        &[Fact::AcceptedOrRejected],
        [(&[reported(6, "P4026", "m")], "surplus-P4026")],
    );
    are(
        &[error(6, "P4033"), error(7, "P4033")],
        [
            (&[reported(6, "P0002", "m"), error(7, "P4033")], "not-P4033"),
            (&[error(6, "P4033")], "incomplete-P4033"),
            (&[reported(9, "P4033", "m")], "line-of-P4033"),
            (
                &[error(6, "P4033"), reported(9, "P0002", "m")],
                "incomplete-P4033",
            ),
            (&[Fact::RejectedSilently], "incomplete-P4033"),
        ],
    );
}

#[test]
fn a_mistake_that_is_told_without_its_place_hides_no_other() {
    are(
        &[error(5, "P0003"), error(6, "P4025")],
        [
            (&[reported(0, "P4025", "m")], "incomplete-P0003"),
            (&[reported(0, "P4026", "m")], "not-P0003"),
        ],
    );
}

#[test]
fn what_must_be_accepted_is_rejected_for_a_reason() {
    for expected in [value("r", "INT#5"), Fact::Accepted] {
        are(
            &[expected],
            [
                (&[reported(3, "P4018", "wrong number")], "rejected-P4018"),
                (&[reported(3, "", "no `r` here (at 7)")], "rejected-no here"),
                (&[reported(0, "", "don't know 'r'")], "rejected-don't know"),
                (
                    &[reported(0, "", "unexpected character at 71")],
                    "rejected-unexpected character at",
                ),
                (&[reported(0, "P0002", "Syntax error")], "rejected-P0002"),
                (&[Fact::RejectedSilently], "rejected"),
            ],
        );
    }
    let silent = symptom(&[Fact::Accepted], &[Fact::RejectedSilently], Grade::Code);
    assert_eq!(silent.to_string(), "it rejects what must be accepted");
}

#[test]
fn what_is_computed_is_another_value_or_none() {
    let name = || "r".to_owned();
    are(
        &[value("r", "INT#5"), value("q", "INT#1")],
        [
            (&[value("r", "INT#6"), value("q", "INT#1")], "value"),
            (&[Fact::OtherValue { name: name() }, value("q", "INT#1")], "value"),
            (&[Fact::MissingValue { name: name() }], "missing"),
        ],
    );
    are(&[rendered("a := b;")], [(&[rendered("a:=b;")], "text")]);
}

#[test]
fn a_program_stops_otherwise_than_it_must() {
    let stops = |fault, line| Fact::Fault { fault, line };
    let silent = || stops(Fault::Subrange, None);
    let missing = || Fact::MissingValue { name: "r".to_owned() };
    let wanted = [stops(Fault::Subrange, Some(16)), value("r", "INT#7")];
    are(
        &wanted,
        [
            (&[Fact::Accepted, value("r", "INT#0")], "not-faulted-subrange"),
            (
                &[stops(Fault::StepLimit, Some(16)), value("r", "INT#7")],
                "fault-step-limit",
            ),
            (&[silent(), missing()], "line-of-subrange"),
            (&[silent(), value("r", "INT#0")], "value"),
        ],
    );
    are(
        &wanted[1..],
        [(
            &[stops(Fault::StepLimit, Some(5)), value("r", "INT#0")],
            "fault-step-limit",
        )],
    );
    let missing = symptom(&wanted, &[silent(), missing()], Grade::Rejected);
    assert_eq!(missing, Symptom::Missing, "the line does not count");
}

#[test]
fn what_is_not_compared_is_no_symptom() {
    let of = |got: &[Fact], strict| {
        let expected = [error(6, "P4049"), error(7, "P4049")];
        symptom(&expected, got, strict).word()
    };
    let found = reported(6, "", "no number");
    assert_eq!(of(std::slice::from_ref(&found), Grade::Line), "incomplete-P4049");
    let elsewhere = reported(9, "", "no sum");
    assert_eq!(of(std::slice::from_ref(&elsewhere), Grade::Line), "line-of-P4049");
    let more = [found, reported(7, "", "m"), elsewhere];
    assert_eq!(of(&more, Grade::Line), "surplus-no sum");
    assert_eq!(of(&more[2..], Grade::Rejected), "surplus-no sum");
    assert_eq!(of(&[Fact::Accepted], Grade::Rejected), "not-rejected-P4049");
}

#[test]
fn crashes_are_told_apart_by_their_words_and_not_by_their_numbers() {
    let crash = |reason: &str| {
        let crashed = Fact::Crashed {
            reason: reason.to_owned(),
        };
        Symptom::of_facts(Verdict::Crash, (&[Fact::Accepted], &[crashed]), Grade::Code)
    };
    assert_eq!(crash("signal 11 in stage 3"), crash("signal 6 in stage 4"));
    let ended = |words: &str| crash(&format!("it ended (exit status: 3); its last words: {words}"));
    assert_ne!(ended("stack overflow"), ended("the pool isn't there"));
    assert_eq!(
        ended("Error: V9009 - the pool isn't there (task 0)").to_string(),
        "it dies (it ended; its last words: Error: - the pool isn't there)"
    );
}

#[test]
fn a_diagnostic_that_has_lost_its_place_is_told_from_one_at_a_wrong_place() {
    let at = |line, column| {
        Fact::Diagnostic(Diagnostic {
            line: Some(line),
            column: Some(column),
            code: Some("P4025".to_owned()),
            ..Diagnostic::default()
        })
    };
    let of = |got: Fact, strict| symptom(&[error(6, "P4025")], &[got], strict).word();
    assert_eq!(of(at(1, 1), Grade::Code), "no-place-of-P4025");
    assert_eq!(of(at(1, 2), Grade::Code), "line-of-P4025");
    assert_eq!(
        of(reported(0, "", "no sum at 7"), Grade::Line),
        "no-place-of-no sum at"
    );
    assert_eq!(of(reported(2, "", "no sum"), Grade::Line), "line-of-P4025");
}
