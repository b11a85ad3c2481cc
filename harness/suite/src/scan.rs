//! Finds the marks of a program: comments that begin with `(*!`.
//!
//! The scanner is the suite's own and knows only strings and comments, so that a mark means the same whatever a dialect makes
//! of the rest. Strings end at the latest with their line, as the standard has them; so a stray quote hides one line at most.
//! Basis: conformance-cases/README.md (marks).

/// A mark as it stands in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RawMark<'t> {
    /// The byte offset of `(*!`.
    pub(crate) start: usize,
    /// The text between `(*!` and `*)`.
    pub(crate) text: &'t str,
    /// The 1-based line on which the mark opens.
    pub(crate) line: u32,
}

impl RawMark<'_> {
    /// Returns the byte offset of the text after `(*!`.
    pub(crate) fn text_start(&self) -> usize {
        self.start + "(*!".len()
    }

    /// Returns the byte offset behind the mark.
    pub(crate) fn end(&self) -> usize {
        self.text_start() + self.text.len() + "*)".len()
    }
}

/// The marks of a text, and the places that look like marks.
#[derive(Debug, Default)]
pub(crate) struct Scan<'t> {
    /// The marks, in order.
    pub(crate) marks: Vec<RawMark<'t>>,
    /// The lines on which `(*!` stands inside a string or another comment, where it is not a mark.
    pub(crate) hidden: Vec<u32>,
    /// The line of a mark that is never closed.
    pub(crate) unclosed: Option<u32>,
}

/// Finds the marks in `text`. O(n).
pub(crate) fn scan(text: &str) -> Scan<'_> {
    let mut scanner = Scanner {
        text,
        at: 0,
        line: 1,
        found: Scan::default(),
    };
    while let Some(&byte) = text.as_bytes().get(scanner.at) {
        match byte {
            b'\'' | b'"' => scanner.string(byte),
            b'(' if text.as_bytes().get(scanner.at + 1) == Some(&b'*') => scanner.comment(),
            _ => scanner.step(),
        }
    }
    scanner.found
}

struct Scanner<'t> {
    text: &'t str,
    at: usize,
    line: u32,
    found: Scan<'t>,
}

impl<'t> Scanner<'t> {
    fn step(&mut self) {
        if self.text.as_bytes()[self.at] == b'\n' {
            self.line += 1;
        }
        self.at += 1;
    }

    fn string(&mut self, quote: u8) {
        let start = self.at;
        let bytes = self.text.as_bytes();
        self.at += 1;
        while let Some(&byte) = bytes.get(self.at) {
            match byte {
                b'\n' => break,
                b'$' if bytes.get(self.at + 1).is_some_and(|&next| next != b'\n') => self.at += 2,
                _ if byte == quote => {
                    self.at += 1;
                    break;
                }
                _ => self.at += 1,
            }
        }
        self.note_hidden(start, self.at.min(bytes.len()));
    }

    fn comment(&mut self) {
        let start = self.at;
        let inside = start + "(*".len();
        let is_mark = self.text.as_bytes().get(inside) == Some(&b'!');
        let close = find(self.text, "*)", inside);
        let end = close.map_or(self.text.len(), |close| close + "*)".len());
        match close {
            Some(close) if is_mark => {
                let text = &self.text[inside + 1..close];
                self.found.marks.push(RawMark {
                    start,
                    text,
                    line: self.line,
                });
            }
            None if is_mark => self.found.unclosed = Some(self.line),
            _ => self.note_hidden(inside, end),
        }
        while self.at < end {
            self.step();
        }
    }

    /// Records the lines of marks between two offsets, where they have no effect.
    fn note_hidden(&mut self, start: usize, end: usize) {
        let bytes = &self.text.as_bytes()[start..end];
        let mut line = self.line;
        for (at, &byte) in bytes.iter().enumerate() {
            line += u32::from(byte == b'\n');
            if bytes[at..].starts_with(b"(*!") {
                self.found.hidden.push(line);
            }
        }
    }
}

fn find(text: &str, pattern: &str, from: usize) -> Option<usize> {
    text.get(from..)?.find(pattern).map(|at| at + from)
}
