//! Literals, and words with a prefix.

use super::Name;
use crate::source::Span;

/// A word with another before its `#` or point. It is kept as one piece of the source, for expressions are many and must
/// be small.
#[derive(Clone, Copy, Debug)]
pub struct Prefixed<'s> {
    written: &'s str,
    start: u32,
    /// The length of what stands before the `#` or point.
    prefix: u32,
}

impl<'s> Prefixed<'s> {
    /// Takes the word that is written as `written` and begins at byte `start`; without a `#` or point all of it is the prefix, which
    /// namespaces may qualify.
    pub(crate) fn new(written: &'s str, start: u32) -> Prefixed<'s> {
        let prefix = written.rfind(['#', '.']).unwrap_or(written.len()) as u32;
        Prefixed {
            written,
            start,
            prefix,
        }
    }

    /// Returns the word before the `#` or point: `COLOR` of `COLOR#RED`.
    pub fn prefix(&self) -> Name<'s> {
        self.piece(0, self.prefix)
    }

    /// Returns the word behind the `#` or point: `RED` of `COLOR#RED`.
    pub fn value(&self) -> Name<'s> {
        self.piece(self.prefix + 1, self.written.len() as u32)
    }

    fn piece(&self, from: u32, to: u32) -> Name<'s> {
        let text = self.written.get(from as usize..to as usize).unwrap_or_default();
        Name {
            text,
            span: Span::new(self.start + from, self.start + to),
        }
    }
}

/// A literal as written. The text is checked for its form by the lexer; its value is read where its type is
/// known, by `stickler_types::literal`.
#[derive(Clone, Copy, Debug)]
pub struct Literal<'s> {
    /// The kind of literal.
    pub kind: LiteralKind,
    /// The length of what stands before the `#` of a prefix; 0 where there is no prefix.
    prefix: u16,
    start: u32,
    written: &'s str,
}

impl<'s> Literal<'s> {
    /// A literal that begins at byte `start`, with a prefix of that length in front of its `#`, or of length 0.
    pub(crate) fn new(kind: LiteralKind, written: &'s str, start: u32, prefix: usize) -> Literal<'s> {
        Literal {
            kind,
            prefix: prefix as u16,
            start,
            written,
        }
    }

    /// Returns the type in front of `#`, where one is written: `INT` of `INT#5`, `T` of `T#1s`.
    pub fn prefix(&self) -> Option<Name<'s>> {
        let end = self.start + u32::from(self.prefix);
        let text = self
            .written
            .get(..usize::from(self.prefix))
            .filter(|text| !text.is_empty())?;
        Some(Name {
            text,
            span: Span::new(self.start, end),
        })
    }

    /// Returns the text behind the prefix, with a sign where the prefix allows one inside (`INT#-5`).
    pub fn text(&self) -> &'s str {
        let from = if self.prefix == 0 {
            0
        } else {
            usize::from(self.prefix) + 1
        };
        self.written.get(from..).unwrap_or_default()
    }
}

/// The kinds of literal, by their form.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LiteralKind {
    /// `42`, `1_000`, and with a typed prefix `-5`.
    Integer,
    /// `16#FF`, `2#1010`, `8#17`.
    BasedInteger,
    /// `1.5`, `1.0E-3`.
    Real,
    /// TRUE or FALSE.
    Boolean,
    /// `'text'`, with its quotes.
    SingleByteText,
    /// `"text"`, with its quotes.
    DoubleByteText,
    /// The text behind `T#`, `TIME#`, `LT#`, `LTIME#`.
    Duration,
    /// The text behind `D#`, `DATE#`, `LD#`, `LDATE#`.
    Date,
    /// The text behind `TOD#`, `TIME_OF_DAY#`, `LTOD#` …
    TimeOfDay,
    /// The text behind `DT#`, `DATE_AND_TIME#`, `LDT#` …
    DateAndTime,
}
