//! The JUnit test of a case that did not pass.

use super::suite::{JunitTest, Problem, TestResult};
use crate::text::noted;
use crate::{compared, diff, engine};
use std::fmt::Write;
use stickler_run::{CaseEvent, EngineHeader, Fact, Verdict};

/// Returns the test of a case that did not pass.
pub(super) fn test<'c>(case: &'c CaseEvent, engine: Option<&EngineHeader>) -> JunitTest<'c> {
    let problem = kind(case.verdict).map(|(kind, message)| Problem {
        kind,
        type_name: case.verdict.as_str(),
        message: match &case.baseline {
            // A reader shows nothing but the message of a skipped test.
            Some(note) => format!("{message} ({}): {}", note.reason, case.title),
            None => format!("{message}: {}", case.title),
        },
        text: description(case, engine),
    });
    JunitTest {
        name: &case.id,
        microseconds: case.duration_us,
        problem,
        output: observations(case),
        ..JunitTest::default()
    }
}

fn observations(case: &CaseEvent) -> String {
    let mut text = String::new();
    if !case.observations.is_empty() {
        text.push_str("observed, where no source in Stickler says what must be:\n");
    }
    for observation in &case.observations {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{} = {}", observation.name, observation.value);
    }
    text
}

/// Returns the JUnit kind of a verdict, with its message; `None` for a pass.
pub(super) fn kind(verdict: Verdict) -> Option<(TestResult, &'static str)> {
    match verdict {
        Verdict::Pass => None,
        Verdict::Fail => Some((TestResult::Failure, "not as expected")),
        Verdict::Differs => Some((
            TestResult::Skipped,
            "differs from a source that does not bind the engine",
        )),
        Verdict::Xpass => Some((TestResult::Failure, "passes, but its baseline expects it not to")),
        Verdict::Crash => Some((TestResult::Error, "the engine crashed")),
        Verdict::Timeout => Some((TestResult::Error, "the engine did not answer in time")),
        Verdict::Error => Some((TestResult::Error, "the engine made no sense")),
        Verdict::Xfail => Some((TestResult::Skipped, "fails, as its baseline expects")),
        Verdict::Unsupported => Some((TestResult::Skipped, "the engine does not support it")),
        Verdict::Waiting => Some((
            TestResult::Skipped,
            "it waits for a feature that the engine lacks",
        )),
    }
}

fn description(case: &CaseEvent, engine: Option<&EngineHeader>) -> String {
    let (expected, got) = compared::texts(case, engine::strictness(engine));
    let baseline = case
        .baseline
        .as_ref()
        .map_or(String::new(), |note| format!("baseline: {}\n", noted(note)));
    format!(
        "{place}\nbasis: {basis}\n{baseline}expected: {expected}\ngot: {got}\n{diff}rerun: {rerun}\n",
        place = case.place(),
        basis = case.basis,
        expected = Fact::text(&case.expected),
        got = Fact::text(&case.got),
        diff = diff::text(&expected, &got),
        rerun = engine::rerun(engine, case),
    )
}
