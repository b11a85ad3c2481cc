//! Compares expected diagnostics with actual ones, in one merge walk over two lists sorted by line and code.

use super::findings::Findings;
use crate::{Fact, Grade};
use std::cmp::Ordering;
use stickler_engines::{Diagnostic, Severity};
use stickler_suite::{Expectation, ExpectedDiagnostic};

/// The maximum number of unexpected diagnostics that are listed one by one; further ones are counted.
const MAX_UNEXPECTED: usize = 50;

/// A step of the merge walk.
enum MergeStep<'a> {
    /// A diagnostic that is expected and was given.
    Met(ExpectedDiagnostic),
    /// A diagnostic that was given and is not expected.
    Unexpected(&'a Diagnostic),
    /// A diagnostic that is expected and was not given.
    Missing,
}

/// The expected and the actual diagnostics side by side, by line and code.
pub(super) struct DiagnosticMatching<'a> {
    steps: Vec<MergeStep<'a>>,
    exact: bool,
    same_lines: bool,
}

/// Returns the expected diagnostics as facts, sorted by line and code.
pub(super) fn expected(diagnostics: &[ExpectedDiagnostic]) -> Vec<Fact> {
    sorted(diagnostics).into_iter().map(expected_fact).collect()
}

fn expected_fact(expected: ExpectedDiagnostic) -> Fact {
    fact(Diagnostic {
        line: Some(expected.line),
        severity: expected.code.severity(),
        code: Some(expected.code.as_str().to_owned()),
        ..Diagnostic::default()
    })
}

fn fact(diagnostic: Diagnostic) -> Fact {
    match diagnostic.severity {
        Severity::Error => Fact::Diagnostic(diagnostic),
        Severity::Warning => Fact::Warning(diagnostic),
    }
}

/// Matches two lists of diagnostics. Each expected diagnostic matches at most one actual one, and the other way round.
pub(super) fn matching<'a>(expected: &[ExpectedDiagnostic], got: &'a [Diagnostic]) -> DiagnosticMatching<'a> {
    let expected = sorted(expected);
    let mut got: Vec<&Diagnostic> = got.iter().collect();
    got.sort_by(|a, b| place(a).cmp(&place(b)));
    let same_lines = same_lines(&expected, &got);
    let (mut wanted, mut found) = (expected.iter().peekable(), got.into_iter().peekable());
    let mut steps = Vec::new();
    loop {
        let order = match (wanted.peek(), found.peek()) {
            (None, None) => break,
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (Some(wanted), Some(found)) => (Some(wanted.line), Some(wanted.code.as_str())).cmp(&place(found)),
        };
        let (wanted, found) = (
            (order != Ordering::Greater).then(|| wanted.next()).flatten(),
            (order != Ordering::Less).then(|| found.next()).flatten(),
        );
        match (wanted, found) {
            (Some(&wanted), Some(_)) => steps.push(MergeStep::Met(wanted)),
            (Some(_), None) => steps.push(MergeStep::Missing),
            (None, Some(found)) => steps.push(MergeStep::Unexpected(found)),
            (None, None) => break,
        }
    }
    let exact = steps.iter().all(|step| matches!(step, MergeStep::Met(_)));
    DiagnosticMatching {
        steps,
        exact,
        same_lines,
    }
}

/// Returns whether the actual facts of a rejection miss nothing of the expected ones but places or further mistakes: each expected
/// diagnostic came, or has a counterpart without a line, with the same code where `needed` asks for codes; or some of them came, and
/// nothing else; or, where lines are compared alone, later lines are said to be unreadable, too or instead.
#[must_use]
pub fn tells_too_little_only(expected: &[Fact], got: &[Fact], needed: Grade) -> bool {
    let diagnostics = |facts: &[Fact]| facts.iter().map(|fact| fact.diagnostic().cloned()).collect();
    let (Some(mut missing), Some(mut extra)): (Option<Vec<Diagnostic>>, Option<Vec<Diagnostic>>) =
        (diagnostics(expected), diagnostics(got))
    else {
        return false;
    };
    match needed {
        Grade::Code => missing.retain(|wanted| {
            let met = |reported: &Diagnostic| (reported.line, &reported.code) == (wanted.line, &wanted.code);
            let met = extra.iter().position(met);
            met.map(|at| extra.remove(at)).is_none()
        }),
        Grade::Line => {
            let lines: Vec<Option<u32>> = extra.iter().map(|reported| reported.line).collect();
            extra.retain(|reported| missing.iter().all(|wanted| wanted.line != reported.line));
            missing.retain(|wanted| !lines.contains(&wanted.line));
        }
        Grade::Rejected => return false,
    }
    let codes = |diagnostics: &[Diagnostic]| {
        let mut codes: Vec<Option<String>> = diagnostics.iter().map(|one| one.code.clone()).collect();
        codes.sort();
        codes
    };
    if extra.is_empty() {
        return !missing.is_empty() && missing.len() < expected.len();
    }
    let same_codes = needed == Grade::Line || codes(&missing) == codes(&extra);
    let has_no_place =
        !missing.is_empty() && same_codes && extra.iter().all(|reported| reported.line.is_none());
    has_no_place || needed == Grade::Line && are_late(expected, &extra)
}

