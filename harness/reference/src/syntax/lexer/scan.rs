//! The lexer's main loop, words and punctuation.

use super::class::{Class, class, is_word};
use crate::diagnostic::Diagnostics;
use crate::dialect::Dialect;
use crate::source::{MAXIMUM_LENGTH, Span};
use crate::syntax::keyword;
use crate::syntax::token::{Token, TokenKind};
use stickler_types::Code;

/// The most tokens that are read of one text, which bounds the memory that its tree takes.
const MAXIMUM_TOKENS: usize = 8 << 20;

/// What the lexer gives.
#[derive(Debug)]
pub(in crate::syntax) struct Lexed {
    /// The tokens; the last one, and no other, is [`TokenKind::End`].
    pub(in crate::syntax) tokens: Vec<Token>,
    /// What is wrong so far.
    pub(in crate::syntax) diagnostics: Diagnostics,
    /// The text did not end where it seems to: a comment ran to its end, or a limit was met.
    pub(in crate::syntax) truncated: bool,
}

/// The tokens of `text`, by the rules of `dialect`. Takes time and memory in proportion to the text.
pub(in crate::syntax) fn lex(text: &str, dialect: &Dialect) -> Lexed {
    let mut lexer = Lexer::new(text, dialect);
    if text.len() > MAXIMUM_LENGTH {
        let megabytes = MAXIMUM_LENGTH >> 20;
        lexer.report(Code::LimitExceeded, 0, || {
            format!("a source text is longer than {megabytes} MiB")
        });
        lexer.truncated = true;
    } else {
        lexer.scan();
    }
    let end = lexer
        .tokens
        .last()
        .map_or(lexer.offset(), |token| token.span.end.max(lexer.offset()));
    lexer.tokens.push(Token {
        kind: TokenKind::End,
        span: Span { start: end, end },
    });
    Lexed {
        tokens: lexer.tokens,
        diagnostics: lexer.diagnostics,
        truncated: lexer.truncated,
    }
}

/// The lexer's state.
pub(super) struct Lexer<'s, 'd> {
    pub(super) text: &'s str,
    pub(super) bytes: &'s [u8],
    /// The next byte.
    pub(super) at: usize,
    pub(super) dialect: &'d Dialect,
    pub(super) truncated: bool,
    tokens: Vec<Token>,
    diagnostics: Diagnostics,
}

impl<'s, 'd> Lexer<'s, 'd> {
    fn new(text: &'s str, dialect: &'d Dialect) -> Lexer<'s, 'd> {
        Lexer {
            text,
            bytes: text.as_bytes(),
            at: 0,
            dialect,
            truncated: false,
            tokens: Vec::with_capacity(text.len().min(MAXIMUM_LENGTH) / 4 + 1),
            diagnostics: Diagnostics::default(),
        }
    }

    fn scan(&mut self) {
        if self.text.starts_with('\u{FEFF}') {
            self.at = '\u{FEFF}'.len_utf8();
        }
        while let Some(&byte) = self.bytes.get(self.at) {
            match class(byte) {
                Class::Space => self.at += 1,
                Class::Letter => self.word(),
                Class::Digit => self.number(),
                Class::Punctuation => self.punctuation(byte),
                Class::Quote => self.quoted(byte),
                Class::Unknown => self.unknown(),
            }
            if self.tokens.len() >= MAXIMUM_TOKENS {
                return self.give_up();
            }
        }
    }

    fn give_up(&mut self) {
        self.truncated = true;
        let start = self.at;
        self.report(Code::LimitExceeded, start, || {
            format!("a source text has {MAXIMUM_TOKENS} tokens or more")
        });
    }

    /// The byte `ahead` places behind the next one; 0 behind the end, which begins nothing.
    #[inline]
    pub(super) fn peek(&self, ahead: usize) -> u8 {
        self.bytes.get(self.at + ahead).copied().unwrap_or(0)
    }

    /// The position as it is written in spans.
    pub(super) fn offset(&self) -> u32 {
        u32::try_from(self.at.min(self.bytes.len())).unwrap_or(u32::MAX)
    }

    /// Moves over the bytes that `belongs` holds for.
    #[inline]
    pub(super) fn skip(&mut self, belongs: impl Fn(u8) -> bool) {
        while self.bytes.get(self.at).is_some_and(|byte| belongs(*byte)) {
            self.at += 1;
        }
    }

