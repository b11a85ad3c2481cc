//! Compares expected diagnostics with actual ones, in one merge walk over two lists sorted by line and code.

use super::Findings;
use crate::{Fact, Grade};
use std::cmp::Ordering;
use stickler_engines::{Diagnostic, Severity};
use stickler_suite::{Expectation, ExpectedDiagnostic};

/// The maximum number of unexpected diagnostics that are listed one by one; further ones are counted.
const MAX_UNEXPECTED: usize = 50;

/// A step of the merge walk: a diagnostic that is expected, one that was given, or both, where the same was expected and given.
type MergeStep<'a> = (Option<ExpectedDiagnostic>, Option<&'a Diagnostic>);

/// The expected and the actual diagnostics side by side, by line and code.
pub(super) struct DiagnosticMatching<'a> {
    steps: Vec<MergeStep<'a>>,
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
    let (mut wanted, mut found) = (expected.into_iter().peekable(), got.into_iter().peekable());
    let mut steps: Vec<MergeStep<'_>> = Vec::new();
    loop {
        let order = match (wanted.peek(), found.peek()) {
            (None, None) => break,
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (Some(wanted), Some(found)) => (Some(wanted.line), Some(wanted.code.as_str())).cmp(&place(found)),
        };
        let wanted = wanted.next_if(|_| order != Ordering::Greater);
        steps.push((wanted, found.next_if(|_| order != Ordering::Less)));
    }
    DiagnosticMatching { steps, same_lines }
}

/// Returns whether the actual facts of a rejection are those that were expected but for places, further mistakes, or more that is said of
/// the lines with a mistake: each expected diagnostic came, or has a counterpart without a line, with the same code where `needed` asks for
/// codes; or some of them came, and nothing else; or, where lines are compared alone, later lines are said to be unreadable, too or instead.
pub fn tells_otherwise_only(expected: &[Fact], got: &[Fact], needed: Grade) -> bool {
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
    let is_on =
        |one: &Diagnostic, fact: &Fact| fact.diagnostic().is_some_and(|wanted| wanted.line == one.line);
    if missing.is_empty()
        && extra
            .iter()
            .all(|one| expected.iter().any(|fact| is_on(one, fact)))
    {
        return true;
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
        // What only warns of a mistake is told with it.
        let mut mistakes = expectation.diagnostics.iter();
        let of_mistake = mistakes.any(|mistake| reported.line == Some(mistake.line));
        if on_clean_line || of_mistake || !missing.is_empty() {
            findings.add(fact(reported.clone()));
        }
    }
}

impl DiagnosticMatching<'_> {
    /// Returns the grade of the rejection.
    pub(super) fn grade(&self) -> Grade {
        let exact = self.steps.iter().all(|step| matches!(step, (Some(_), Some(_))));
        match (exact, self.same_lines) {
            (true, _) => Grade::Code,
            (false, true) => Grade::Line,
            (false, false) => Grade::Rejected,
        }
    }

    /// Adds the engine's diagnostics: a matched diagnostic as the expectation states it, any other with its message.
    pub(super) fn write(&self, findings: &mut Findings) {
        let (mut given, mut unexpected) = (false, 0);
        for (wanted, found) in &self.steps {
            let Some(found) = found else { continue };
            given = true;
            if let Some(met) = wanted {
                findings.add(expected_fact(*met));
                continue;
            }
            unexpected += 1;
            if unexpected <= MAX_UNEXPECTED {
                findings.add(Fact::Diagnostic((*found).clone()));
            }
        }
        if unexpected > MAX_UNEXPECTED {
            let number = unexpected - MAX_UNEXPECTED;
            findings.add(Fact::MoreDiagnostics { number });
        }
        if !given {
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

    #[test]
    fn a_flood_is_cut_and_counted() {
        let diagnostic = |line| Diagnostic {
            line: Some(line),
            ..Diagnostic::default()
        };
        let given: Vec<Diagnostic> = (1..=70).map(diagnostic).collect();
        let mut findings = Findings::default();
        matching(&[], &given).write(&mut findings);
        let got = findings.finish().1;
        assert_eq!(got.len(), MAX_UNEXPECTED + 1);
        assert_eq!(got.last(), Some(&Fact::MoreDiagnostics { number: 20 }));
    }
}
