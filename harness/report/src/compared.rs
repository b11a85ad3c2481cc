//! What counts of the texts of a judgement where they are shown beside each other.

use crate::fact::{self, Diagnostic, Fact};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use stickler_run::{CaseEvent, EngineHeader, Grade};

/// How exact the rejections of an engine had to be. One that the header does not name is held to the code.
pub(crate) fn strictness(engines: &[EngineHeader], name: &str) -> Grade {
    let engine = engines.iter().find(|engine| engine.name == name);
    engine.map_or(Grade::Code, |engine| engine.strict)
}

/// What was expected of a case and what was got, for a comparison line by line.
///
/// Where codes do not count, a diagnostic on a line that is expected is what was expected, in whatever words: both texts then
/// have the line of the expectation, with the compiler's words behind it. All other lines stay as they are.
pub(crate) fn texts(case: &CaseEvent, strict: Grade) -> (Cow<'_, str>, Cow<'_, str>) {
    let as_they_are = (Cow::from(&*case.expected), Cow::from(&*case.got));
    if strict == Grade::Code {
        return as_they_are;
    }
    let met = met(&case.expected, &case.got);
    if met.is_empty() {
        return as_they_are;
    }
    let expected = rewritten(&case.expected, |text, line| match met.get(&line) {
        Some(met) => vec![met.written(text)],
        None => vec![text.to_owned()],
    });
    let mut written = BTreeSet::new();
    let got = rewritten(&case.got, |text, line| match met.get(&line) {
        Some(met) if written.insert(line) => met.expected.iter().map(|text| met.written(text)).collect(),
        Some(_) => Vec::new(),
        None => vec![text.to_owned()],
    });
    (Cow::from(expected), Cow::from(got))
}

/// A line on which something is wrong, as is expected.
struct Met<'t> {
    /// What is expected on it.
    expected: Vec<&'t str>,
    /// The first that the compiler tells of it: its code, where it has one, and its message.
    told: String,
}

impl Met<'_> {
    /// A line of the expectation with the compiler's words behind it.
    fn written(&self, expected: &str) -> String {
        match self.told.as_str() {
            "" => expected.to_owned(),
            told => format!("{expected}, told as {told}"),
        }
    }
}

/// The lines that are expected and told.
fn met<'t>(expected: &'t str, got: &'t str) -> BTreeMap<u32, Met<'t>> {
    let mut awaited: BTreeMap<u32, Vec<&str>> = BTreeMap::new();
    for text in expected.lines() {
        if let Some(line) = placed(text) {
            awaited.entry(line).or_default().push(text);
        }
    }
    let mut met = BTreeMap::new();
    for diagnostic in got.lines().filter_map(diagnostic) {
        let expected = diagnostic.line.and_then(|line| awaited.remove_entry(&line));
        if let Some((line, expected)) = expected {
            let told = told(&diagnostic);
            met.insert(line, Met { expected, told });
        }
    }
    met
}

fn diagnostic(text: &str) -> Option<Diagnostic<'_>> {
    match fact::read(text) {
        Fact::Diagnostic(diagnostic) => Some(diagnostic),
        _ => None,
    }
}

/// The line that a diagnostic names.
fn placed(text: &str) -> Option<u32> {
    diagnostic(text)?.line
}

fn told(diagnostic: &Diagnostic<'_>) -> String {
    let parts = [diagnostic.code.unwrap_or_default(), diagnostic.message];
    let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join(": ")
}

/// A text in which other lines stand for each that names a line of the program.
fn rewritten(text: &str, mut anew: impl FnMut(&str, u32) -> Vec<String>) -> String {
    let lines = text.lines().flat_map(|line| match placed(line) {
        Some(number) => anew(line, number),
        None => vec![line.to_owned()],
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::{Grade, texts};
    use crate::diff;
    use crate::sample::case;
    use stickler_run::Verdict;

    const EXPECTED: &str =
        "line 4: error P4023\nline 6: error P4001\nline 6: error P4026\nline 9: error P4007";

    fn difference(got: &str, strict: Grade) -> String {
        let mut case = case("t::a", Verdict::Fail);
        case.expected = EXPECTED.to_owned();
        case.got = got.to_owned();
        let (expected, got) = texts(&case, strict);
        diff::text(&expected, &got)
    }

    #[test]
    fn a_line_that_is_met_is_the_same_on_both_sides_where_codes_do_not_count() {
        let got = "line 6: error without a code: ')' missing\nline 6: error without a code: ';' missing\n\
                   line 7: error E037: no\nline 9: error E048: no such name\nsomewhere: error E1: odd";
        let expected = "- line 4: error P4023\n  line 6: error P4001, told as ')' missing\n  \
                        line 6: error P4026, told as ')' missing\n+ line 7: error E037: no\n  \
                        line 9: error P4007, told as E048: no such name\n+ somewhere: error E1: odd\n";
        assert_eq!(difference(got, Grade::Line), expected);
        assert_eq!(difference(got, Grade::Rejected), expected);
        let by_code = difference(got, Grade::Code);
        assert!(by_code.contains("\n- line 9: error P4007\n"), "{by_code}");
    }

    #[test]
    fn what_meets_nothing_is_compared_as_it_is() {
        let all_missing: String = EXPECTED.lines().map(|line| format!("- {line}\n")).collect();
        let got = "line 1: error without a code: m";
        assert_eq!(difference(got, Grade::Line), format!("{all_missing}+ {got}\n"));
        assert_eq!(
            difference("accepted", Grade::Line),
            format!("{all_missing}+ accepted\n")
        );
    }
}
