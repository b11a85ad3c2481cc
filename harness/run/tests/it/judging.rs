//! Tests of judging outcomes by expectations.

use crate::fixtures::{Puppet, executed, expecting, fault, named, rejected, rejection, values};
use std::sync::Arc;
use stickler_engines::{Engine, Identity, Outcome};
use stickler_run::{Answers, Fact, Grade, Judgement, Observed, Plan, Verdict, judge};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedDiagnostic};
use stickler_types::{Code, Diagnostic, Fault, Observation, Severity};

fn judged(expectation: Expectation, run: Outcome) -> Judgement {
    judge(&expecting(expectation), &Answers::of_run(run), Grade::Code)
}

/// Returns the verdict, and the text of the actual facts.
fn verdict(expectation: Expectation, run: Outcome) -> (Verdict, String) {
    let judgement = judged(expectation, run);
    (judgement.verdict, Fact::text(&judgement.got))
}

fn faulted(fault: Fault, line: Option<u32>, values: &[&str]) -> Outcome {
    Outcome::Faulted {
        fault,
        line,
        values: named(values),
        warnings: Vec::new(),
    }
}

fn open() -> Expectation {
    Expectation {
        accepted: Acceptance::Observed,
        ..Expectation::default()
    }
}

#[test]
fn a_pass_says_the_same_in_expected_and_got() {
    for (expectation, run) in [
        (Expectation::default(), executed(&[])),
        (Expectation::default(), Outcome::ACCEPTED),
        (
            values(&["x = INT#1", "a = REAL#0.5"]),
            executed(&["x = INT#1", "a = REAL#0.5"]),
        ),
        (
            rejection(&["9 P4035", "6 P4022"]),
            rejected(&["6 P4022", "9 P4035"]),
        ),
        (
            fault("9 division-by-zero"),
            faulted(Fault::DivisionByZero, Some(9), &[]),
        ),
    ] {
        let judgement = judged(expectation, run);
        assert_eq!(judgement.verdict, Verdict::Pass, "{judgement:?}");
        assert_eq!(judgement.expected, judgement.got);
        assert!(!judgement.expected.is_empty());
    }
}

#[test]
fn an_accepted_program_that_is_rejected_fails_and_shows_why() {
    let (verdict, got) = verdict(values(&["x = INT#1"]), rejected(&["6 P4035", "7 -", "- P9999"]));
    assert_eq!(verdict, Verdict::Fail);
    let lines = [
        "somewhere: error P9999: told",
        "line 6: error P4035: told",
        "line 7: error without a code: told",
    ];
    assert_eq!(got.lines().collect::<Vec<_>>(), lines);
}

#[test]
fn a_rejected_program_that_is_accepted_fails() {
    for run in [Outcome::ACCEPTED, executed(&[])] {
        assert_eq!(
            verdict(rejection(&["6 P4035"]), run),
            (Verdict::Fail, "accepted".to_owned())
        );
    }
    let run = faulted(Fault::StepLimit, Some(3), &[]);
    assert_eq!(
        verdict(rejection(&["6 P4035"]), run),
        (Verdict::Fail, "line 3: fault step-limit".to_owned())
    );
}

#[test]
fn values_are_compared_exactly_and_each_is_shown() {
    let expected = || values(&["x = INT#1", "y = INT#2"]);
    let (first, got) = verdict(expected(), executed(&["x = INT#1", "y = INT#3", "z = INT#4"]));
    assert_eq!((first, got.as_str()), (Verdict::Fail, "x = INT#1\ny = INT#3"));
    let (second, got) = verdict(expected(), executed(&["x = INT#1"]));
    assert_eq!((second, got.as_str()), (Verdict::Fail, "x = INT#1\ny is missing"));
}

#[test]
fn a_fault_must_be_of_the_kind_and_on_the_line() {
    let expected = || fault("9 division-by-zero");
    assert_eq!(
        verdict(expected(), faulted(Fault::SubscriptRange, Some(9), &[])).0,
        Verdict::Fail
    );
    assert_eq!(
        verdict(expected(), faulted(Fault::DivisionByZero, Some(8), &[])).0,
        Verdict::Fail
    );
    assert_eq!(
        verdict(expected(), executed(&[])),
        (Verdict::Fail, "accepted".to_owned())
    );
    assert_eq!(verdict(expected(), rejected(&["9 P4039"])).0, Verdict::Fail);
    assert_eq!(
        verdict(Expectation::default(), faulted(Fault::Subrange, Some(1), &[])).0,
        Verdict::Fail
    );
}

#[test]
fn values_before_a_fault_are_judged_too() {
    let expected = || Expectation {
        fault: fault("9 subrange").fault,
        ..values(&["x = INT#1"])
    };
    let right = judged(expected(), faulted(Fault::Subrange, Some(9), &["x = INT#1"]));
    assert_eq!(
        (right.verdict, Fact::text(&right.expected).as_str()),
        (Verdict::Pass, "line 9: fault subrange\nx = INT#1")
    );
    assert_eq!(
        verdict(expected(), faulted(Fault::Subrange, Some(9), &["x = INT#2"])).0,
        Verdict::Fail
    );
}

