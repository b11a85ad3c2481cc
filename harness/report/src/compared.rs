//! Prepares the expected and the actual text of a case for a comparison side by side.

use std::collections::{BTreeMap, BTreeSet};
use stickler_run::{CaseEvent, Fact, Grade};
use stickler_types::Diagnostic;

/// Returns the expected and the actual text of a case, for a comparison line by line.
///
/// Where codes are not compared, a diagnostic on an expected line counts as the expected one: both texts then have the line
/// of the expectation, followed by the compiler's words. All other facts stay as they are.
pub(crate) fn texts(case: &CaseEvent, strict: Grade) -> (String, String) {
    let met = match strict {
        Grade::Code => BTreeMap::new(),
        Grade::Line | Grade::Rejected => met(&case.expected, &case.got),
    };
    let expected = rewritten(&case.expected, |fact, line| match met.get(&line) {
        Some(met) => vec![met.written(fact)],
        None => vec![fact.to_string()],
    });
    let mut written = BTreeSet::new();
    let got = rewritten(&case.got, |fact, line| match met.get(&line) {
        Some(met) if written.insert(line) => met.expected.iter().map(|fact| met.written(fact)).collect(),
        Some(_) => Vec::new(),
        None => vec![fact.to_string()],
    });
    (expected, got)
}

/// The expected diagnostics of one line of the program, and an actual one on it.
struct Met<'f> {
    /// The diagnostics that are expected on the line.
    expected: Vec<&'f Fact>,
    /// The first diagnostic that the compiler gives on the line.
    reported: &'f Diagnostic,
}

impl Met<'_> {
    /// Formats an expected fact followed by the compiler's words: its code, where it has one, and its message.
    fn written(&self, expected: &Fact) -> String {
        let words = self.reported.code.iter().chain([&self.reported.message]);
        let words: Vec<&str> = words
            .map(String::as_str)
            .filter(|word| !word.is_empty())
            .collect();
        match words.is_empty() {
            true => expected.to_string(),
            false => format!("{expected}, told as {}", words.join(": ")),
        }
    }
}

/// Returns the lines on which a diagnostic is both expected and given.
fn met<'f>(expected: &'f [Fact], got: &'f [Fact]) -> BTreeMap<u32, Met<'f>> {
    let mut awaited: BTreeMap<u32, Vec<&Fact>> = BTreeMap::new();
    for fact in expected {
        if let Some(line) = fact.diagnostic().and_then(|diagnostic| diagnostic.line) {
            awaited.entry(line).or_default().push(fact);
        }
    }
    let mut met = BTreeMap::new();
    for reported in got.iter().filter_map(Fact::diagnostic) {
        if let Some((line, expected)) = reported.line.and_then(|line| awaited.remove_entry(&line)) {
            met.insert(line, Met { expected, reported });
        }
    }
    met
}

/// Formats facts, with each diagnostic that names a line of the program replaced by the lines that `anew` returns.
fn rewritten(facts: &[Fact], mut anew: impl FnMut(&Fact, u32) -> Vec<String>) -> String {
    let lines = facts.iter().flat_map(|fact| match fact.diagnostic() {
        Some(Diagnostic { line: Some(line), .. }) => anew(fact, *line),
        _ => vec![fact.to_string()],
    });
    lines.collect::<Vec<_>>().join("\n")
}
