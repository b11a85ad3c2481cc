//! Comments and pragmas, which stand between tokens.

use super::scan::Lexer;
use crate::source::Span;
use stickler_types::Code;

impl Lexer<'_, '_> {
    /// `(* … *)`, nested where the dialect nests comments. A comment that is not closed is diagnosed where it
    /// opens.
    ///
    /// Basis: Table 3 of the third edition; the line of P0001: conformance-cases/README.md (marks).
    pub(super) fn block_comment(&mut self) {
        let start = self.at;
        self.at += 2;
        let is_description =
            self.dialect.oscat_descriptions && self.bytes[start..].starts_with(b"(*@KEY@:DESCRIPTION*)");
        let closed = if is_description {
            self.skip_past(b"(*@KEY@:END_DESCRIPTION*)")
        } else if self.dialect.nested_comments {
            self.skip_nested(b"(*", b"*)")
        } else {
            self.skip_past(b"*)")
        };
        self.comments.push(self.span_from(start));
        if !closed {
            self.report_open(start, "the comment that opens here is not closed");
        }
    }

    /// `// …` up to the end of the line.
    pub(super) fn line_comment(&mut self) {
        let start = self.at;
        self.skip(|byte| byte != b'\n');
        self.comments.push(self.span_from(start));
        if !self.dialect.line_comments {
            self.report_disabled(start, "//");
        }
    }

    /// `/* … */`, which came with the same edition as `//`.
    pub(super) fn slash_comment(&mut self) {
        let start = self.at;
        self.at += 2;
        let closed = if self.dialect.nested_comments && self.dialect.line_comments {
            self.skip_nested(b"/*", b"*/")
        } else {
            self.skip_past(b"*/")
        };
        self.truncated |= !closed;
        self.comments.push(self.span_from(start));
        if !self.dialect.line_comments {
            self.report_disabled(start, "/*");
        } else if !closed {
            self.report_open(start, "the comment that opens here is not closed");
        }
    }

    /// `{ … }`, whose contents the standard leaves to the implementer; the reference knows none.
    pub(super) fn pragma(&mut self) {
        let start = self.at;
        self.at += 1;
        let closed = self.skip_past(b"}");
        self.comments.push(self.span_from(start));
        if !closed {
            self.report_open(start, "the pragma that opens here is not closed");
        }
    }

    /// Moves behind the next `closing`, or to the end; says whether there was one.
    fn skip_past(&mut self, closing: &[u8]) -> bool {
        let [first, rest @ ..] = closing else { return false };
        loop {
            let rest_of_text = self.bytes.get(self.at..).unwrap_or(&[]);
            let Some(found) = rest_of_text.iter().position(|byte| byte == first) else {
                self.at = self.bytes.len();
                return false;
            };
            self.at += found + 1;
            if self
                .bytes
                .get(self.at..)
                .is_some_and(|text| text.starts_with(rest))
            {
                self.at += rest.len();
                return true;
            }
        }
    }

    /// Skips a comment where comments nest; they are counted, so that any depth does.
    fn skip_nested(&mut self, opening: &[u8; 2], closing: &[u8; 2]) -> bool {
        let mut depth = 1_usize;
        while depth > 0 {
            let Some(pair) = self.bytes.get(self.at..self.at + 2) else {
                self.at = self.bytes.len();
                return false;
            };
            if pair == closing {
                depth -= 1;
                self.at += 2;
            } else if pair == opening {
                depth += 1;
                self.at += 2;
            } else {
                self.at += 1;
            }
        }
        true
    }

    fn report_open(&mut self, start: usize, message: &str) {
        self.truncated = true;
        let opening = Span::new(start as u32, (start + 2).min(self.bytes.len()) as u32);
        let width = if self.bytes.get(start) == Some(&b'{') {
            1
        } else {
            2
        };
        let span = Span {
            end: opening.start + width,
            ..opening
        };
        self.report_at(Code::OpenComment, span, || message.to_owned());
    }

    fn report_disabled(&mut self, start: usize, form: &str) {
        let dialect = self.dialect.name;
        self.report(Code::CStyleComment, start, || {
            format!("comments with `{form}` are not enabled in the dialect {dialect}; write `(* … *)`")
        });
    }
}