#[test]
fn a_worse_grade_passes_only_where_it_is_asked_for() {
    let graded = |expectation: Expectation, run: Outcome, strict: Grade| {
        let judgement = judge(&expecting(expectation), &Answers::of_run(run), strict);
        (judgement.grade, judgement.verdict)
    };
    for (run, grade) in [
        (rejected(&["6 P4035"]), Grade::Code),
        (rejected(&["6 E037"]), Grade::Line),
        (rejected(&["- E037"]), Grade::Rejected),
    ] {
        for strict in [Grade::Code, Grade::Line, Grade::Rejected] {
            let verdict = if grade <= strict {
                Verdict::Pass
            } else {
                Verdict::Fail
            };
            assert_eq!(
                graded(rejection(&["6 P4035"]), run.clone(), strict),
                (Some(grade), verdict)
            );
        }
    }
    let unplaced = faulted(Fault::StepLimit, None, &[]);
    let graded_fault = |strict| graded(fault("4 step-limit"), unplaced.clone(), strict);
    assert_eq!(
        graded_fault(Grade::Rejected),
        (Some(Grade::Rejected), Verdict::Pass)
    );
    assert_eq!(graded_fault(Grade::Line), (Some(Grade::Rejected), Verdict::Fail));
}

#[test]
fn a_code_that_the_engine_does_not_have_is_not_asked_for_and_its_line_is() {
    let engine = |lacks: &[Code]| Identity {
        lacks: lacks.to_vec(),
        ..Puppet::new("ironplc", |_| Outcome::ACCEPTED).identity().clone()
    };
    let case = expecting(rejection(&["6 P4049", "7 P4035"]));
    let verdict = |lacks: &[Code], places: &[&str]| {
        let needed = Plan::default().needed(&engine(lacks), &case);
        judge(&case, &Answers::of_run(rejected(places)), needed).verdict
    };
    let lacked = [Code::OperatorOperandTypeMismatch];
    assert_eq!(verdict(&lacked, &["6 P4035", "7 P4035"]), Verdict::Pass);
    assert_eq!(verdict(&[], &["6 P4035", "7 P4035"]), Verdict::Fail);
    assert_eq!(verdict(&lacked, &["5 P4035", "7 P4035"]), Verdict::Fail);
    let other = [Code::NotImplemented];
    assert_eq!(verdict(&other, &["6 P4035", "7 P4035"]), Verdict::Fail);
}

#[test]
fn a_diagnostic_on_a_clean_line_fails_at_every_grade() {
    let expectation = Expectation {
        clean_lines: vec![4, 7],
        ..rejection(&["6 P4035"])
    };
    let run = Answers::of_run(rejected(&["6 P4035", "7 P4035"]));
    let judgement = judge(&expecting(expectation.clone()), &run, Grade::Rejected);
    assert_eq!(judgement.verdict, Verdict::Fail);
    let run = Answers::of_run(rejected(&["6 P4035", "8 P4035"]));
    assert_eq!(
        judge(&expecting(expectation), &run, Grade::Rejected).verdict,
        Verdict::Pass
    );
}

fn warned(lines: &[(u32, &str)]) -> Outcome {
    let warning = |&(line, code): &(u32, &str)| Diagnostic {
        severity: Severity::Warning,
        code: Some(code.to_owned()),
        line: Some(line),
        message: "told".to_owned(),
        ..Diagnostic::default()
    };
    executed(&[]).with_warnings(lines.iter().map(warning).collect())
}

fn warning(line: u32) -> Expectation {
    let code = Code::SignedToUnsigned;
    Expectation {
        warnings: vec![ExpectedDiagnostic { line, code }],
        ..Expectation::default()
    }
}

#[test]
fn an_expected_warning_must_come_and_others_may() {
    let judgement = judged(warning(6), warned(&[(6, "C0195"), (9, "C0197")]));
    assert_eq!(judgement.verdict, Verdict::Pass);
    assert_eq!(judgement.expected, judgement.got);
    assert_eq!(Fact::text(&judgement.got), "accepted\nline 6: warning C0195");
    for (given, reported) in [
        (&[][..], "accepted"),
        (&[(7, "C0195")], "accepted\nline 7: warning C0195: told"),
        (&[(6, "C0196")], "accepted\nline 6: warning C0196: told"),
    ] {
        assert_eq!(
            verdict(warning(6), warned(given)),
            (Verdict::Fail, reported.to_owned())
        );
    }
    let by_line = |given| {
        let answers = Answers::of_run(warned(given));
        judge(&expecting(warning(6)), &answers, Grade::Line).verdict
    };
    assert_eq!(by_line(&[(6, "E067")]), Verdict::Pass);
    assert_eq!(by_line(&[(7, "C0195")]), Verdict::Fail);
}

