//! The symptom of a rejection that is not the expected one.

use super::{Symptom, reason};
use crate::Grade;
use stickler_types::Diagnostic;

/// Returns the symptom of an expected rejection, by those parts of the diagnostics that were compared.
pub(super) fn rejection(expected: &[&Diagnostic], got: &[&Diagnostic], strict: Grade) -> Symptom {
    let (missing, extra) = unmet(expected, got, strict);
    // Where lines are compared alone, what is told of a line beside its mistake has another code.
    let is_expected = |one: &&&Diagnostic| expected.iter().any(|wanted| wanted.code == one.code);
    let beside = || got.iter().find(|one| !is_expected(one));
    let reported = extra.first().or_else(beside);
    let reported = reported.map(|first| reason(first)).unwrap_or_default();
    // Where lines are not compared, only a diagnostic on a line without a mistake is wrong.
    let Some(first) = missing.first().filter(|_| strict != Grade::Rejected) else {
        return Symptom::Surplus(reported);
    };
    let code = reason(first);
    let nothing_met = missing.len() == expected.len() && !extra.is_empty();
    match strict {
        Grade::Code => match extra.iter().find(|reported| reported.code == first.code) {
            Some(same) if has_no_place(same) => Symptom::NoPlace(code),
            Some(_) => Symptom::OtherLine(code),
            // What is told is another of the mistakes, on another line.
            None if extra
                .iter()
                .all(|reported| missing.iter().any(|one| one.code == reported.code)) =>
            {
                Symptom::Incomplete(code)
            }
            None if nothing_met || extra.iter().any(|reported| reported.line == first.line) => {
                Symptom::OtherCode { code, reported }
            }
            None => Symptom::Incomplete(code),
        },
        Grade::Line | Grade::Rejected if nothing_met => {
            match extra.iter().all(|reported| has_no_place(reported)) {
                true => Symptom::NoPlace(reported),
                false => Symptom::OtherLine(code),
            }
        }
        _ => Symptom::Incomplete(code),
    }
}

/// Returns whether a diagnostic does not tell where the mistake is. Line 1, column 1 is what a compiler says that has lost the
/// place; where the mistake really stands there, the diagnostic is the expected one.
fn has_no_place(reported: &Diagnostic) -> bool {
    reported.line.is_none() || (reported.line, reported.column) == (Some(1), Some(1))
}

/// Returns the expected diagnostics that did not come, and the actual ones that are not expected. Where codes are compared,
/// each diagnostic counts; otherwise any diagnostic on a line meets all on that line.
fn unmet<'t>(
    expected: &[&'t Diagnostic],
    got: &[&'t Diagnostic],
    strict: Grade,
) -> (Vec<&'t Diagnostic>, Vec<&'t Diagnostic>) {
    let on_line_of_any =
        |among: &[&Diagnostic], one: &Diagnostic| among.iter().any(|other| other.line == one.line);
    if strict != Grade::Code {
        let missing = expected.iter().filter(|wanted| !on_line_of_any(got, wanted));
        let extra = got.iter().filter(|reported| !on_line_of_any(expected, reported));
        return (missing.copied().collect(), extra.copied().collect());
    }
    let mut extra = got.to_vec();
    let mut missing = expected.to_vec();
    missing.retain(|wanted| {
        let same = |reported: &&Diagnostic| (reported.line, &reported.code) == (wanted.line, &wanted.code);
        let met = extra.iter().position(same);
        met.map(|at| extra.remove(at)).is_none()
    });
    (missing, extra)
}
