//! JUnit's test suites and tests, built with quick-junit.

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};
use std::time::Duration;

/// A test suite, which adds up the time of its tests.
pub(super) struct JunitSuite {
    suite: TestSuite,
    time: Duration,
}

/// A test of a test suite.
#[derive(Default)]
pub(super) struct JunitTest<'a> {
    /// The name of the test within its suite.
    pub(super) name: &'a str,
    /// The duration of the test, in microseconds.
    pub(super) microseconds: u64,
    /// The failure, error or skip of the test; `None` where it passed.
    pub(super) problem: Option<Problem<'a>>,
    /// The output of the test, besides its problem.
    pub(super) output: String,
    /// Named numbers about the test, for programs.
    pub(super) properties: Vec<(&'static str, u64)>,
}

/// A failure, an error or a skip of a test.
pub(super) struct Problem<'a> {
    /// The kind of problem in JUnit's terms.
    pub(super) kind: TestResult,
    /// The kind of problem in Stickler's terms.
    pub(super) type_name: &'a str,
    /// The message, on one line; line ends and tabs in it become spaces, as XML readers normalize the attribute.
    pub(super) message: String,
    /// The full text of the problem.
    pub(super) text: String,
}

/// The JUnit kind of a test that did not simply pass.
#[derive(Clone, Copy)]
pub(super) enum TestResult {
    /// The test gave a wrong result.
    Failure,
    /// The test gave no result.
    Error,
    /// The test was skipped, and counts neither way.
    Skipped,
}

impl JunitSuite {
    /// Creates a test suite without tests.
    pub(super) fn new(name: &str) -> JunitSuite {
        JunitSuite {
            suite: TestSuite::new(name),
            time: Duration::ZERO,
        }
    }

    /// Adds a test.
    pub(super) fn add(&mut self, test: JunitTest<'_>) {
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

    /// Returns the quick-junit suite, with its total time.
    pub(super) fn finish(mut self) -> TestSuite {
        self.suite.set_time(self.time);
        self.suite
    }
}

fn status(problem: Problem<'_>) -> TestCaseStatus {
    let mut status = match problem.kind {
        TestResult::Failure => TestCaseStatus::non_success(NonSuccessKind::Failure),
        TestResult::Error => TestCaseStatus::non_success(NonSuccessKind::Error),
        TestResult::Skipped => TestCaseStatus::skipped(),
    };
    status
        .set_type(problem.type_name)
        .set_message(problem.message.replace(['\n', '\t'], " "))
        .set_description(problem.text);
    status
}