#[test]
fn a_warning_fails_a_case_only_on_a_clean_line() {
    let clean = || Expectation {
        clean_lines: vec![6],
        ..Expectation::default()
    };
    assert_eq!(verdict(clean(), warned(&[(7, "C0195")])).0, Verdict::Pass);
    let reported = "accepted\nline 6: warning C0195: told".to_owned();
    assert_eq!(
        verdict(clean(), warned(&[(6, "C0195")])),
        (Verdict::Fail, reported)
    );
    assert_eq!(
        verdict(Expectation::default(), warned(&[(6, "C0195")])).0,
        Verdict::Pass
    );
}

#[test]
fn open_acceptance_is_recorded_and_never_failed() {
    let recorded = |run: Outcome| {
        let judgement = judged(open(), run);
        assert_eq!(
            (judgement.verdict, Fact::text(&judgement.expected).as_str()),
            (Verdict::Pass, "accepted or rejected")
        );
        judgement
            .observations
            .into_iter()
            .map(|o| format!("{}={}", o.name, o.value))
            .collect::<Vec<_>>()
    };
    assert_eq!(recorded(executed(&[])), ["acceptance=accepted"]);
    assert_eq!(recorded(Outcome::ACCEPTED), ["acceptance=accepted"]);
    assert_eq!(recorded(rejected(&["6 P4035"])), ["acceptance=rejected"]);
    let fault = recorded(faulted(Fault::Subrange, None, &[]));
    assert_eq!(fault, ["acceptance=accepted", "fault=subrange"]);
}

#[test]
fn where_acceptance_is_open_values_hold_if_it_is_accepted() {
    let expected = || Expectation {
        accepted: Acceptance::Observed,
        ..values(&["x = INT#1"])
    };
    assert_eq!(verdict(expected(), rejected(&["6 P4035"])).0, Verdict::Pass);
    assert_eq!(verdict(expected(), executed(&["x = INT#1"])).0, Verdict::Pass);
    assert_eq!(verdict(expected(), executed(&["x = INT#2"])).0, Verdict::Fail);
}

#[test]
fn what_is_observed_and_not_asserted_is_recorded() {
    let observe = |name: &str, after| Observation {
        after,
        ..Observation::last(name, "INT")
    };
    let mut case: Case = expecting(values(&["x = INT#1"]));
    case.observe = Arc::new([
        observe("x", None),
        observe("x", Some(2)),
        observe("y", None),
        observe("z", None),
    ]);
    let run = executed(&["x = INT#1", "x@2 = INT#5", "y = INT#6"]);
    let judgement = judge(&case, &Answers::of_run(run), Grade::Code);
    assert_eq!(judgement.verdict, Verdict::Pass);
    let observed = |name: &str, value: &str| Observed {
        name: name.into(),
        value: value.into(),
    };
    assert_eq!(
        judgement.observations,
        [observed("x@2", "INT#5"), observed("y", "INT#6")]
    );
}

#[test]
fn an_engine_that_only_checks_is_unsupported_where_values_are_asserted() {
    let (checked, got) = verdict(values(&["x = INT#1"]), Outcome::ACCEPTED);
    assert_eq!(
        (checked, got.as_str()),
        (Verdict::Unsupported, "accepted, and not executed")
    );
    assert_eq!(
        verdict(fault("9 subrange"), Outcome::ACCEPTED).0,
        Verdict::Unsupported
    );
}

#[test]
fn crash_timeout_unsupported_and_nonsense_have_verdicts_of_their_own() {
    let text = || "why".to_owned();
    for (run, verdict, got) in [
        (
            Outcome::Crashed { reason: text() },
            Verdict::Crash,
            "crashed: why",
        ),
        (
            Outcome::TimedOut { after_ms: 5 },
            Verdict::Timeout,
            "no answer within 5 ms",
        ),
        (
            Outcome::Unsupported { reason: text() },
            Verdict::Unsupported,
            "unsupported: why",
        ),
        (
            Outcome::NotImplemented { reason: text() },
            Verdict::Unsupported,
            "not implemented: why",
        ),
        (Outcome::Error { message: text() }, Verdict::Error, "error: why"),
        (
            Outcome::Rendered { text: text() },
            Verdict::Error,
            "error: answered `run` with rendered text",
        ),
    ] {
        for expectation in [Expectation::default(), rejection(&["6 P4035"]), open()] {
            let judgement = judged(expectation, run.clone());
            assert_eq!(
                (judgement.verdict, Fact::text(&judgement.got).as_str()),
                (verdict, got)
            );
            assert_eq!((judgement.grade, judgement.observations.len()), (None, 0));
        }
    }
}

#[test]
fn a_case_is_open_that_records_and_asserts_nothing_but_acceptance() {
    let observing = |expectation: Expectation| Case {
        observe: Arc::new([Observation::last("x", "INT")]),
        ..expecting(expectation)
    };
    assert!(observing(Expectation::default()).is_open());
    assert!(expecting(open()).is_open(), "acceptance itself is recorded");
    assert!(
        !expecting(Expectation::default()).is_open(),
        "acceptance is asserted"
    );
    let clean = Expectation {
        clean_lines: vec![4],
        ..Expectation::default()
    };
    for asserting in [
        values(&["x = INT#1"]),
        rejection(&["9 P4035"]),
        fault("9 division-by-zero"),
        clean,
    ] {
        assert!(!observing(asserting).is_open());
    }
}