/// Returns whether a diagnostic says that the program could not be read.
fn is_of_reading(diagnostic: &Diagnostic) -> bool {
    diagnostic
        .code
        .as_deref()
        .is_some_and(|code| code.starts_with("P0"))
}

/// Returns whether the mistakes are such that a program cannot be read, and the actual diagnostics name lines behind the first of them.
fn are_late(expected: &[Fact], extra: &[Diagnostic]) -> bool {
    let expected = || expected.iter().filter_map(Fact::diagnostic);
    let first = expected().filter_map(|wanted| wanted.line).min();
    expected().all(is_of_reading)
        && extra
            .iter()
            .all(|reported| is_of_reading(reported) && reported.line > first)
}

/// Returns whether a diagnostic names one of these lines, given in ascending order.
pub(super) fn any_on(lines: &[u32], diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| names(lines, diagnostic))
}

fn names(lines: &[u32], diagnostic: &Diagnostic) -> bool {
    let line = diagnostic.line;
    line.is_some_and(|line| lines.binary_search(&line).is_ok())
}

/// Compares the warnings of an engine that accepted the program: each expected one must have come, to the grade that is asked of
/// diagnostics, and none may name a clean line. Others say nothing about the case.
pub(super) fn warnings(
    expectation: &Expectation,
    given: &[Diagnostic],
    strict: Grade,
    findings: &mut Findings,
) {
    let meets = |expected: &ExpectedDiagnostic, reported: &Diagnostic| match strict {
        Grade::Code => place(reported) == (Some(expected.line), Some(expected.code.as_str())),
        Grade::Line => reported.line == Some(expected.line),
        Grade::Rejected => true,
    };
    let (met, missing): (Vec<_>, Vec<_>) = sorted(&expectation.warnings)
        .into_iter()
        .partition(|expected| given.iter().any(|reported| meets(expected, reported)));
    for expected in met {
        findings.add(expected_fact(expected));
    }
    findings.require(missing.is_empty());
    for reported in given {
        let on_clean_line = names(&expectation.clean_lines, reported);
        findings.require(!on_clean_line);
        if on_clean_line || !missing.is_empty() {
            findings.add(fact(reported.clone()));
        }
    }
}

impl DiagnosticMatching<'_> {
    /// Returns the grade of the rejection.
    pub(super) fn grade(&self) -> Grade {
        match (self.exact, self.same_lines) {
            (true, _) => Grade::Code,
            (false, true) => Grade::Line,
            (false, false) => Grade::Rejected,
        }
    }

    /// Adds the engine's diagnostics: a matched diagnostic as the expectation states it, any other with its message.
    pub(super) fn write(&self, findings: &mut Findings) {
        let mut unexpected = 0;
        for step in &self.steps {
            match step {
                MergeStep::Met(met) => findings.add(expected_fact(*met)),
                MergeStep::Unexpected(diagnostic) => {
                    unexpected += 1;
                    if unexpected <= MAX_UNEXPECTED {
                        findings.add(Fact::Diagnostic((*diagnostic).clone()));
                    }
                }
                MergeStep::Missing => {}
            }
        }
        if unexpected > MAX_UNEXPECTED {
            let number = unexpected - MAX_UNEXPECTED;
            findings.add(Fact::MoreDiagnostics { number });
        }
        if self.steps.iter().all(|step| matches!(step, MergeStep::Missing)) {
            findings.add(Fact::RejectedSilently);
        }
    }
}

fn sorted(expected: &[ExpectedDiagnostic]) -> Vec<ExpectedDiagnostic> {
    let mut expected = expected.to_vec();
    expected.sort_by_key(|diagnostic| (diagnostic.line, diagnostic.code.as_str()));
    expected
}

fn place(diagnostic: &Diagnostic) -> (Option<u32>, Option<&str>) {
    (diagnostic.line, diagnostic.code.as_deref())
}

