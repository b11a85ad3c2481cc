//! Bytes that may be no text.

use crate::diagnostic::{Diagnostics, SpannedDiagnostic};
use crate::source::{Span, saturating_u32};
use std::borrow::Cow;
use stickler_types::Code;

/// The message about bytes that are no text, and about the characters that stand for them: the same, so that one of two
/// that name the same place can be dropped.
pub(crate) const NO_TEXT: &str = "bytes that are no UTF-8 text";

/// Decodes a source text: a byte-order mark in front is dropped, and each place that is no UTF-8 becomes U+FFFD.
///
/// Gives the text, borrowed where nothing had to be replaced, and a P0003 for each such place, whose span
/// is that of the replacement characters in the text.
pub fn decode(bytes: &[u8]) -> (Cow<'_, str>, Vec<SpannedDiagnostic>) {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return (Cow::Borrowed(text), Vec::new());
    }
    let mut text = String::with_capacity(bytes.len());
    let mut diagnostics = Diagnostics::default();
    let mut broken: Option<Span> = None;
    for chunk in bytes.utf8_chunks() {
        if !chunk.valid().is_empty() {
            report_broken(&mut diagnostics, broken.take());
            text.push_str(chunk.valid());
        }
        if !chunk.invalid().is_empty() {
            let start = saturating_u32(text.len());
            text.push(char::REPLACEMENT_CHARACTER);
            let place = Span::new(start, saturating_u32(text.len()));
            broken = Some(broken.map_or(place, |before| before.to(place)));
        }
    }
    report_broken(&mut diagnostics, broken);
    (Cow::Owned(text), diagnostics.into_list())
}

fn report_broken(diagnostics: &mut Diagnostics, place: Option<Span>) {
    if let Some(span) = place {
        diagnostics.report(Code::UnexpectedToken, span, || NO_TEXT.to_owned());
    }
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[test]
    fn a_byte_order_mark_is_dropped() {
        let (text, diagnostics) = decode(b"\xEF\xBB\xBFPROGRAM");
        assert_eq!((text.as_ref(), diagnostics.len()), ("PROGRAM", 0));
    }

    #[test]
    fn each_place_that_is_no_text_is_reported_once() {
        let (text, diagnostics) = decode(b"a\xFF\xFEb\xC3");
        assert_eq!(text, "a\u{FFFD}\u{FFFD}b\u{FFFD}");
        let spans: Vec<_> = diagnostics.iter().map(|d| d.span.text(&text)).collect();
        assert_eq!(spans, ["\u{FFFD}\u{FFFD}", "\u{FFFD}"]);
    }
}
