//! Oracle `parse`: any bytes are a source text, and reading, checking and rendering one keep what they promise.

use super::tree::{hold_places, is_inside, shape};
use super::words::{census, missing};
use super::{Failure, Tried};
use stickler_reference::diagnostic::Diagnostic;
use stickler_reference::dialect::Dialect;
use stickler_reference::source::decode;
use stickler_reference::syntax::{parse, render};
use stickler_reference::{LocatedDiagnostic, check, check_bytes};
use stickler_types::DialectName;

/// The dialect of a text that names none.
const DIALECT: DialectName = DialectName::IronplcEd3;

/// The most bytes that a diagnostic's message has, however long the names in the text are.
const LONGEST_MESSAGE: usize = 1000;

/// The most bytes of a rendering for each byte of its text: a semicolon at the greatest depth comes with its indent.
const GROWTH: usize = 1000;

/// Holds against a text what the reference promises of every text. A first byte below 5 names the dialect; otherwise the bytes
/// are the text, and the dialect is `ironplc-ed3`.
///
/// 1. Every span of the tree and of every diagnostic lies in the text; every diagnostic has a message of bounded length.
/// 2. A text that reads without an error is rendered; the rendering has the words of the text, reads without an error to a
///    tree of the same shape, and rendering that changes nothing.
/// 3. The checker finds the same in the rendering as in the text.
///
/// That memory and time stay bounded is seen by libFuzzer's limits and by those on the sizes here.
///
/// Basis: stickler-design: §2 (parsing never fails and never panics), §4 (spans, `render`).
///
/// # Errors
/// Symptoms: `place`, `message`, `order`, `size`, `rendering:CODE`, `rendering:words`, `rendering:tree`, `rendering:changes`,
/// `rendering:check`.
pub(super) fn judge(data: &[u8]) -> Result<Tried, Failure> {
    let (name, bytes) = match data.split_first() {
        Some((first, rest)) if usize::from(*first) < DialectName::ALL.len() => {
            (DialectName::ALL[usize::from(*first)], rest)
        }
        _ => (DIALECT, data),
    };
    let (text, broken) = decode(bytes);
    hold_text(&text, &broken, name).map_err(|failure| {
        let message = format!("in the dialect {name}: {}", failure.message);
        Failure { message, ..failure }.of_program(text.as_ref())
    })?;
    let (_, found) = check_bytes(bytes, name);
    hold_located(&found, &text).map_err(|failure| failure.of_program(text.as_ref()))?;
    Ok(Tried::Done)
}

fn hold_text(text: &str, broken: &[Diagnostic], name: DialectName) -> Result<(), Failure> {
    let dialect = Dialect::of(name);
    let (unit, diagnostics) = parse(text, &dialect);
    broken
        .iter()
        .chain(&diagnostics)
        .try_for_each(|diagnostic| hold_diagnostic(diagnostic, text))?;
    hold_places(&unit, text, diagnostics.is_empty()).map_err(|wrong| Failure::new("place", wrong))?;
    if unit.expressions.len() > text.len() {
        return Err(Failure::new(
            "size",
            "the tree has more expressions than the text has bytes",
        ));
    }
    let rendered = render(&unit, text);
    if rendered.len() > GROWTH * (text.len() + 1) {
        return Err(Failure::new(
            "size",
            format!("the rendering has {} bytes", rendered.len()),
        ));
    }
    if !diagnostics.is_empty() || !broken.is_empty() {
        return Ok(());
    }
    let nested = dialect.nested_comments;
    if census(text, nested) != census(&rendered, nested) {
        return Err(other_words(text, &rendered, nested));
    }
    let (again, complaints) = parse(&rendered, &dialect);
    if let Some(Diagnostic { code, message, .. }) = complaints.first() {
        let said = format!(
            "the rendering is rejected with {}, {message}:\n{rendered}",
            code.as_str()
        );
        return Err(Failure::new(format!("rendering:{}", code.as_str()), said));
    }
    if shape(&unit) != shape(&again) {
        let said = format!("the rendering reads to another tree:\n{rendered}");
        return Err(Failure::new("rendering:tree", said));
    }
    let twice = render(&again, &rendered);
    if twice != rendered {
        let said = format!("rendering the rendering\n{rendered}\nchanges it to\n{twice}");
        return Err(Failure::new("rendering:changes", said));
    }
    hold_meaning(text, &rendered, name)
}