/// Returns whether the actual diagnostics name exactly the expected lines, however often each.
fn same_lines(expected: &[ExpectedDiagnostic], got: &[&Diagnostic]) -> bool {
    let mut expected: Vec<Option<u32>> = expected.iter().map(|diagnostic| Some(diagnostic.line)).collect();
    let mut got: Vec<Option<u32>> = got.iter().map(|diagnostic| diagnostic.line).collect();
    expected.dedup();
    got.dedup();
    expected == got
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Code;

    fn expected_at(places: &[(u32, &str)]) -> Vec<ExpectedDiagnostic> {
        let diagnostic = |&(line, code): &(u32, &str)| {
            let code: Code = code.parse().unwrap();
            ExpectedDiagnostic { line, code }
        };
        places.iter().map(diagnostic).collect()
    }

    fn got_at(places: &[(u32, &str)]) -> Vec<Diagnostic> {
        let diagnostic = |&(line, code): &(u32, &str)| Diagnostic {
            code: (!code.is_empty()).then(|| code.to_owned()),
            line: (line > 0).then_some(line),
            message: "m".to_owned(),
            ..Diagnostic::default()
        };
        places.iter().map(diagnostic).collect()
    }

    fn walk(wanted: &[(u32, &str)], found: &[(u32, &str)]) -> (Grade, String) {
        let found = got_at(found);
        let matching = matching(&expected_at(wanted), &found);
        let mut findings = Findings::default();
        matching.write(&mut findings);
        (matching.grade(), Fact::text(&findings.finish().1))
    }

    #[test]
    fn the_same_places_in_any_order_are_right_to_the_code() {
        let (grade, got) = walk(&[(9, "P4035"), (6, "P4022")], &[(6, "P4022"), (9, "P4035")]);
        assert_eq!(
            (grade, got.as_str()),
            (Grade::Code, "line 6: error P4022\nline 9: error P4035")
        );
    }

    #[test]
    fn a_missing_an_unexpected_and_a_doubled_diagnostic_are_each_seen() {
        assert_eq!(
            walk(&[(6, "P4035"), (7, "P4035")], &[(6, "P4035")]).0,
            Grade::Rejected
        );
        let (grade, got) = walk(&[(6, "P4035")], &[(6, "P4035"), (8, "P2026")]);
        assert_eq!(
            (grade, got.as_str()),
            (Grade::Rejected, "line 6: error P4035\nline 8: error P2026: m")
        );
        assert_eq!(
            walk(&[(6, "P4035")], &[(6, "P4035"), (6, "P4035")]).0,
            Grade::Line
        );
        assert_eq!(
            walk(&[(6, "P4035"), (6, "P4035")], &[(6, "P4035")]).0,
            Grade::Line
        );
    }

    #[test]
    fn another_code_on_the_right_line_is_right_to_the_line() {
        assert_eq!(walk(&[(6, "P4035")], &[(6, "P4022")]).0, Grade::Line);
        assert_eq!(walk(&[(6, "P4035")], &[(6, "")]).0, Grade::Line);
    }

    #[test]
    fn a_wrong_or_unknown_line_is_only_a_rejection() {
        assert_eq!(walk(&[(6, "P4035")], &[(7, "P4035")]).0, Grade::Rejected);
        assert_eq!(walk(&[(6, "P4035")], &[(0, "P4035")]).0, Grade::Rejected);
        assert_eq!(
            walk(&[(6, "P4035")], &[]),
            (Grade::Rejected, "rejected, with no diagnostic".to_owned())
        );
    }

    #[test]
    fn a_parser_without_codes_that_names_later_lines_misses_a_rule_only() {
        let facts = |diagnostics: &[(u32, &str)]| -> Vec<Fact> {
            let all = diagnostics.iter().map(|&(line, code)| {
                Fact::Diagnostic(Diagnostic {
                    line: Some(line),
                    code: Some(code.to_owned()),
                    ..Diagnostic::default()
                })
            });
            all.collect()
        };
        let of = |expected: &[(u32, &str)], got: &[(u32, &str)], needed: Grade| {
            tells_too_little_only(&facts(expected), &facts(got), needed)
        };
        let unread = [(3, "P0002")];
        assert!(of(&unread, &[(4, "P0002"), (6, "P0002")], Grade::Line));
        assert!(of(&unread, &[(3, "P0002"), (6, "P0002")], Grade::Line));
        assert!(!of(&unread, &[(2, "P0002"), (6, "P0002")], Grade::Line));
        assert!(!of(&unread, &[(4, "P4035")], Grade::Line));
        assert!(!of(&[(3, "P4035")], &[(4, "P0002")], Grade::Line));
        assert!(!of(&unread, &[(4, "P0002")], Grade::Code));
    }

    #[test]
    fn clean_lines_are_found() {
        let found = got_at(&[(3, "P4035"), (0, "P4035")]);
        assert!(any_on(&[1, 3], &found));
        assert!(!any_on(&[1, 4], &found));
        assert!(!any_on(&[], &found));
    }

    #[test]
    fn a_flood_is_cut_and_counted() {
        let found: Vec<(u32, &str)> = (1..=70).map(|line| (line, "P0002")).collect();
        let (_, got) = walk(&[], &found);
        assert_eq!(got.lines().count(), MAX_UNEXPECTED + 1);
        assert!(got.ends_with("and 20 diagnostics more"), "{got}");
    }
}
