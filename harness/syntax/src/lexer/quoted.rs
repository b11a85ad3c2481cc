//! Character strings: `'…'` and `"…"`.

use super::scan::Lexer;
use crate::source::Span;
use crate::token::TokenKind;
use stickler_types::Code;

impl Lexer<'_, '_> {
    /// A string whose token begins at `start`: of one of two kinds, by its quotes.
    pub(super) fn quoted(&mut self, start: usize, [single, double]: [TokenKind; 2]) {
        let quote = self.peek(0);
        let kind = match self.skip_quoted(quote) {
            false => TokenKind::Malformed,
            true if quote == b'"' => double,
            true => single,
        };
        self.push(kind, start);
    }

    /// Moves behind the closing quote, or to the end of the line, and says what is wrong in between; false where something is.
    ///
    /// Basis: Tables 5 and 6 of the third edition; an open string is a character sequence that matches nothing.
    pub(super) fn skip_quoted(&mut self, quote: u8) -> bool {
        let start = self.at;
        let mut sound = true;
        self.at += 1;
        loop {
            self.skip(|byte| byte != quote && byte != b'$' && byte >= b' ');
            match self.peek(0) {
                b'\'' if self.dialect.doubled_apostrophes && quote == b'\'' && self.peek(1) == quote => {
                    self.at += 2
                }
                byte if byte == quote => {
                    self.at += 1;
                    return sound;
                }
                b'$' => sound &= self.escape(quote),
                b'\t' => self.at += 1,
                b'\n' | b'\r' => break,
                _ if self.at >= self.bytes.len() => break,
                control => {
                    sound = false;
                    self.at += 1;
                    let code = Code::UnexpectedToken;
                    self.report(code, self.at - 1, || {
                        format!("U+{control:04X} in a character string")
                    });
                }
            }
        }
        self.report(Code::UnexpectedToken, start, || {
            "a character string is not closed on its line".to_owned()
        });
        false
    }

    /// `$` and what it stands before; false, and a diagnostic, where that is no escape.
    fn escape(&mut self, quote: u8) -> bool {
        let start = self.at;
        let digits = if quote == b'"' { 4 } else { 2 };
        let code = self.bytes.get(start + 1..start + 1 + digits);
        if matches!(
            self.peek(1),
            b'$' | b'\'' | b'"' | b'L' | b'N' | b'P' | b'R' | b'T' | b'l' | b'n' | b'p' | b'r' | b't'
        ) {
            self.at += 2;
            return true;
        }
        if code.is_some_and(|code| code.iter().all(u8::is_ascii_hexdigit)) {
            self.at += 1 + digits;
            return true;
        }
        self.at += 1;
        if matches!(self.peek(0), b'\n' | b'\r') || self.at >= self.bytes.len() {
            return false; // The string is open, which is what its caller says.
        }
        let span = Span::new(start as u32, start as u32 + 1);
        self.report_at(Code::InvalidStringEscape, span, || {
            format!("`$` begins no escape here: write `$$`, or `$` with {digits} hexadecimal digits")
        });
        false
    }
}
