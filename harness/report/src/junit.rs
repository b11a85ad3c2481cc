//! `junit.xml`: the run for continuous integration. The first test suite is the claims, one test a claim; then comes one
//! test suite an engine, dialect and area, one test a case.
//!
//! It is written by hand: there are a hundred thousand tests, most of which have nothing to say, and a tree of them
//! costs more than running them. Its tests read it back with quick-junit.

use crate::claims::{Claim, Standing};
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::spool::Spool;
use crate::xml::{add_attribute, add_text};
use crate::{ReportError, diff};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::PathBuf;
use stickler_run::{CaseEvent, Event, Verdict};

/// Gathers the run: test suites are apart in the file, and their cases are not in the stream of events.
pub(crate) struct Junit {
    file: PendingFile,
    suites: BTreeMap<String, Suite>,
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
        })
    }

    /// Adds one event.
    pub(crate) fn take(&mut self, event: &Event) {
        match event {
            // The times of header and footer are taken from the overview, when the document is written.
            Event::Header(_) | Event::Footer(_) => {}
            Event::Case(case) => {
                let name = format!("{}.{}.{}", case.engine, case.dialect, case.area);
                self.suites
                    .entry(name)
                    .or_insert_with_key(|name| Suite::new(name))
                    .take(case);
            }
        }
    }

    /// Writes the document; a run that was cut short has none.
    ///
    /// # Errors
    /// [`ReportError::Write`] where that fails.
    pub(crate) fn finish(mut self, overview: &Overview) -> Result<(), ReportError> {
        let Some(footer) = &overview.footer else {
            return Ok(());
        };
        let path = self.file.path().to_owned();
        let claims = claims(overview);
        self.write(&claims, footer.duration_ms)
            .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }

    fn write(&mut self, claims: &Suite, duration_ms: u64) -> io::Result<()> {
        let suites = || std::iter::once(claims).chain(self.suites.values());
        let sum = |count: fn(&Counts) -> u64| suites().map(|suite| count(&suite.counts)).sum();
        let counts = Counts {
            tests: sum(|counts| counts.tests),
            failures: sum(|counts| counts.failures),
            errors: sum(|counts| counts.errors),
            skipped: sum(|counts| counts.skipped),
            microseconds: duration_ms * 1000,
        };
        let out = &mut self.file;
        writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
        writeln!(out, "<testsuites name=\"stickler\"{}>", counts.attributes())?;
        claims.write(out)?;
        self.suites.values().try_for_each(|suite| suite.write(out))?;
        writeln!(out, "</testsuites>")
    }
}

/// One test suite: its tests as XML, and their numbers, which stand before them.
struct Suite {
    name: String,
    counts: Counts,
    tests: Spool,
}

#[derive(Clone, Copy, Default)]
struct Counts {
    tests: u64,
    failures: u64,
    errors: u64,
    skipped: u64,
    microseconds: u64,
}

impl Counts {
    fn attributes(&self) -> String {
        format!(
            " tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{}\"",
            self.tests,
            self.failures,
            self.errors,
            self.skipped,
            seconds(self.microseconds)
        )
    }
}

impl Suite {
    fn new(name: &str) -> Suite {
        Suite {
            name: name.to_owned(),
            counts: Counts::default(),
            tests: Spool::default(),
        }
    }

    fn take(&mut self, case: &CaseEvent) {
        self.counts.microseconds += case.duration_us;
        self.begin(&case.id, case.duration_us);
        let problem = problem(case.verdict);
        if problem.is_none() && case.observations.is_empty() {
            return self.tests.add(b"/>\n");
        }
        self.tests.add(b">\n");
        if let Some((kind, message)) = problem {
            self.problem(
                kind,
                case.verdict.as_str(),
                &format!("{message}: {}", case.title),
                &description(case),
            );
        }
        if !case.observations.is_empty() {
            self.output(case);
        }
        self.tests.add(b"</testcase>\n");
    }

    fn begin(&mut self, name: &str, microseconds: u64) {
        self.counts.tests += 1;
        self.tests.add(b"<testcase");
        add_attribute(&mut self.tests, "name", name);
        add_attribute(&mut self.tests, "classname", &self.name);
        add_attribute(&mut self.tests, "time", &seconds(microseconds));
    }

    fn problem(&mut self, kind: Kind, type_name: &str, message: &str, text: &str) {
        let (element, counter) = match kind {
            Kind::Failure => ("failure", &mut self.counts.failures),
            Kind::Error => ("error", &mut self.counts.errors),
            Kind::Skipped => ("skipped", &mut self.counts.skipped),
        };
        *counter += 1;
        let out = &mut self.tests;
        out.add(b"<");
        out.add(element.as_bytes());
        add_attribute(out, "type", type_name);
        add_attribute(out, "message", message);
        out.add(b">");
        add_text(out, text);
        out.add(b"</");
        out.add(element.as_bytes());
        out.add(b">\n");
    }

