//! The JUnit test of a case that did not pass.

use super::{error, failure, problem};
use crate::text::noted;
use crate::{compared, diff, overview};
use quick_junit::{TestCase, TestCaseStatus};
use stickler_run::{CaseEvent, EngineHeader, Fact, Verdict};

/// Returns the test of a case that did not pass.
pub(super) fn test(case: &CaseEvent, engine: Option<&EngineHeader>) -> TestCase {
    let status = kind(case.verdict).map(|(status, message)| {
        let message = match &case.baseline {
            // A reader shows nothing but the message of a skipped test.
            Some(note) => format!("{message} ({}): {}", note.reason, case.title),
            None => format!("{message}: {}", case.title),
        };
        problem(
            status,
            case.verdict.as_str(),
            &message,
            &description(case, engine),
        )
    });
    let mut test = TestCase::new(&*case.id, status.unwrap_or_else(TestCaseStatus::success));
    if !case.observations.is_empty() {
        test.set_system_out(observations(case));
    }
    test
}

fn observations(case: &CaseEvent) -> String {
    let mut text = "observed, where no source in Stickler says what must be:\n".to_owned();
    for observation in &case.observations {
        text.push_str(&format!("{} = {}\n", observation.name, observation.value));
    }
    text
}

/// Returns the status of a verdict, not described yet, with its message; `None` for a pass.
pub(super) fn kind(verdict: Verdict) -> Option<(TestCaseStatus, &'static str)> {
    let skipped = TestCaseStatus::skipped;
    match verdict {
        Verdict::Pass => None,
        Verdict::Fail => Some((failure(), "not as expected")),
        Verdict::Differs => Some((skipped(), "differs from a source that does not bind the engine")),
        Verdict::Xpass => Some((failure(), "passes, but its baseline expects it not to")),
        Verdict::Crash => Some((error(), "the engine crashed")),
        Verdict::Timeout => Some((error(), "the engine did not answer in time")),
        Verdict::Error => Some((error(), "the engine made no sense")),
        Verdict::Xfail => Some((skipped(), "fails, as its baseline expects")),
        Verdict::Unsupported => Some((skipped(), "the engine does not support it")),
        Verdict::Waiting => Some((skipped(), "it waits for a feature that the engine lacks")),
    }
}

fn description(case: &CaseEvent, engine: Option<&EngineHeader>) -> String {
    let (expected, got) = compared::texts(case, overview::strictness(engine));
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
        rerun = overview::rerun(engine, case),
    )
}
