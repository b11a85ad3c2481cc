//! Source text: spans in bytes, the line and column that a person counts, and bytes that may be no text.

use crate::diagnostic::{Diagnostic, Diagnostics};
use std::borrow::Cow;
use stickler_types::Code;

/// The longest source text that is read, in bytes; a longer one is diagnosed with S0002.
///
/// Basis: a decision of the design (depth, size and step limits turn hostile input into a diagnostic).
pub const MAXIMUM_LENGTH: usize = 64 << 20;

/// A half-open range of bytes in a source text. Texts are limited to 64 MiB, so 32 bits suffice.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Span {
    /// The first byte.
    pub start: u32,
    /// The byte after the last.
    pub end: u32,
}

impl Span {
    /// The span from the start of `self` to the end of `other`.
    #[must_use]
    pub const fn to(self, other: Span) -> Span {
        Span {
            start: self.start,
            end: other.end,
        }
    }

    /// The text that the span covers; empty where the span does not fit `text`.
    #[must_use]
    pub fn text(self, text: &str) -> &str {
        text.get(self.start as usize..self.end as usize).unwrap_or("")
    }

    /// The span of no bytes at the end of `self`.
    #[must_use]
    pub const fn after(self) -> Span {
        Span {
            start: self.end,
            end: self.end,
        }
    }
}

/// A line and a column as a person counts them: both from 1, columns in Unicode scalar values.
///
/// Basis: section 4 of the design.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Position {
    /// The line, counted from 1. A line ends with a line feed; a carriage return before it belongs to it.
    pub line: u32,
    /// The column, counted from 1 in Unicode scalar values.
    pub column: u32,
}

/// A line of an ordinary text has at least about so many bytes.
const BYTES_A_LINE: usize = 16;

/// Between two checkpoints of a text that is not ASCII lie this many bytes.
const STRIDE: usize = 256;

/// Finds line and column of a byte in O(log lines), however long the lines are.
#[derive(Clone, Debug)]
pub struct LineIndex {
    line_starts: Vec<u32>,
    /// The number of scalar values before each multiple of [`STRIDE`] bytes; empty for ASCII.
    checkpoints: Vec<u32>,
}

impl LineIndex {
    /// The index of `text`, which is read once.
    #[must_use]
    pub fn new(text: &str) -> LineIndex {
        let bytes = text.as_bytes();
        let mut line_starts = Vec::with_capacity(bytes.len() / BYTES_A_LINE + 1);
        line_starts.push(0);
        line_starts.extend(text.match_indices('\n').map(|(end, _)| narrow(end + 1)));
        let checkpoints = if text.is_ascii() {
            Vec::new()
        } else {
            checkpoints(bytes)
        };
        LineIndex {
            line_starts,
            checkpoints,
        }
    }

    /// The position of byte `byte` of `text`, the text that this index was made for. A byte behind the end
    /// stands for the end.
    #[must_use]
    pub fn position(&self, text: &str, byte: u32) -> Position {
        let byte = byte.min(narrow(text.len()));
        let line = self.line(byte) as usize;
        let start = line
            .checked_sub(1)
            .and_then(|line| self.line_starts.get(line))
            .copied()
            .unwrap_or(0);
        let column = self.characters_before(text, byte) - self.characters_before(text, start);
        Position {
            line: narrow(line),
            column: column + 1,
        }
    }

    /// The line of a byte, counted from 1; for who needs no column, which takes longer to find.
    #[must_use]
    pub fn line(&self, byte: u32) -> u32 {
        narrow(self.line_starts.partition_point(|start| *start <= byte))
    }

    /// The number of lines; a text that ends with a line feed has an empty last line.
    #[must_use]
    pub fn lines(&self) -> u32 {
        narrow(self.line_starts.len())
    }

    fn characters_before(&self, text: &str, byte: u32) -> u32 {
        let Some(before) = self.checkpoints.get(byte as usize / STRIDE) else {
            return byte;
        };
        let from = byte as usize / STRIDE * STRIDE;
        before + characters(text.as_bytes().get(from..byte as usize).unwrap_or(&[]))
    }
}

/// The number of scalar values that begin in `bytes`.
fn characters(bytes: &[u8]) -> u32 {
    narrow(bytes.iter().filter(|byte| **byte & 0xC0 != 0x80).count())
}

fn checkpoints(bytes: &[u8]) -> Vec<u32> {
    let mut before = 0;
    let count = |chunk| {
        let here = before;
        before += characters(chunk);
        here
    };
    // One more chunk, so that the end of a text whose length is a multiple of the stride has its own.
    bytes
        .chunks(STRIDE)
        .chain(std::iter::once(&[][..]))
        .map(count)
        .collect()
}

fn narrow(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}

/// What is said of bytes that were no text, and of the characters that stand for them: the same, so that who
/// hears it twice of one place can drop one.
pub(crate) const NO_TEXT: &str = "bytes that are no UTF-8 text";

/// Makes text of bytes: a byte-order mark in front is dropped, and each place that is no UTF-8 becomes U+FFFD.
///
/// Gives the text, borrowed where nothing had to be replaced, and a P0003 for each such place, whose span
/// is that of the replacement characters in the text.
#[must_use]
pub fn decode(bytes: &[u8]) -> (Cow<'_, str>, Vec<Diagnostic>) {
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
            let start = narrow(text.len());
            text.push(char::REPLACEMENT_CHARACTER);
            let place = Span {
                start,
                end: narrow(text.len()),
            };
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
    use super::*;

    fn position(text: &str, byte: usize) -> (u32, u32) {
        let index = LineIndex::new(text);
        let Position { line, column } = index.position(text, narrow(byte));
        assert_eq!(line, index.line(narrow(byte)));
        (line, column)
    }

    #[test]
    fn lines_and_columns_count_from_one() {
        let text = "ab\r\ncd\n";
        assert_eq!(position(text, 0), (1, 1));
        assert_eq!(position(text, 1), (1, 2));
        assert_eq!(position(text, 4), (2, 1));
        assert_eq!(position(text, 7), (3, 1));
        assert_eq!(position(text, 99), (3, 1));
        assert_eq!(position("", 0), (1, 1));
    }

    #[test]
    fn columns_count_scalar_values() {
        let text = "(* ä€😀 *) x";
        assert_eq!(position(text, text.len() - 1), (1, 11));
    }

    #[test]
    fn columns_of_a_long_line_agree_with_counting() {
        for length in [STRIDE - 1, STRIDE, STRIDE + 1, 5 * STRIDE] {
            let text = format!("\n{}", "é".repeat(length));
            assert_eq!(position(&text, text.len()), (2, narrow(length + 1)));
            assert_eq!(position(&text, text.len() - 2), (2, narrow(length)));
        }
    }

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
