//! `junit.xml`: the run for continuous integration. The first test suite holds one test for each claim. Where case files are
//! broken, a test suite for them follows, and where entries of baselines are out of date, one for those. Then comes one test
//! suite for each engine, dialect and area: a test for each case that did not pass and that reports list, one for all others of a
//! verdict, and for each probe one test for all of its cases that did pass. The cases of a probe that an engine does not support also share
//! one test, which is skipped.
//!
//! The document is built with quick-junit, which writes XML that JUnit's readers accept.

mod case;

use crate::ReportError;
use crate::claims::Claim;
use crate::groups::{Group, GroupNumber, Groups};
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::text::outdated;
use crate::unexpected::Unexpected;
use indexmap::IndexMap;
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;
use std::time::Duration;
use stickler_run::{CaseEvent, Event, Fact, Verdict};
use stickler_types::counted;

/// The tests of a run, gathered because the file separates test suites whose cases alternate in the stream of events.
pub(crate) struct Junit {
    file: PendingFile,
    suites: BTreeMap<String, TestSuite>,
    /// The number of cases without a test, by suite and verdict.
    others: BTreeMap<(String, Verdict), u64>,
    groups: Vec<GroupTally>,
}

/// The counts of those cases of a group that share a test, by their verdict.
type GroupTally = BTreeMap<Verdict, ProbeTally>;

/// The number of cases with one verdict, and the sums of their observations and times.
#[derive(Default)]
struct ProbeTally {
    cases: u64,
    observations: u64,
    microseconds: u64,
    /// The text of the first case's actual facts; empty where the cases passed.
    got: String,
}

impl ProbeTally {
    /// Adds a case.
    fn take(&mut self, case: &CaseEvent) {
        self.add(ProbeTally {
            cases: 1,
            observations: case.observations.len() as u64,
            microseconds: case.duration_us,
            got: match case.verdict {
                Verdict::Unsupported | Verdict::Waiting if self.cases == 0 => Fact::text(&case.got),
                _ => String::new(),
            },
        });
    }

    /// Adds the cases of another tally.
    fn add(&mut self, other: ProbeTally) {
        if self.cases == 0 {
            self.got = other.got;
        }
        self.cases += other.cases;
        self.observations += other.observations;
        self.microseconds += other.microseconds;
    }

    /// Adds the test of the cases of a probe with this verdict to a suite.
    fn add_test(&self, suite: &mut TestSuite, group: &Group, verdict: Verdict) {
        let status = case::kind(verdict).map(|(status, message)| {
            let cases = counted(self.cases, "case", "cases");
            let message = format!("{message} ({cases}): {}", group.title);
            problem(status, verdict.as_str(), &message, &self.got)
        });
        let mut test = TestCase::new(&*group.id, status.unwrap_or_else(TestCaseStatus::success));
        for (name, number) in [("cases", self.cases), ("observations", self.observations)] {
            if number > 0 {
                test.add_property((name.to_owned(), number.to_string()));
            }
        }
        add(suite, test, self.microseconds);
    }
}

impl Junit {
    /// Creates the file.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be created.
    pub(crate) fn create(path: PathBuf) -> Result<Junit, ReportError> {
        Ok(Junit {
            file: PendingFile::create(path)?,
            suites: BTreeMap::new(),
            others: BTreeMap::new(),
            groups: Vec::new(),
        })
    }

    /// Adds one event, with the group of a case.
    pub(crate) fn take(&mut self, event: &Event, group: Option<GroupNumber>) {
        let (Event::Case(case), Some(group)) = (event, group) else {
            return;
        };
        if self.groups.len() <= group {
            self.groups.resize_with(group + 1, GroupTally::default);
        }
        if shares_test(case.verdict) {
            self.groups[group].entry(case.verdict).or_default().take(case);
        } else {
            let name = suite_name(&case.engine, &case.dialect, &case.area);
            *self.others.entry((name, case.verdict)).or_default() += 1;
        }
    }

