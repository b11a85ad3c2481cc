//! Oracle `parse`: reading, checking and rendering any source text keep their promises.

use super::spans::{check_spans, is_inside};
use super::words::{census, missing};
use super::{InputOutcome, Judged, OracleFailure, failed};
use stickler_reference::semantics;
use stickler_syntax::decoding::decode;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::SourceUnit;
use stickler_syntax::{parse, render};
use stickler_types::{Dialect, DialectName};

/// The dialect of a text that names none.
const DIALECT: DialectName = DialectName::IRONPLC_ED3;

/// The maximum number of bytes in the message of a diagnostic, however long the names in the text are.
const MAX_MESSAGE_LEN: usize = 1000;

/// The maximum number of bytes of a rendering for each byte of its text: a semicolon at the greatest depth comes with its
/// indent.
const MAX_GROWTH: usize = 1000;

/// The number of leading zeros in the census of a text from which on the checker reads the rendering too.
const CHECKED_AGAIN: u32 = 2;

/// Checks the promises of the reference for any source text. A first byte below 5 names the dialect; otherwise the bytes
/// are the text, and the dialect is `ironplc-ed3`.
///
/// 1. Every span of the tree and of every diagnostic, the checker's among them, lies in the text; every diagnostic has a message
///    of bounded length.
/// 2. A text that reads without an error is rendered; the rendering has the words of the text, reads without an error to a
///    tree that is equal, and rendering that changes nothing.
/// 3. The checker finds the same in the rendering as in the text; asked of one text in four, for the checker takes the most time
///    of all. The words of the text choose, so an input is always judged alike, and its next mutation is asked anew.
///
/// That memory and time stay bounded is seen by libFuzzer's limits and by those on the sizes here.
///
/// Basis: harness/README.md (parsing never fails and never panics); harness/engines/README.md (spans, `render`).
///
/// # Errors
/// Symptoms: `place`, `message`, `size`, `rendering:CODE`, `rendering:words`, `rendering:tree`, `rendering:changes`,
/// `rendering:check`.
pub(super) fn judge(data: &[u8]) -> Judged {
    let (name, bytes) = match data.split_first() {
        Some((first, rest)) if usize::from(*first) < DialectName::ALL.len() => {
            (DialectName::ALL[usize::from(*first)], rest)
        }
        _ => (DIALECT, data),
    };
    let (text, broken) = decode(bytes);
    check_text(&text, &broken, Dialect::of(name)).map_err(|failure| {
        let message = format!("in the dialect {name}: {}", failure.message);
        OracleFailure { message, ..failure }.of_program(text.as_ref())
    })?;
    Ok(InputOutcome::Checked)
}

fn check_text(text: &str, broken: &[SpannedDiagnostic], dialect: &Dialect) -> Judged<()> {
    let (unit, diagnostics) = parse(text, dialect);
    let (_, found) = semantics::check(&unit, text, &LineIndex::new(text), dialect);
    let all = || broken.iter().chain(&diagnostics).chain(&found);
    all().try_for_each(|diagnostic| check_diagnostic(diagnostic, text))?;
    check_spans(&unit, text, diagnostics.is_empty()).map_err(|wrong| OracleFailure::new("place", wrong))?;
    let rendered = render(&unit, text);
    if unit.expressions.len() > text.len() || rendered.len() > MAX_GROWTH * (text.len() + 1) {
        let sizes = (text.len(), unit.expressions.len(), rendered.len());
        let said = format!("bytes of the text, expressions of the tree, bytes of the rendering: {sizes:?}");
        return failed("size", said);
    }
    // Syntax that the dialect does not enable is not rendered either.
    let refused = |said: &SpannedDiagnostic| said.code.not_enabled();
    if !diagnostics.is_empty() || !broken.is_empty() || found.iter().any(refused) {
        return Ok(());
    }
    check_rendering(&unit, text, &rendered, &found, dialect)
}

fn check_rendering(
    unit: &SourceUnit<'_>,
    text: &str,
    rendered: &str,
    found: &[SpannedDiagnostic],
    dialect: &Dialect,
) -> Judged<()> {
    let failed = |symptom: &str, said: String| failed(symptom, format!("{said}\n{rendered}"));
    let nested = dialect.nested_comments;
    let words = census(text, nested);
    if words != census(rendered, nested) {
        let (lost, added) = (missing(text, rendered, nested), missing(rendered, text, nested));
        return failed(
            "rendering:words",
            format!("the rendering loses {lost:?} and adds {added:?}:"),
        );
    }
    let (again, complaints) = parse(rendered, dialect);
    if let Some(SpannedDiagnostic { code, message, .. }) = complaints.first() {
        let said = format!("the rendering is rejected with {}, {message}:", code.as_str());
        return failed(&format!("rendering:{}", code.as_str()), said);
    }
    if *unit != again {
        return failed(
            "rendering:tree",
            "the rendering reads to another tree:".to_owned(),
        );
    }
    let twice = render(&again, rendered);
    if twice != rendered {
        let said = format!("rendering the rendering gives\n{twice}\ninstead of");
        return failed("rendering:changes", said);
    }
    if words.leading_zeros() < CHECKED_AGAIN {
        return Ok(());
    }
    let (_, found_again) = semantics::check(&again, rendered, &LineIndex::new(rendered), dialect);
    let (before, after) = (codes(found), codes(&found_again));
    if before != after {
        let said = format!("the checker says {before:?} of the text and {after:?} of its rendering:");
        return failed("rendering:check", said);
    }
    Ok(())
}

/// Returns the codes of diagnostics without their places, which differ.
fn codes(found: &[SpannedDiagnostic]) -> Vec<&'static str> {
    let mut codes: Vec<_> = found.iter().map(|said| said.code.as_str()).collect();
    codes.sort_unstable();
    codes
}

fn check_diagnostic(diagnostic: &SpannedDiagnostic, text: &str) -> Judged<()> {
    let SpannedDiagnostic {
        code, span, message, ..
    } = diagnostic;
    if !is_inside(*span, text) {
        let said = format!(
            "{} at {}..{} does not lie in the text",
            code.as_str(),
            span.start,
            span.end
        );
        return failed("place", said);
    }
    if message.is_empty() || message.len() > MAX_MESSAGE_LEN {
        let said = format!("a message of {} bytes: {message}", message.len());
        return failed("message", said);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::judge;
    use crate::oracles::InputOutcome;

    #[test]
    fn a_program_with_everything_holds() {
        assert_eq!(judge(include_bytes!("everything.st")), Ok(InputOutcome::Checked));
    }

    #[test]
    fn bytes_that_are_no_text_hold() {
        for first in 0..=u8::MAX {
            assert_eq!(judge(&[first, 0xFF, b'P', 0]), Ok(InputOutcome::Checked));
        }
        assert_eq!(judge(b""), Ok(InputOutcome::Checked));
    }
}
