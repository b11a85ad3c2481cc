//! Comparing what the reference does with a case with what must happen; by code and line, as `stickler-run` judges it.
//!
//! Basis: conformance-cases/README.md (marks); reports/README.md (the words).

#[path = "../../../run/src/judge/bodies.rs"]
mod bodies;

use crate::prepared::{PreparedCase, PreparedExpectation};
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_reference::{Limits, render, run};
use stickler_types::{Acceptance, Diagnostic, DialectName, Outcome, RunRequest, Value};

/// Returns what is wrong with the reference's answer to a case; `None` where it is right. A panic is a wrong answer.
pub fn complaint(case: &PreparedCase) -> Option<String> {
    catch_unwind(AssertUnwindSafe(|| wrong(case))).unwrap_or_else(|_| Some("it panics".to_owned()))
}

fn wrong(case: &PreparedCase) -> Option<String> {
    let answer = match answer(case, &case.source) {
        Ok(answer) => answer,
        Err(error) => return Some(error),
    };
    let expectation = &case.expectation;
    let warnings = answer.warnings();
    let reported = match &answer {
        Outcome::Rejected { diagnostics } => rejected(expectation, diagnostics),
        Outcome::Faulted {
            fault, line, values, ..
        } => {
            let found = (line.unwrap_or_default(), fault.as_str());
            faulted(expectation, found).or_else(|| values_differ(expectation, values))
        }
        Outcome::Executed { values, .. } => {
            executed(expectation).or_else(|| values_differ(expectation, values))
        }
        other => Some(other.to_string()),
    };
    let reported = reported.or_else(|| warnings_differ(expectation, warnings?));
    reported.or_else(|| {
        let wanted = expectation.rendered.as_ref()?;
        rendering(case, wanted, &answer)
    })
}

/// Returns the reference's answer to `source`, with all that the case asks and sets.
fn answer(case: &PreparedCase, source: &str) -> Result<Outcome, String> {
    let dialect = case.dialect.parse().map_err(|_| "it does not know the dialect")?;
    let request = RunRequest {
        dialect,
        source,
        scans: case.scans,
        observe: &case.observe,
        clock: &case.clock,
        set: &case.set,
    };
    run(&request, Limits::default()).map_err(|error| error.to_string())
}

/// Returns the lines and codes of diagnostics, sorted, and whether one names a clean line.
fn reported<'d>(
    expectation: &PreparedExpectation,
    diagnostics: &'d [Diagnostic],
) -> (Vec<(u32, &'d str)>, bool) {
    let mut found: Vec<(u32, &str)> = diagnostics
        .iter()
        .filter_map(|found| Some((found.line?, found.code.as_deref()?)))
        .collect();
    found.sort_unstable();
    let on_clean_line = found
        .iter()
        .any(|(line, _)| expectation.clean_lines.contains(line));
    (found, on_clean_line)
}

/// Returns lines and codes that are expected as those of diagnostics are.
fn texts(expected: &[(u32, String)]) -> Vec<(u32, &str)> {
    expected
        .iter()
        .map(|(line, code)| (*line, code.as_str()))
        .collect()
}

/// Returns what is wrong with the warnings of a program that was accepted: one is missing, or names a clean line.
fn warnings_differ(expectation: &PreparedExpectation, warnings: &[Diagnostic]) -> Option<String> {
    let (found, on_clean_line) = reported(expectation, warnings);
    let all_given = texts(&expectation.warnings)
        .iter()
        .all(|wanted| found.contains(wanted));
    (!all_given || on_clean_line).then(|| format!("warnings: {found:?}"))
}

fn rejected(expectation: &PreparedExpectation, diagnostics: &[Diagnostic]) -> Option<String> {
    let (found, on_clean_line) = reported(expectation, diagnostics);
    let right = match expectation.acceptance {
        Acceptance::Required => false,
        Acceptance::Observed => true,
        Acceptance::Rejected => {
            let mut expected = texts(&expectation.diagnostics);
            expected.sort_unstable();
            expected == found
        }
    };
    (!right || on_clean_line).then(|| format!("rejected: {found:?}"))
}

fn faulted(expectation: &PreparedExpectation, found: (u32, &str)) -> Option<String> {
    let right = match &expectation.fault {
        Some((line, fault)) => (*line, fault.as_str()) == found,
        // Where acceptance itself is open, how the program ends is open as well.
        None => expectation.acceptance == Acceptance::Observed,
    };
    (!right).then(|| format!("faulted: {found:?}"))
}

fn executed(expectation: &PreparedExpectation) -> Option<String> {
    let may_run = expectation.acceptance != Acceptance::Rejected && expectation.fault.is_none();
    (!may_run).then(|| "accepted".to_owned())
}

fn values_differ(expectation: &PreparedExpectation, values: &[(String, Value)]) -> Option<String> {
    expectation.values.iter().find_map(|(key, expected)| {
        let Some((_, value)) = values.iter().find(|(name, _)| name == key) else {
            return Some(format!("{key} is missing"));
        };
        let text = value.to_string();
        let same = match value {
            Value::Enumerated { .. } => text.eq_ignore_ascii_case(expected),
            _ => {
                let admits = || Value::parse_expected(expected).is_ok_and(|expected| expected.admits(value));
                text == *expected || admits()
            }
        };
        (!same).then(|| format!("{key} = {text}"))
    })
}

/// The bodies must be the expected lines, rendering again must change nothing, and the rendered program must do what the
/// program did.
fn rendering(case: &PreparedCase, wanted: &[String], answer: &Outcome) -> Option<String> {
    let dialect: DialectName = case.dialect.parse().ok()?;
    let Ok(text) = render(&case.source, dialect) else {
        return Some("not rendered".to_owned());
    };
    if bodies::rendered_bodies(&text) != wanted {
        return Some(format!("rendered: {text}"));
    }
    if render(&text, dialect).as_ref() != Ok(&text) {
        return Some("rendered again, it is another text".to_owned());
    }
    let same = self::answer(case, &text).is_ok_and(|again| answer.ends_like(&again));
    (!same).then(|| "the rendered program does something else".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;
    use stickler_types::Observation;

    /// Shows what is wrong with the answer to a program; an example has the keys in which its expectation differs from none.
    #[test]
    fn golden_complaints() {
        check_examples("tests/complaints.md", |example| {
            let mut expectation = serde_json::to_value(PreparedExpectation::default()).unwrap();
            let stated: serde_json::Value = serde_json::from_str(example.text("expected")).unwrap();
            for (key, value) in stated.as_object().unwrap() {
                assert!(expectation.get(key).is_some(), "there is no key `{key}`");
                expectation[key] = value.clone();
            }
            let case = PreparedCase {
                dialect: "ironplc-ed3".to_owned(),
                source: example.text("program").to_owned(),
                scans: 1,
                observe: vec![Observation::last("a", "")],
                expectation: serde_json::from_value(expectation).unwrap(),
                ..PreparedCase::default()
            };
            complaint(&case).unwrap_or_else(|| "none".to_owned())
        });
    }
}
