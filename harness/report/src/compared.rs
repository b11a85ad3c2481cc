//! The texts of what was expected and what was got, as they are shown beside each other.

use std::collections::{BTreeMap, BTreeSet};
use stickler_run::{CaseEvent, Fact, Grade};
use stickler_types::Diagnostic;

/// Returns what was expected of a case and what was got, for a comparison line by line.
///
/// Where codes do not count, a diagnostic on a line that is expected is what was expected, in whatever words: both texts then
/// have the line of the expectation, with the compiler's words behind it. All other facts stay as they are.
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

/// A line on which something is wrong, as is expected.
struct Met<'f> {
    /// What is expected on it.
    expected: Vec<&'f Fact>,
    /// The first that the compiler tells of it.
    told: &'f Diagnostic,
}

impl Met<'_> {
    /// Returns an expected fact with the compiler's words behind it: its code, where it has one, and its message.
    fn written(&self, expected: &Fact) -> String {
        let words = self.told.code.iter().chain([&self.told.message]);
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

/// Returns the lines that are expected and told.
fn met<'f>(expected: &'f [Fact], got: &'f [Fact]) -> BTreeMap<u32, Met<'f>> {
    let mut awaited: BTreeMap<u32, Vec<&Fact>> = BTreeMap::new();
    for fact in expected {
        if let Some(line) = fact.diagnostic().and_then(|diagnostic| diagnostic.line) {
            awaited.entry(line).or_default().push(fact);
        }
    }
    let mut met = BTreeMap::new();
    for told in got.iter().filter_map(Fact::diagnostic) {
        if let Some((line, expected)) = told.line.and_then(|line| awaited.remove_entry(&line)) {
            met.insert(line, Met { expected, told });
        }
    }
    met
}

/// Returns the text of facts, in which other lines stand for each diagnostic that names a line of the program.
fn rewritten(facts: &[Fact], mut anew: impl FnMut(&Fact, u32) -> Vec<String>) -> String {
    let lines = facts.iter().flat_map(|fact| match fact.diagnostic() {
        Some(Diagnostic { line: Some(line), .. }) => anew(fact, *line),
        _ => vec![fact.to_string()],
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::{Fact, Grade, texts};
    use crate::diff;
    use crate::sample::{case, error, told};
    use stickler_run::{CaseEvent, Verdict};

    fn expected() -> Vec<Fact> {
        vec![
            error(4, "P4023"),
            error(6, "P4001"),
            error(6, "P4026"),
            error(9, "P4007"),
        ]
    }

    fn difference(got: Vec<Fact>, strict: Grade) -> String {
        let case = CaseEvent {
            expected: expected(),
            got,
            ..case("t::a", Verdict::Fail)
        };
        let (expected, got) = texts(&case, strict);
        diff::text(&expected, &got)
    }

    #[test]
    fn a_line_that_is_met_is_the_same_on_both_sides_where_codes_do_not_count() {
        let got = || {
            vec![
                told(6, "", "')' missing"),
                told(6, "", "';' missing"),
                told(7, "E037", "no"),
                told(9, "E048", "no such name"),
                told(0, "E1", "odd"),
            ]
        };
        let expected = "- line 4: error P4023\n  line 6: error P4001, told as ')' missing\n  \
                        line 6: error P4026, told as ')' missing\n+ line 7: error E037: no\n  \
                        line 9: error P4007, told as E048: no such name\n+ somewhere: error E1: odd\n";
        assert_eq!(difference(got(), Grade::Line), expected);
        assert_eq!(difference(got(), Grade::Rejected), expected);
        let by_code = difference(got(), Grade::Code);
        assert!(by_code.contains("\n- line 9: error P4007\n"), "{by_code}");
    }

    #[test]
    fn what_meets_nothing_is_compared_as_it_is() {
        let all_missing: String = expected().iter().map(|fact| format!("- {fact}\n")).collect();
        for got in [told(1, "", "m"), Fact::Accepted] {
            let expected = format!("{all_missing}+ {got}\n");
            assert_eq!(difference(vec![got], Grade::Line), expected);
        }
    }
}
