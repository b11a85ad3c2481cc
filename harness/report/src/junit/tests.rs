//! Tests the JUnit file.

use super::{Groups, Junit};
use crate::overview::Overview;
use crate::sample;
use quick_junit::{NonSuccessKind, Report, TestCaseStatus, TestSuite};
use std::fs;
use stickler_run::{CaseEvent, Event, Verdict};

fn document(cases: Vec<CaseEvent>) -> Report {
    document_of(&sample::run_of(cases))
}

fn document_of(events: &[Event]) -> Report {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("junit.xml");
    let mut junit = Junit::create(path.clone()).expect("a file");
    let mut overview = Overview::default();
    let mut groups = Groups::default();
    for event in events {
        let group = match event {
            Event::Case(case) => Some(groups.number(case).0),
            Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
        };
        junit.take(event, group);
        overview.take(event);
    }
    junit.finish(&overview, &groups).expect("written");
    let text = fs::read_to_string(path).expect("the document");
    Report::deserialize_from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The only suite of cases.
fn suite(report: &Report) -> &TestSuite {
    let [_claims, suite] = &report.test_suites[..] else {
        panic!("one suite: {report:?}")
    };
    suite
}

#[test]
fn what_a_baseline_says_is_told_and_what_of_it_is_out_of_date_fails() {
    let report = document_of(&sample::run_with_baseline());
    let [_claims, baselines, suite] = &report.test_suites[..] else {
        panic!("three suites: {report:?}")
    };
    assert_eq!((baselines.name.as_str(), baselines.failures), ("baselines", 1));
    assert_eq!((suite.failures, suite.skipped), (1, 1));
    let TestCaseStatus::Skipped { message, .. } = &suite.test_cases[1].status else {
        panic!("expected to fail: {suite:?}")
    };
    let message = message.as_ref().expect("a message").to_string();
    assert!(message.contains("(rounds)"), "{message}");
}

#[test]
fn a_claim_that_fails_only_as_its_baseline_expects_is_no_failure() {
    let known = || {
        vec![
            sample::case("a", Verdict::Xfail),
            sample::case("b", Verdict::Pass),
        ]
    };
    let report = document(known());
    assert_eq!((report.failures, report.skipped), (0, 2));
    let TestCaseStatus::Skipped { message, .. } = &report.test_suites[0].test_cases[0].status else {
        panic!("the claim: {report:?}")
    };
    assert_eq!(
        message.as_deref(),
        Some("1 of 2 cases fail, as the baseline expects")
    );
    let mut cases = known();
    cases.push(sample::case("c", Verdict::Crash));
    let report = document(cases);
    assert_eq!(report.test_suites[0].failures, 1, "one of them is new");
}

#[test]
fn each_verdict_has_its_element() {
    let report = document(
        Verdict::ALL
            .map(|verdict| sample::case(verdict.as_str(), verdict))
            .to_vec(),
    );
    let suite = suite(&report);
    assert_eq!(
        (suite.tests, suite.failures, suite.errors, suite.skipped),
        (9, 2, 3, 3)
    );
    for verdict in Verdict::ALL {
        let mut cases = suite.test_cases.iter();
        let id = format!("widening/{verdict}");
        let case = cases.find(|case| case.name.as_str() == id).expect("a test");
        let expected = match verdict {
            Verdict::Pass => None,
            Verdict::Fail | Verdict::Xpass => Some(NonSuccessKind::Failure),
            Verdict::Crash | Verdict::Timeout | Verdict::Error => Some(NonSuccessKind::Error),
            Verdict::Differs | Verdict::Xfail | Verdict::Unsupported => continue,
        };
        let kind = match &case.status {
            TestCaseStatus::NonSuccess { kind, .. } => Some(*kind),
            _ => None,
        };
        assert_eq!(kind, expected, "{verdict}");
    }
    // One suite more for the claims, in which the one claim fails.
    assert_eq!(
        (report.tests, report.failures, report.errors, report.skipped),
        (10, 3, 3, 3)
    );
}

#[test]
fn a_failure_says_all_that_is_needed_to_look_into_it() {
    let report = document(vec![sample::case("a", Verdict::Fail)]);
    let TestCaseStatus::NonSuccess {
        message, description, ..
    } = &suite(&report).test_cases[0].status
    else {
        panic!("a failure");
    };
    assert_eq!(message.as_deref(), Some("not as expected: SINT widens to INT"));
    let description = description.as_deref().expect("a description");
    for part in [
        "conformance-cases/widening/integer.toml:7\n",
        "expected: into = INT#-128\ngot: into = INT#128\n- into = INT#-128\n+ into = INT#128\n",
        "rerun: stickler run --filter 'widening/a@ironplc-ed2'",
    ] {
        assert!(description.contains(part), "{part} in {description}");
    }
}

#[test]
fn what_was_judged_by_line_is_compared_by_line() {
    let report = document_of(&sample::run_by_line());
    let TestCaseStatus::NonSuccess { description, .. } = &suite(&report).test_cases[0].status else {
        panic!("a failure");
    };
    let description = description.as_deref().expect("a description");
    assert!(description.contains(&sample::BY_LINE.join("\n")), "{description}");
}

#[test]
fn the_claims_come_first_and_a_suite_is_an_engine_a_dialect_and_an_area() {
    let other = CaseEvent {
        area: "conversion".to_owned(),
        ..sample::case("a", Verdict::Pass)
    };
    let report = document(vec![sample::case("b", Verdict::Pass), other]);
    let names: Vec<&str> = report
        .test_suites
        .iter()
        .map(|suite| suite.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "claims",
            "reference.ironplc-ed2.conversion",
            "reference.ironplc-ed2.widening"
        ]
    );
    let claim = &report.test_suites[0].test_cases[0];
    assert_eq!(claim.name.as_str(), "ironplc-type-conversions: Integer widening");
    assert_eq!(
        claim.system_out.as_deref(),
        Some("passed 2, failed 0, open 0, unsupported 0")
    );
}