fn hold_diagnostic(diagnostic: &Diagnostic, text: &str) -> Result<(), Failure> {
    let Diagnostic {
        code, span, message, ..
    } = diagnostic;
    if !is_inside(*span, text) {
        let said = format!(
            "{} at {}..{} does not lie in the text",
            code.as_str(),
            span.start,
            span.end
        );
        return Err(Failure::new("place", said));
    }
    hold_message(message)
}

fn hold_message(message: &str) -> Result<(), Failure> {
    if message.is_empty() || message.len() > LONGEST_MESSAGE {
        let said = format!("a message of {} bytes: {message}", message.len());
        return Err(Failure::new("message", said));
    }
    Ok(())
}

fn other_words(text: &str, rendered: &str, nested: bool) -> Failure {
    let lost = missing(text, rendered, nested);
    let added = missing(rendered, text, nested);
    Failure::new(
        "rendering:words",
        format!("the rendering loses {lost:?} and adds {added:?}:\n{rendered}"),
    )
}

/// What is wrong with names and types must be wrong in the rendering too, though perhaps on other lines.
fn hold_meaning(text: &str, rendered: &str, name: DialectName) -> Result<(), Failure> {
    let [before, after] = [text, rendered].map(|text| {
        let mut codes: Vec<_> = check(text, name)
            .into_iter()
            .map(|said| said.code.as_str())
            .collect();
        codes.sort_unstable();
        codes
    });
    // What one code hides at one place may come out when the lines are others; that some are left is all that can be held.
    if before == after {
        return Ok(());
    }
    let said = format!("the checker says {before:?} of the text and {after:?} of its rendering\n{rendered}");
    Err(Failure::new("rendering:check", said))
}

/// What a person is shown: sorted, in the text, with a message.
fn hold_located(found: &[LocatedDiagnostic], text: &str) -> Result<(), Failure> {
    let lines = text.bytes().filter(|byte| *byte == b'\n').count() + 1;
    for said in found {
        hold_message(&said.message)?;
        let (start, end) = ((said.line, said.column), (said.end_line, said.end_column));
        if start.0 == 0 || start.1 == 0 || end < start || end.0 as usize > lines {
            let message = format!(
                "{} from {start:?} to {end:?} does not lie in {lines} lines",
                said.code.as_str()
            );
            return Err(Failure::new("place", message));
        }
    }
    let order = |said: &LocatedDiagnostic| (said.line, said.column, said.code.as_str());
    if found.is_sorted_by_key(order) {
        Ok(())
    } else {
        Err(Failure::new(
            "order",
            format!("the diagnostics are not in order: {found:?}"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::judge;
    use crate::oracles::Tried;

    #[test]
    fn a_program_with_everything_holds() {
        let text = "TYPE Color : (Red, Green := 5); Rec : STRUCT a, b : INT := 3; END_STRUCT; END_TYPE
            FUNCTION F : INT VAR_INPUT x : INT; END_VAR f := X * 2; END_FUNCTION
            PROGRAM main VAR r : REC; c : color := RED; b : BYTE := 16#8_0; t : STRING(5) := 'it$'s'; END_VAR
            IF r.A > 5 & TRUE THEN r.b := f(x := r.a); ELSE b.%X007 := FALSE; END_IF (* no semicolon *)
            END_PROGRAM";
        assert_eq!(judge(text.as_bytes()), Ok(Tried::Done));
    }

    #[test]
    fn bytes_that_are_no_text_hold() {
        for first in 0..=u8::MAX {
            assert_eq!(judge(&[first, 0xFF, b'P', 0]), Ok(Tried::Done));
        }
        assert_eq!(judge(b""), Ok(Tried::Done));
    }
}
