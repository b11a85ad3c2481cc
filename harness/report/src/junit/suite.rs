//! JUnit's test suites and tests, built with quick-junit.

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};
use std::time::Duration;

/// Returns a test suite without tests.
pub(super) fn suite(name: &str) -> TestSuite {
    let mut suite = TestSuite::new(name);
    suite.set_time(Duration::ZERO);
    suite
}

/// Adds a test, which took so many microseconds, to a suite, which adds up the time of its tests.
pub(super) fn add(suite: &mut TestSuite, mut test: TestCase, microseconds: u64) {
    let time = Duration::from_micros(microseconds);
    test.set_classname(suite.name.clone()).set_time(time);
    suite.set_time(suite.time.unwrap_or_default() + time);
    suite.add_test_case(test);
}

/// Returns the status of a test that gave a wrong result.
pub(super) fn failure() -> TestCaseStatus {
    TestCaseStatus::non_success(NonSuccessKind::Failure)
}

/// Returns the status of a test that gave no result.
pub(super) fn error() -> TestCaseStatus {
    TestCaseStatus::non_success(NonSuccessKind::Error)
}

/// Describes a failure, an error or a skip: its kind in Stickler's terms, a message on one line, in which line ends and tabs become
/// spaces, as XML readers normalize the attribute, and the full text.
pub(super) fn problem(
    mut status: TestCaseStatus,
    type_name: &str,
    message: &str,
    text: &str,
) -> TestCaseStatus {
    status
        .set_type(type_name)
        .set_message(message.replace(['\n', '\t'], " "))
        .set_description(text);
    status
}
