//! Source text: spans in bytes, and the line and column that a person counts.

/// The longest source text that is read, in bytes; a longer one is diagnosed with S0002.
///
/// Basis: harness/README.md (depth, size and step limits turn hostile input into a diagnostic).
pub const MAX_LENGTH: usize = 64 << 20;

/// A half-open range of bytes in a source text. Texts are limited to 64 MiB, so 32 bits suffice.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Span {
    /// The first byte.
    pub start: u32,
    /// The byte after the last.
    pub end: u32,
}

impl Span {
    /// Creates the span from a byte to the one before `end`.
    pub const fn new(start: u32, end: u32) -> Span {
        Span { start, end }
    }

    /// The span from the start of `self` to the end of `other`.
    pub const fn to(self, other: Span) -> Span {
        Span::new(self.start, other.end)
    }

    /// The text that the span covers; empty where the span does not fit `text`.
    pub fn text(self, text: &str) -> &str {
        text.get(self.start as usize..self.end as usize).unwrap_or("")
    }

    /// The span of no bytes at the end of `self`.
    pub const fn after(self) -> Span {
        Span::new(self.end, self.end)
    }
}

impl From<Span> for std::ops::Range<usize> {
    fn from(span: Span) -> std::ops::Range<usize> {
        span.start as usize..span.end as usize
    }
}

/// A line and a column as a person counts them: both from 1, columns in Unicode scalar values.
///
/// Basis: harness/engines/README.md (lines and columns).
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
    pub fn new(text: &str) -> LineIndex {
        let bytes = text.as_bytes();
        let mut line_starts = Vec::with_capacity(bytes.len() / BYTES_A_LINE + 1);
        line_starts.push(0);
        line_starts.extend(memchr::memchr_iter(b'\n', bytes).map(|end| saturating_u32(end + 1)));
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
    pub fn position(&self, text: &str, byte: u32) -> Position {
        let byte = byte.min(saturating_u32(text.len()));
        let line = self.line(byte) as usize;
        let start = line
            .checked_sub(1)
            .and_then(|line| self.line_starts.get(line))
            .copied()
            .unwrap_or(0);
        let column = self.characters_before(text, byte) - self.characters_before(text, start);
        Position {
            line: saturating_u32(line),
            column: column + 1,
        }
    }

    /// The line of a byte, counted from 1; for who needs no column, which takes longer to find.
    pub fn line(&self, byte: u32) -> u32 {
        saturating_u32(self.line_starts.partition_point(|start| *start <= byte))
    }

    /// The number of lines; a text that ends with a line feed has an empty last line.
    pub fn lines(&self) -> u32 {
        saturating_u32(self.line_starts.len())
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
    saturating_u32(bytes.iter().filter(|byte| **byte & 0xC0 != 0x80).count())
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

/// Returns a length of a source text as 32 bits, which hold all that are read.
pub fn saturating_u32(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(text: &str, byte: usize) -> (u32, u32) {
        let index = LineIndex::new(text);
        let Position { line, column } = index.position(text, saturating_u32(byte));
        assert_eq!(line, index.line(saturating_u32(byte)));
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
            assert_eq!(position(&text, text.len()), (2, saturating_u32(length + 1)));
            assert_eq!(position(&text, text.len() - 2), (2, saturating_u32(length)));
        }
    }
}
