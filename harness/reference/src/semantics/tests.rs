//! Tests of the checker on whole source texts.

mod calls;
mod contexts;
mod declarations;
mod folding;
mod limits;
mod literals;
mod operators;
mod places;
mod statements;
mod suggestions;
mod types;
mod values;

use crate::semantics::check;
use crate::{Limits, run};
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::LineIndex;
use stickler_types::dialect::Dialect;
use stickler_types::{DialectName, Observation, Outcome, RunRequest, Value};

pub(super) const ED2: DialectName = DialectName::IRONPLC_ED2;
pub(super) const ED3: DialectName = DialectName::IRONPLC_ED3;
pub(super) const RUSTY: DialectName = DialectName::IRONPLC_RUSTY;
pub(super) const MATIEC: DialectName = DialectName::MATIEC;
pub(super) const PLCNEXT: DialectName = DialectName::PLCNEXT;

/// Returns the diagnostics of the checker on a text that can be read.
pub(super) fn diagnose(name: DialectName, text: &str) -> Vec<SpannedDiagnostic> {
    let dialect = Dialect::of(name);
    let (unit, diagnostics) = stickler_syntax::parse(text, dialect);
    assert_eq!(diagnostics, [], "the text of a test can be read: {text}");
    check(&unit, text, &LineIndex::new(text), dialect).1
}

/// The lines and codes that the checker says, in order: `3 P4035`.
pub(super) fn says_in(name: DialectName, text: &str) -> Vec<String> {
    let lines = LineIndex::new(text);
    let mut said: Vec<_> = diagnose(name, text)
        .iter()
        .map(|diagnostic| {
            (
                lines.position(text, diagnostic.span.start).line,
                diagnostic.code.as_str(),
            )
        })
        .collect();
    said.sort_unstable();
    said.into_iter()
        .map(|(line, code)| format!("{line} {code}"))
        .collect()
}

/// Returns the lines and codes that the checker reports in the third edition.
pub(super) fn says(text: &str) -> Vec<String> {
    says_in(ED3, text)
}

/// The codes that the checker says of a program with these variables and this one statement.
pub(super) fn codes_in(name: DialectName, variables: &str, statement: &str) -> Vec<String> {
    let text = format!("PROGRAM main VAR {variables} END_VAR {statement} END_PROGRAM");
    says_in(name, &text)
        .into_iter()
        .map(|mut said| said.split_off(2))
        .collect()
}

/// Returns the codes that the checker reports, in the third edition, of a program with these variables and this statement.
pub(super) fn codes(variables: &str, statement: &str) -> Vec<String> {
    codes_in(ED3, variables, statement)
}

/// Runs a program once; `expected` are lines as `x = INT#5`.
pub(super) fn gives(text: &str, expected: &[&str]) {
    gives_in(ED3, text, 1, expected);
}

/// Runs a program in a dialect for some scans; `expected` are lines as `x = INT#5`.
pub(super) fn gives_in(dialect: DialectName, text: &str, scans: u32, expected: &[&str]) {
    let expected: Vec<_> = expected
        .iter()
        .map(|line| {
            let (name, literal) = line.split_once(" = ").expect("`name = literal`");
            (name.to_owned(), Value::parse(literal).expect("a literal"))
        })
        .collect();
    let observe: Vec<_> = expected
        .iter()
        .map(|(name, _)| Observation::last(name, ""))
        .collect();
    let request = RunRequest {
        scans,
        ..RunRequest::once(dialect, text, &observe)
    };
    let outcome = run(&request, Limits::default());
    assert_eq!(outcome, Ok(Outcome::executed(expected)), "{text}");
}
