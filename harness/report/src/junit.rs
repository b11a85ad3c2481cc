//! `junit.xml`: the run for continuous integration, one test suite an engine, dialect and area.

use crate::pending::PendingFile;
use crate::{ReportError, diff};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;
use stickler_run::{CaseEvent, Event, Verdict};

/// Gathers the run.
pub(crate) struct Junit {
    file: PendingFile,
    suites: BTreeMap<String, Suite>,
    duration: Option<Duration>,
}

struct Suite {
    suite: TestSuite,
    time: Duration,
}

impl Junit {
    /// Makes the file.
    ///
    /// # Errors
    /// [`ReportError::Write`] where it cannot be made.
    pub(crate) fn create(path: PathBuf) -> Result<Junit, ReportError> {
        Ok(Junit {
            file: PendingFile::create(path)?,
            suites: BTreeMap::new(),
            duration: None,
        })
    }

    /// Adds one event.
    pub(crate) fn take(&mut self, event: &Event) {
        match event {
            // JUnit has no place for what a run sets out to do.
            Event::Header(_) => {}
            Event::Case(case) => self.take_case(case),
            Event::Footer(footer) => self.duration = Some(Duration::from_millis(footer.duration_ms)),
        }
    }

    fn take_case(&mut self, case: &CaseEvent) {
        let name = format!("{}.{}.{}", case.engine, case.dialect, case.area);
        let time = Duration::from_micros(case.duration_us);
        let test = test_case(case, &name, time);
        let suite = self.suites.entry(name).or_insert_with_key(|name| Suite {
            suite: TestSuite::new(name),
            time: Duration::ZERO,
        });
        suite.time += time;
        suite.suite.add_test_case(test);
    }

    /// Writes the document; a run that was cut short has none.
    ///
    /// # Errors
    /// [`ReportError`] where it cannot be written.
    pub(crate) fn finish(mut self) -> Result<(), ReportError> {
        let Some(duration) = self.duration else {
            return Ok(());
        };
        let mut report = Report::new("stickler");
        report.set_time(duration);
        for Suite { mut suite, time } in self.suites.into_values() {
            suite.set_time(time);
            report.add_test_suite(suite);
        }
        report
            .serialize(&mut self.file)
            .map_err(|error| ReportError::Serialise {
                path: self.file.path().to_owned(),
                source: error.into(),
            })?;
        self.file.commit()
    }
}

fn test_case(case: &CaseEvent, class: &str, time: Duration) -> TestCase {
    let mut test = TestCase::new(readable(&case.id), status(case));
    test.set_classname(class).set_time(time);
    if !case.observations.is_empty() {
        let mut text = String::from("observed, where no document says what must be:\n");
        for observation in &case.observations {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{} = {}", observation.name, observation.value);
        }
        test.set_system_out(readable(&text));
    }
    test
}

fn status(case: &CaseEvent) -> TestCaseStatus {
    let (mut status, message) = match case.verdict {
        Verdict::Pass => return TestCaseStatus::success(),
        Verdict::Fail => (
            TestCaseStatus::non_success(NonSuccessKind::Failure),
            "not as expected",
        ),
        Verdict::Xpass => (
            TestCaseStatus::non_success(NonSuccessKind::Failure),
            "passes, but its baseline expects it not to",
        ),
        Verdict::Crash => (
            TestCaseStatus::non_success(NonSuccessKind::Error),
            "the engine crashed",
        ),
        Verdict::Timeout => (
            TestCaseStatus::non_success(NonSuccessKind::Error),
            "the engine did not answer in time",
        ),
        Verdict::Error => (
            TestCaseStatus::non_success(NonSuccessKind::Error),
            "the engine made no sense",
        ),
        Verdict::Xfail => (TestCaseStatus::skipped(), "fails, as its baseline expects"),
        Verdict::Unsupported => (TestCaseStatus::skipped(), "the engine does not support it"),
    };
    status
        .set_type(case.verdict.as_str())
        .set_message(readable(&format!("{message}: {}", case.title)));
    status.set_description(readable(&description(case)));
    status
}

fn description(case: &CaseEvent) -> String {
    format!(
        "{file}:{line}\nbasis: {basis}\nexpected: {expected}\ngot: {got}\n{diff}rerun: {rerun}\n",
        file = case.file,
        line = case.line,
        basis = case.basis,
        expected = case.expected,
        got = case.got,
        diff = diff::text(&case.expected, &case.got),
        rerun = case.rerun,
    )
}

/// Without the two characters that XML forbids and quick-junit lets through.
fn readable(text: &str) -> String {
    text.replace(['\u{fffe}', '\u{ffff}'], "\u{fffd}")
}

#[cfg(test)]
mod tests {
    use super::Junit;
    use crate::sample;
    use std::fs;
    use stickler_run::{CaseEvent, Verdict};

    fn document(cases: Vec<CaseEvent>) -> String {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("junit.xml");
        let mut junit = Junit::create(path.clone()).expect("a file");
        sample::run_of(cases).iter().for_each(|event| junit.take(event));
        junit.finish().expect("written");
        fs::read_to_string(path).expect("the document")
    }

    #[test]
    fn each_verdict_has_its_element() {
        let cases = Verdict::ALL.map(|verdict| sample::case(verdict.as_str(), verdict));
        let text = document(cases.to_vec());
        assert!(text.contains(r#"tests="8""#), "{text}");
        assert_eq!(text.matches("<failure ").count(), 2, "fail and xpass");
        assert_eq!(text.matches("<error ").count(), 3, "crash, timeout and error");
        assert_eq!(text.matches("<skipped ").count(), 2, "xfail and unsupported");
        assert!(
            text.contains("expected: into = INT#-128\ngot: into = INT#128\n- into = INT#-128\n"),
            "{text}"
        );
    }

    #[test]
    fn a_suite_is_an_engine_a_dialect_and_an_area() {
        let other = CaseEvent {
            area: "conversion".to_owned(),
            ..sample::case("a", Verdict::Pass)
        };
        let text = document(vec![sample::case("b", Verdict::Pass), other]);
        assert!(
            text.contains(r#"<testsuite name="reference.ironplc-ed2.conversion" tests="1""#),
            "{text}"
        );
        assert!(
            text.contains(r#"<testsuite name="reference.ironplc-ed2.widening" tests="1""#),
            "{text}"
        );
    }

    #[test]
    fn observations_stand_in_the_output() {
        let text = document(vec![sample::open_case("a")]);
        assert!(
            text.contains("<system-out>observed, where no document says what must be:\nr = INT#3\n"),
            "{text}"
        );
    }

    #[test]
    fn characters_that_xml_forbids_are_left_out() {
        let case = CaseEvent {
            got: "\u{0}\u{1b}[31m\u{ffff}<&".to_owned(),
            ..sample::case("a", Verdict::Fail)
        };
        let text = document(vec![case]);
        assert!(text.contains("&lt;&amp;"), "{text}");
        assert!(!text.contains(['\u{0}', '\u{1b}', '\u{ffff}']), "{text}");
    }
}