    fn output(&mut self, case: &CaseEvent) {
        let out = &mut self.tests;
        out.add(b"<system-out>observed, where no document says what must be:\n");
        for observation in &case.observations {
            add_text(out, &observation.name);
            out.add(b" = ");
            add_text(out, &observation.value);
            out.add(b"\n");
        }
        out.add(b"</system-out>\n");
    }

    fn write(&self, out: &mut impl io::Write) -> io::Result<()> {
        let mut head = Spool::default();
        head.add(b"<testsuite");
        add_attribute(&mut head, "name", &self.name);
        head.add(self.counts.attributes().as_bytes());
        head.add(b">\n");
        head.write(out)?;
        self.tests.write(out)?;
        out.write_all(b"</testsuite>\n")
    }
}

/// What JUnit calls a test that did not simply pass.
#[derive(Clone, Copy)]
enum Kind {
    Failure,
    Error,
    Skipped,
}

fn problem(verdict: Verdict) -> Option<(Kind, &'static str)> {
    match verdict {
        Verdict::Pass => None,
        Verdict::Fail => Some((Kind::Failure, "not as expected")),
        Verdict::Xpass => Some((Kind::Failure, "passes, but its baseline expects it not to")),
        Verdict::Crash => Some((Kind::Error, "the engine crashed")),
        Verdict::Timeout => Some((Kind::Error, "the engine did not answer in time")),
        Verdict::Error => Some((Kind::Error, "the engine made no sense")),
        Verdict::Xfail => Some((Kind::Skipped, "fails, as its baseline expects")),
        Verdict::Unsupported => Some((Kind::Skipped, "the engine does not support it")),
    }
}

/// The claims as a test suite.
fn claims(overview: &Overview) -> Suite {
    let mut suite = Suite::new("claims");
    for claim in overview.claims.iter() {
        suite.begin(&claim_name(&claim, overview.totals.len() > 1), 0);
        suite.tests.add(b">\n");
        let Standing {
            passed,
            failed,
            open,
            unsupported,
        } = claim.standing;
        let standing = format!("passed {passed}, failed {failed}, open {open}, unsupported {unsupported}");
        if failed > 0 {
            let message = format!("{failed} of {} cases fail", claim.standing.cases());
            suite.problem(Kind::Failure, "claim", &message, &standing);
        }
        suite.tests.add(b"<system-out>");
        suite.tests.add(standing.as_bytes());
        suite.tests.add(b"</system-out>\n</testcase>\n");
    }
    suite
}

fn claim_name(claim: &Claim<'_>, name_engine: bool) -> String {
    let mut name = claim.source.to_owned();
    // Writing to a String cannot fail.
    if !claim.section.is_empty() {
        let _ = write!(name, ": {}", claim.section);
    }
    if name_engine {
        let _ = write!(name, " ({})", claim.engine);
    }
    name
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

fn seconds(microseconds: u64) -> String {
    format!("{}.{:06}", microseconds / 1_000_000, microseconds % 1_000_000)
}

#[cfg(test)]
mod tests {
    use super::Junit;
    use crate::overview::Overview;
    use crate::sample;
    use quick_junit::{NonSuccessKind, Report, TestCaseStatus, TestSuite};
    use std::fs;
    use stickler_run::{CaseEvent, Verdict};

    fn document(cases: Vec<CaseEvent>) -> Report {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("junit.xml");
        let mut junit = Junit::create(path.clone()).expect("a file");
        let mut overview = Overview::default();
        for event in &sample::run_of(cases) {
            junit.take(event);
            overview.take(event);
        }
        junit.finish(&overview).expect("written");
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
    fn each_verdict_has_its_element() {
        let report = document(
            Verdict::ALL
                .map(|verdict| sample::case(verdict.as_str(), verdict))
                .to_vec(),
        );
        let suite = suite(&report);
        assert_eq!(
            (suite.tests, suite.failures, suite.errors, suite.skipped),
            (8, 2, 3, 2)
        );
        for (case, verdict) in suite.test_cases.iter().zip(Verdict::ALL) {
            let expected = match verdict {
                Verdict::Pass => None,
                Verdict::Fail | Verdict::Xpass => Some(NonSuccessKind::Failure),
                Verdict::Crash | Verdict::Timeout | Verdict::Error => Some(NonSuccessKind::Error),
                Verdict::Xfail | Verdict::Unsupported => continue,
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
            (9, 3, 3, 2)
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
    fn observations_stand_in_the_output() {
        let report = document(vec![sample::open_case("a")]);
        let output = suite(&report).test_cases[0]
            .system_out
            .as_deref()
            .expect("output");
        assert!(output.contains("r = INT#3"), "{output}");
    }

    #[test]
    fn whatever_an_engine_says_the_document_can_be_read() {
        let case = CaseEvent {
            got: "\u{0}\u{1b}[31m\u{ffff}]]><&\"'\u{7f}".to_owned(),
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
}