    /// Adds the tests of the listed cases that did not pass, and of each suite one for all other cases of a verdict.
    fn add_cases(&mut self, overview: &Overview) {
        for case in overview.listed.iter().filter(|case| !shares_test(case.verdict)) {
            let name = suite_name(&case.engine, &case.dialect, &case.area);
            let test = case::test(case, overview.engine(&case.engine));
            let suite = suite_of(&mut self.suites, name.clone());
            add(suite, test, case.duration_us);
            if let Some(others) = self.others.get_mut(&(name, case.verdict)) {
                *others -= 1;
            }
        }
        for ((name, verdict), others) in std::mem::take(&mut self.others) {
            if let (1.., Some((status, message))) = (others, case::kind(verdict)) {
                let cases = counted(others, "more case", "more cases");
                let message = format!("{message}: {cases} that events.jsonl.gz has");
                let status = problem(status, verdict.as_str(), &message, "");
                let test = TestCase::new(format!("{cases}: {verdict}"), status);
                add(suite_of(&mut self.suites, name), test, 0);
            }
        }
    }

    /// Adds the tests that cover several cases: one for each probe and dialect, even where its cases are of several groups.
    fn add_tallies(&mut self, groups: &Groups) {
        let mut tallies: IndexMap<_, (&Group, GroupTally)> = IndexMap::new();
        for (group, tally) in groups.all().zip(std::mem::take(&mut self.groups)) {
            let probe = (&group.id, &group.dialect, &group.engine);
            let (_, sum) = tallies
                .entry(probe)
                .or_insert_with(|| (group, GroupTally::default()));
            for (verdict, tally) in tally {
                sum.entry(verdict).or_default().add(tally);
            }
        }
        for (group, tally) in tallies.values() {
            let name = suite_name(&group.engine, &group.dialect, &group.area);
            let suite = suite_of(&mut self.suites, name);
            for (verdict, tally) in tally {
                tally.add_test(suite, group, *verdict);
            }
        }
    }

    /// Writes the document; a run that was cut short gets none.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn finish(mut self, overview: &Overview, groups: &Groups) -> Result<(), ReportError> {
        let Some(footer) = &overview.footer else {
            return Ok(());
        };
        self.add_cases(overview);
        self.add_tallies(groups);
        let path = self.file.path().to_owned();
        let mut report = Report::new("stickler");
        report.set_time(Duration::from_millis(footer.duration_ms));
        report.add_test_suite(claims(overview));
        report.add_test_suites(features(overview));
        report.add_test_suites(broken_files(overview));
        report.add_test_suites(outdated_entries(overview));
        report.add_test_suites(self.suites.into_values());
        report
            .serialize(&mut self.file)
            .map_err(io::Error::other)
            .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }
}

/// Returns whether the cases of a probe with this verdict share a test.
fn shares_test(verdict: Verdict) -> bool {
    matches!(verdict, Verdict::Pass | Verdict::Unsupported | Verdict::Waiting)
}

/// Returns the name of the test suite of an engine, a dialect and an area.
fn suite_name(engine: &str, dialect: &str, area: &str) -> String {
    format!("{engine}.{dialect}.{area}")
}

fn suite_of(suites: &mut BTreeMap<String, TestSuite>, name: String) -> &mut TestSuite {
    suites.entry(name).or_insert_with_key(|name| suite(name))
}

