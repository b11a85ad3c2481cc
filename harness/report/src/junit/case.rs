//! A case as a test of JUnit.

use super::suite::{Kind, Problem, Test};
use crate::text::noted;
use crate::{compared, diff};
use std::fmt::Write;
use stickler_run::{CaseEvent, Fact, Grade, Verdict};

/// The test of a case; its engine's rejections had to be so exact.
pub(super) fn test(case: &CaseEvent, strict: Grade) -> Test<'_> {
    let problem = kind(case.verdict).map(|(kind, message)| Problem {
        kind,
        type_name: case.verdict.as_str(),
        message: match &case.baseline {
            // A test that is skipped is shown with its message and no more.
            Some(note) => format!("{message} ({}): {}", note.reason, case.title),
            None => format!("{message}: {}", case.title),
        },
        text: description(case, strict),
    });
    Test {
        name: &case.id,
        microseconds: case.duration_us,
        problem,
        output: observations(case),
    }
}

fn observations(case: &CaseEvent) -> String {
    let mut text = String::new();
    if !case.observations.is_empty() {
        text.push_str("observed, where no document says what must be:\n");
    }
    for observation in &case.observations {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{} = {}", observation.name, observation.value);
    }
    text
}

fn kind(verdict: Verdict) -> Option<(Kind, &'static str)> {
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

fn description(case: &CaseEvent, strict: Grade) -> String {
    let (expected, got) = compared::texts(case, strict);
    let baseline = case
        .baseline
        .as_ref()
        .map_or(String::new(), |note| format!("baseline: {}\n", noted(note)));
    format!(
        "{file}:{line}\nbasis: {basis}\n{baseline}expected: {expected}\ngot: {got}\n{diff}rerun: {rerun}\n",
        file = case.file,
        line = case.line,
        basis = case.basis,
        expected = Fact::text(&case.expected),
        got = Fact::text(&case.got),
        diff = diff::text(&expected, &got),
        rerun = case.rerun,
    )
}
