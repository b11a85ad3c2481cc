//! Test suites in the terms of JUnit, as quick-junit has them.

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};
use std::time::Duration;

/// One test suite, which knows the time of its tests.
pub(super) struct Suite {
    suite: TestSuite,
    time: Duration,
}

/// One test.
#[derive(Default)]
pub(super) struct Test<'a> {
    /// Its name within the suite.
    pub(super) name: &'a str,
    /// How long it took.
    pub(super) microseconds: u64,
    /// Why it did not simply pass.
    pub(super) problem: Option<Problem<'a>>,
    /// What it says beside that.
    pub(super) output: String,
    /// Numbers by which programs know more of it.
    pub(super) properties: Vec<(&'static str, u64)>,
}

/// Why a test did not simply pass.
pub(super) struct Problem<'a> {
    /// What JUnit calls it.
    pub(super) kind: Kind,
    /// What Stickler calls it.
    pub(super) type_name: &'a str,
    /// One line; line ends and tabs in it become spaces, as a reader of the attribute would have them.
    pub(super) message: String,
    /// All that is to be said.
    pub(super) text: String,
}

/// What JUnit calls a test that did not simply pass.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    /// It gave the wrong answer.
    Failure,
    /// It gave no answer.
    Error,
    /// It counts neither way.
    Skipped,
}

impl Suite {
    /// A test suite without tests.
    pub(super) fn new(name: &str) -> Suite {
        Suite {
            suite: TestSuite::new(name),
            time: Duration::ZERO,
        }
    }

    /// Adds a test.
    pub(super) fn add(&mut self, test: Test<'_>) {
        let time = Duration::from_micros(test.microseconds);
        let mut case = TestCase::new(
            test.name,
            test.problem.map_or_else(TestCaseStatus::success, status),
        );
        case.set_classname(self.suite.name.clone()).set_time(time);
        if !test.output.is_empty() {
            case.set_system_out(test.output);
        }
        for (name, number) in test.properties {
            case.add_property((name.to_owned(), number.to_string()));
        }
        self.time += time;
        self.suite.add_test_case(case);
    }

    /// The whole suite.
    pub(super) fn finish(mut self) -> TestSuite {
        self.suite.set_time(self.time);
        self.suite
    }
}

fn status(problem: Problem<'_>) -> TestCaseStatus {
    let mut status = match problem.kind {
        Kind::Failure => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Kind::Error => TestCaseStatus::non_success(NonSuccessKind::Error),
        Kind::Skipped => TestCaseStatus::skipped(),
    };
    status
        .set_type(problem.type_name)
        .set_message(problem.message.replace(['\n', '\t'], " "))
        .set_description(problem.text);
    status
}