/// Returns the test suite of claims. A claim that fails only where a baseline expects it is skipped, as its cases are.
fn claims(overview: &Overview) -> TestSuite {
    let mut suite = suite("claims");
    for claim in overview.claims.iter() {
        let standing = claim.standing;
        let mut output = format!(
            "passed {}, failed {}, open {}, unsupported {}, waiting {}",
            standing.passed, standing.failed, standing.open, standing.unsupported, standing.waiting
        );
        if let Some(source) = overview.source(claim.source) {
            output += &format!("\n{}: {}", source.kind, source.address_of(claim.section));
        }
        let fail = format!("{} of {} cases fail", standing.failed, standing.cases());
        let status = match (standing.failed, standing.unexpected()) {
            (0, _) => TestCaseStatus::success(),
            (_, 0) => {
                let message = format!("{fail}, as the baseline expects");
                problem(TestCaseStatus::skipped(), "claim", &message, &output)
            }
            _ => problem(failure(), "claim", &fail, &output),
        };
        let mut test = TestCase::new(claim_name(&claim, overview.totals.len() > 1), status);
        test.set_system_out(output);
        add(&mut suite, test, 0);
    }
    suite
}

/// Returns the test suite of the features that engines lack, where there are any; those that nobody promises are skipped.
fn features(overview: &Overview) -> Option<TestSuite> {
    let mut suite = (!overview.lacks.is_empty()).then(|| suite("features"))?;
    for lack in &overview.lacks {
        let Unexpected { title, text, .. } = Unexpected::of_cause(lack, overview);
        let status = match lack.is_failing_lack() {
            true => failure(),
            false => TestCaseStatus::skipped(),
        };
        let status = problem(status, "feature", &title, &text);
        let name = format!("{}: {}", lack.engine, lack.construct);
        add(&mut suite, TestCase::new(name, status), 0);
    }
    Some(suite)
}

/// Returns the test suite of the mistakes in case files, where there are any: a CI service must not show a clean run.
fn broken_files(overview: &Overview) -> Option<TestSuite> {
    let broken = overview.header.as_ref().map(|header| &header.broken_files)?;
    let mut suite = (!broken.is_empty()).then(|| suite("case-files"))?;
    for mistake in broken {
        let status = problem(error(), "case-file", "some cases were not run", mistake);
        add(&mut suite, TestCase::new(&**mistake, status), 0);
    }
    Some(suite)
}

/// Returns the test suite of the baseline entries that are out of date, where there are any: each of them fails.
fn outdated_entries(overview: &Overview) -> Option<TestSuite> {
    let mut suite = overview.outdated().next().map(|_| suite("baselines"))?;
    for entry in overview.outdated() {
        let text = outdated(entry);
        let status = problem(failure(), "baseline", &text, &text);
        add(&mut suite, TestCase::new(&*entry.at, status), 0);
    }
    Some(suite)
}

fn claim_name(claim: &Claim<'_>, name_engine: bool) -> String {
    let mut name = claim.source.to_owned();
    if !claim.section.is_empty() {
        name += &format!(": {}", claim.section);
    }
    if name_engine {
        name += &format!(" ({})", claim.engine);
    }
    name
}

/// Returns a test suite without tests.
fn suite(name: &str) -> TestSuite {
    let mut suite = TestSuite::new(name);
    suite.set_time(Duration::ZERO);
    suite
}

/// Adds a test, which took so many microseconds, to a suite, which adds up the time of its tests.
fn add(suite: &mut TestSuite, mut test: TestCase, microseconds: u64) {
    let time = Duration::from_micros(microseconds);
    test.set_classname(suite.name.clone()).set_time(time);
    suite.set_time(suite.time.unwrap_or_default() + time);
    suite.add_test_case(test);
}

/// Returns the status of a test that gave a wrong result.
fn failure() -> TestCaseStatus {
    TestCaseStatus::non_success(NonSuccessKind::Failure)
}

/// Returns the status of a test that gave no result.
fn error() -> TestCaseStatus {
    TestCaseStatus::non_success(NonSuccessKind::Error)
}

/// Describes a failure, an error or a skip: its kind in Stickler's terms, a message on one line, in which line ends and tabs become
/// spaces, as XML readers normalize the attribute, and the full text.
fn problem(mut status: TestCaseStatus, type_name: &str, message: &str, text: &str) -> TestCaseStatus {
    status
        .set_type(type_name)
        .set_message(message.replace(['\n', '\t'], " "))
        .set_description(text);
    status
}