    /// A token from `start` to here.
    #[inline]
    pub(super) fn push(&mut self, kind: TokenKind, start: usize) {
        let span = self.span_from(start);
        self.tokens.push(Token { kind, span });
    }

    /// The span from `start` to here.
    #[inline]
    pub(super) fn span_from(&self, start: usize) -> Span {
        // Texts are no longer than `MAXIMUM_LENGTH`, which 32 bits hold.
        Span {
            start: start as u32,
            end: self.at as u32,
        }
    }

    /// A diagnostic about the text from `start` to here.
    pub(super) fn report(&mut self, code: Code, start: usize, message: impl FnOnce() -> String) {
        self.diagnostics.report(code, self.span_from(start), message);
    }

    /// A diagnostic about `span`.
    pub(super) fn report_at(&mut self, code: Code, span: Span, message: impl FnOnce() -> String) {
        self.diagnostics.report(code, span, message);
    }

    /// A token from `start` to here that the parser is to keep silent about, and its diagnostic.
    pub(super) fn push_malformed(&mut self, start: usize, message: impl FnOnce() -> String) {
        self.report(Code::SyntaxError, start, message);
        self.push(TokenKind::Malformed, start);
    }

    /// The kind of the token before this place.
    #[inline]
    pub(super) fn previous(&self) -> Option<TokenKind> {
        self.tokens.last().map(|token| token.kind)
    }

    #[inline]
    fn word(&mut self) {
        let start = self.at;
        self.at += 1;
        self.skip(is_word);
        if self.peek(0) == b'#' {
            self.typed_literal(start);
        } else {
            let kind = keyword::classify(&self.bytes[start..self.at]);
            self.push(kind, start);
        }
    }

    #[inline]
    fn punctuation(&mut self, byte: u8) {
        use TokenKind::*;
        let (kind, length) = match (byte, self.peek(1)) {
            (b':', b'=') => (Assign, 2),
            (b':', _) => (Colon, 1),
            (b';', _) => (Semicolon, 1),
            (b',', _) => (Comma, 1),
            (b'(', b'*') => return self.block_comment(),
            (b'(', _) => (LeftParen, 1),
            (b')', _) => (RightParen, 1),
            (b'[', _) => (LeftBracket, 1),
            (b']', _) => (RightBracket, 1),
            (b'.', b'.') => (DotDot, 2),
            (b'.', _) => (Dot, 1),
            (b'+', _) => (Plus, 1),
            (b'-', _) => (Minus, 1),
            (b'*', b'*') => (Power, 2),
            (b'*', _) => (Star, 1),
            (b'/', b'/') => return self.line_comment(),
            (b'/', b'*') => return self.slash_comment(),
            (b'/', _) => (Slash, 1),
            (b'=', b'>') => (Arrow, 2),
            (b'=', _) => (Equal, 1),
            (b'<', b'=') => (LessOrEqual, 2),
            (b'<', b'>') => (NotEqual, 2),
            (b'<', _) => (Less, 1),
            (b'>', b'=') => (GreaterOrEqual, 2),
            (b'>', _) => (Greater, 1),
            (b'&', _) => (Ampersand, 1),
            (b'^', _) => (Caret, 1),
            (b'?', b'=') => (AssignAttempt, 2),
            (b'{', _) => return self.pragma(),
            (b'%', _) => return self.percent(),
            _ => return self.unknown(),
        };
        let start = self.at;
        self.at += length;
        self.push(kind, start);
    }

    /// A run of characters that begin no token: one token, one diagnostic.
    pub(super) fn unknown(&mut self) {
        let start = self.at;
        self.at += 1;
        self.skip(|byte| class(byte) == Class::Unknown);
        self.push_unknown(start);
    }

    /// The text from `start` to here matches nothing.
    pub(super) fn push_unknown(&mut self, start: usize) {
        let text = self.span_from(start).text(self.text);
        self.report(Code::UnexpectedToken, start, || {
            format!("{} begins no token", describe(text))
        });
        self.push(TokenKind::Unknown, start);
    }
}

/// At most a few characters, with those spelled out that a terminal would not show.
fn describe(text: &str) -> String {
    let mut shown = String::from("`");
    for character in text.chars().take(8) {
        if character.is_control() || matches!(character, '\u{FEFF}' | '\u{200B}' | '\u{A0}' | '\u{FFFD}') {
            shown += &format!("U+{:04X}", u32::from(character));
        } else {
            shown.push(character);
        }
    }
    shown
        + if text.chars().nth(8).is_some() {
            "…`"
        } else {
            "`"
        }
}
