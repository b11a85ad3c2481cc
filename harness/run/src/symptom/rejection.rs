//! The symptom of a rejection that is not the expected one.

use super::{Symptom, reason};
use crate::Grade;
use stickler_types::Diagnostic;

/// Returns the symptom of an expected rejection, by those parts of the diagnostics that were compared.
pub(super) fn rejection(expected: &[&Diagnostic], got: &[&Diagnostic], strict: Grade) -> Symptom {
    let (missing, extra) = unmet(expected, got, strict);
    let told = extra.first().map(|first| reason(first)).unwrap_or_default();
    // Where lines are not compared, only a diagnostic on a line without a mistake is wrong.
    let Some(first) = missing.first().filter(|_| strict != Grade::Rejected) else {
        return Symptom::Surplus(told);
    };
    let code = reason(first);
    let nothing_met = missing.len() == expected.len() && !extra.is_empty();
    match strict {
        Grade::Code => match extra.iter().find(|told| told.code == first.code) {
            Some(same) if has_no_place(same) => Symptom::NoPlace(code),
            Some(_) => Symptom::OtherLine(code),
            None if nothing_met || extra.iter().any(|told| told.line == first.line) => {
                Symptom::OtherCode { code, told }
            }
            None => Symptom::Incomplete(code),
        },
        Grade::Line | Grade::Rejected if nothing_met => match extra.iter().all(|told| has_no_place(told)) {
            true => Symptom::NoPlace(told),
            false => Symptom::OtherLine(code),
        },
        _ => Symptom::Incomplete(code),
    }
}

/// Returns whether a diagnostic does not tell where the mistake is. Line 1, column 1 is what a compiler says that has lost the
/// place; where the mistake really stands there, the diagnostic is the expected one.
fn has_no_place(told: &Diagnostic) -> bool {
    told.line.is_none() || (told.line, told.column) == (Some(1), Some(1))
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
        let extra = got.iter().filter(|told| !on_line_of_any(expected, told));
        return (missing.copied().collect(), extra.copied().collect());
    }
    let mut extra = got.to_vec();
    let mut missing = expected.to_vec();
    missing.retain(|wanted| {
        let same = |told: &&Diagnostic| (told.line, &told.code) == (wanted.line, &wanted.code);
        let met = extra.iter().position(same);
        met.map(|at| extra.remove(at)).is_none()
    });
    (missing, extra)
}
