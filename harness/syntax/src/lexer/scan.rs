//! The lexer's main loop, words and punctuation.

use super::class::{ByteClass, class, is_word, mark};
use crate::decoding::NO_TEXT;
use crate::diagnostic::Diagnostics;
use crate::keyword;
use crate::source::{MAX_LENGTH, Span};
use crate::token::{Token, TokenKind};
use std::fmt::Write as _;
use stickler_types::{Code, Dialect};

/// The most tokens that are read of one text, which bounds the memory that its tree takes.
const MAX_TOKENS: usize = 16 << 20;

/// A token and the blanks before it take at least about so many bytes of an ordinary text.
const BYTES_A_TOKEN: usize = 3;

/// The lexer, which reads tokens a chunk at a time: as many as the parser asks for, and no more, so that they are
/// still in the cache when the parser gets to them. Takes time in proportion to the text.
pub(crate) struct Lexer<'s, 'd> {
    pub(super) text: &'s str,
    pub(super) bytes: &'s [u8],
    /// The next byte.
    pub(super) at: usize,
    pub(super) dialect: &'d Dialect,
    /// The tokens that have been read and not been dropped.
    pub(crate) tokens: Vec<Token>,
    /// The diagnostics so far; the parser adds to them.
    pub(crate) diagnostics: Diagnostics,
    /// The text did not end where it seems to: a comment ran to its end, or a limit was met.
    pub(crate) truncated: bool,
    /// The comments and pragmas so far.
    pub(crate) comments: Vec<Span>,
    /// Whether the token at the end has been given.
    ended: bool,
    /// Whether a configuration is open.
    in_configuration: bool,
    /// The number of tokens that have been dropped.
    dropped: usize,
}

/// The lexer when it has read the whole of `text`.
pub(crate) fn lex<'s, 'd>(text: &'s str, dialect: &'d Dialect) -> Lexer<'s, 'd> {
    let mut lexer = Lexer::new(text, dialect);
    lexer.read(text.len() + 1);
    lexer
}

impl<'s, 'd> Lexer<'s, 'd> {
    /// A lexer for `text` by the rules of `dialect`, which has read nothing yet.
    pub(crate) fn new(text: &'s str, dialect: &'d Dialect) -> Lexer<'s, 'd> {
        let mut lexer = Lexer {
            text,
            bytes: text.as_bytes(),
            at: if text.starts_with('\u{FEFF}') {
                '\u{FEFF}'.len_utf8()
            } else {
                0
            },
            dialect,
            tokens: Vec::new(),
            diagnostics: Diagnostics::default(),
            truncated: false,
            comments: Vec::new(),
            ended: false,
            in_configuration: false,
            dropped: 0,
        };
        if text.len() > MAX_LENGTH {
            lexer.give_up(|| format!("a source text is longer than {} MiB", MAX_LENGTH >> 20));
        }
        lexer
    }

    /// Reads until there are `count` tokens, or the text ends: with a token [`TokenKind::End`], after which no
    /// other comes.
    pub(crate) fn read(&mut self, count: usize) {
        if self.ended {
            return;
        }
        let left = self.bytes.len().saturating_sub(self.at);
        let wanted = count.saturating_sub(self.tokens.len());
        self.tokens.reserve(wanted.min(left / BYTES_A_TOKEN + 1));
        self.scan(count);
        if !self.truncated && self.dropped + self.tokens.len() > MAX_TOKENS {
            self.give_up(|| format!("a source text has more than {MAX_TOKENS} tokens"));
        }
        if self.tokens.len() < count {
            self.ended = true;
            self.push(TokenKind::End, self.at);
        }
    }

    /// Drops the first `count` tokens.
    pub(crate) fn drop_first(&mut self, count: usize) {
        self.dropped += count;
        self.tokens.drain(..count.min(self.tokens.len()));
    }