#[test]
fn a_broken_case_file_is_an_error() {
    let mut events = sample::run_of(vec![sample::case("a", Verdict::Pass)]);
    sample::header(&mut events).broken_files = vec!["a.st:1: `colour`: unknown key".to_owned()];
    let report = document_of(&events);
    assert_eq!((report.tests, report.errors), (3, 1));
    assert_eq!(
        report.test_suites[1].test_cases[0].name.as_str(),
        "a.st:1: `colour`: unknown key"
    );
}

#[test]
fn the_cases_of_a_probe_that_passed_are_one_test_that_counts_them() {
    let case = |id: &str, verdict| sample::case(id, verdict);
    let report = document(vec![
        case("a::p(1)", Verdict::Pass),
        sample::open_case("a::p(2)"),
        case("a::p(3)", Verdict::Fail),
        case("a::p(4)", Verdict::Unsupported),
        case("a::p(5)", Verdict::Unsupported),
    ]);
    let suite = suite(&report);
    assert_eq!((suite.tests, suite.failures, suite.skipped), (3, 1, 1));
    let names: Vec<&str> = suite.test_cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(names, ["widening/a::p(3)", "widening/a::p", "widening/a::p"]);
    let properties = |test: usize| {
        let properties = suite.test_cases[test].properties.iter();
        let texts =
            properties.map(|property| format!("{}={}", property.name.as_str(), property.value.as_str()));
        texts.collect::<Vec<_>>()
    };
    assert_eq!(properties(1), ["cases=2", "observations=1"]);
    assert_eq!(properties(2), ["cases=2"]);
    let TestCaseStatus::Skipped { message, .. } = &suite.test_cases[2].status else {
        panic!("not supported: {suite:?}")
    };
    let message = message.as_deref().unwrap_or_default();
    assert!(message.contains("does not support it (2 cases)"), "{message}");
}

#[test]
fn whatever_an_engine_says_the_document_can_be_read() {
    let case = CaseEvent {
        got: vec![sample::rendered(&["\u{0}\u{1b}[31m\u{ffff}]]><&\"'\u{7f}"])],
        title: "a\n\"b\"\t<c>".to_owned(),
        ..sample::case("a", Verdict::Fail)
    };
    let report = document(vec![case]);
    let TestCaseStatus::NonSuccess {
        message, description, ..
    } = &suite(&report).test_cases[0].status
    else {
        panic!("a failure");
    };
    assert_eq!(message.as_deref(), Some("not as expected: a \"b\" <c>"));
    assert!(
        description
            .as_deref()
            .is_some_and(|text| text.contains("]]><&\"'")),
        "{description:?}"
    );
}