    fn scan(&mut self, count: usize) {
        while self.tokens.len() < count {
            self.skip(|byte| class(byte) == ByteClass::Space);
            let Some(&byte) = self.bytes.get(self.at) else {
                return;
            };
            match class(byte) {
                ByteClass::Letter => self.word(),
                ByteClass::Mark => {
                    self.at += 1;
                    self.push(mark(byte), self.at - 1);
                }
                ByteClass::Punctuation => self.punctuation(byte),
                ByteClass::Digit => self.number(),
                ByteClass::Quote => {
                    self.quoted(self.at, [TokenKind::SingleByteText, TokenKind::DoubleByteText])
                }
                ByteClass::Unknown | ByteClass::Space => self.unknown(),
            }
        }
    }

    /// Reads nothing more.
    fn give_up(&mut self, message: impl FnOnce() -> String) {
        let start = self.at;
        self.report(Code::LimitExceeded, start, message);
        self.truncated = true;
        self.bytes = self.bytes.get(..self.at).unwrap_or(self.bytes);
    }

    /// The byte `ahead` places behind the next one; 0 behind the end, which begins nothing.
    #[inline]
    pub(super) fn peek(&self, ahead: usize) -> u8 {
        self.bytes.get(self.at + ahead).copied().unwrap_or(0)
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
        // Texts are no longer than `MAX_LENGTH`, which 32 bits hold.
        Span::new(start as u32, self.at as u32)
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
            let kind = if kind.is_keyword() {
                self.reserved(kind)
            } else {
                kind
            };
            self.push(kind, start);
        }
    }

    /// The kind of a keyword: a name where the dialect leaves the word free. Configurations have all keywords.
    #[inline]
    fn reserved(&mut self, kind: TokenKind) -> TokenKind {
        match kind {
            TokenKind::Configuration => self.in_configuration = true,
            TokenKind::EndConfiguration => self.in_configuration = false,
            _ if !self.in_configuration && self.dialect.free_words.contain(kind.text()) => {
                return TokenKind::Name;
            }
            _ => {}
        }
        kind
    }

    #[inline]
    fn punctuation(&mut self, byte: u8) {
        use TokenKind::*;
        let (kind, length) = match (byte, self.peek(1)) {
            (b':', b'=') => (Assign, 2),
            (b':', _) => (Colon, 1),
            (b'(', b'*') => return self.block_comment(),
            (b'(', _) => (LeftParen, 1),
            (b'.', b'.') => (DotDot, 2),
            (b'.', _) => (Dot, 1),
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
        self.skip(|byte| class(byte) == ByteClass::Unknown);
        self.push_unknown(start);
    }

    /// The text from `start` to here matches nothing.
    pub(super) fn push_unknown(&mut self, start: usize) {
        let text = self.span_from(start).text(self.text);
        let replaced = text
            .chars()
            .all(|character| character == char::REPLACEMENT_CHARACTER);
        self.report(Code::UnexpectedToken, start, || match replaced {
            true => NO_TEXT.to_owned(),
            false => no_token(text),
        });
        self.push(TokenKind::Unknown, start);
    }
}

/// Says that a text begins no token: at most a few of its characters, with those spelled out that a terminal would not show.
fn no_token(text: &str) -> String {
    const MAX_CHARACTERS: usize = 8;
    // Enough for the most that is shown of each character.
    let mut said = String::with_capacity("`…` begins no token".len() + MAX_CHARACTERS * "U+10FFFF".len());
    said.push('`');
    let mut characters = text.chars();
    for character in characters.by_ref().take(MAX_CHARACTERS) {
        if character.is_control() || matches!(character, '\u{FEFF}' | '\u{200B}' | '\u{A0}' | '\u{FFFD}') {
            // Writing to a string does not fail.
            let _ = write!(said, "U+{:04X}", u32::from(character));
        } else {
            said.push(character);
        }
    }
    said.push_str(if characters.next().is_some() { "…`" } else { "`" });
    said.push_str(" begins no token");
    said
}
