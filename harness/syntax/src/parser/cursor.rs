//! The tokens around the place where the parser reads. They come from the lexer a chunk at a time; a few stay
//! behind that place, and enough lie ahead of it.

use super::state::{ParseResult, Parser};
use crate::diagnostic::quoted;
use crate::source::Span;
use crate::token::{Token, TokenKind};
use crate::tree::Name;
use stickler_types::{Code, ElementaryType};

/// The number of tokens that the lexer reads at a time.
const CHUNK: usize = 512;

/// The number of tokens that a production may look ahead.
const AHEAD: usize = 16;

/// The number of tokens that are kept behind the next one.
const BEHIND: usize = 4;

impl<'s> Parser<'s, '_> {
    /// Makes the first token the next one.
    pub(super) fn start(&mut self) {
        self.lexer.read(CHUNK);
        self.current = self.token_at(0);
    }

    fn token_at(&self, index: usize) -> Token {
        let end = Token {
            kind: TokenKind::End,
            span: Span::default(),
        };
        self.lexer.tokens.get(index).copied().unwrap_or(end)
    }

    /// The kind of the next token.
    #[inline]
    pub(super) fn kind(&self) -> TokenKind {
        self.current.kind
    }

    /// The next token.
    #[inline]
    pub(super) fn token(&self) -> Token {
        self.current
    }

    /// Returns the number of tokens that have been read.
    #[inline]
    pub(super) fn position(&self) -> usize {
        self.dropped + self.index
    }

    /// The kind of the token `ahead` places behind the next one, which must not be more than [`AHEAD`].
    #[inline]
    pub(super) fn nth(&self, ahead: usize) -> TokenKind {
        self.lexer
            .tokens
            .get(self.index + ahead)
            .map_or(TokenKind::End, |token| token.kind)
    }

    /// The kind of the token `ahead` places behind the next one, however far that is.
    pub(super) fn far_ahead(&mut self, ahead: usize) -> TokenKind {
        if self.index + ahead >= self.lexer.tokens.len() {
            self.lexer.read(self.index + ahead + CHUNK);
        }
        self.nth(ahead)
    }

    /// Takes the next token; the end stays where it is.
    #[inline]
    pub(super) fn bump(&mut self) -> Token {
        let token = self.current;
        if token.kind != TokenKind::End {
            self.index += 1;
            if self.index + AHEAD >= self.lexer.tokens.len() {
                self.read_on();
            }
            self.current = self.token_at(self.index);
        }
        token
    }

    /// Takes several tokens.
    pub(super) fn bump_all(&mut self, tokens: usize) {
        for _ in 0..tokens {
            self.bump();
        }
    }

    /// Drops what lies far behind, and reads another chunk.
    #[cold]
    fn read_on(&mut self) {
        let old = self.index.saturating_sub(BEHIND);
        if old >= CHUNK / 2 {
            self.lexer.drop_first(old);
            self.dropped += old;
            self.index -= old;
        }
        self.lexer.read(self.index + AHEAD + CHUNK);
    }

    /// Takes the next token if it is of this kind.
    #[inline]
    pub(super) fn eat(&mut self, kind: TokenKind) -> bool {
        let found = self.kind() == kind;
        if found {
            self.bump();
        }
        found
    }

    /// Goes back by one token.
    pub(super) fn back(&mut self) {
        if let Some(index) = self.index.checked_sub(1) {
            self.index = index;
            self.current = self.token_at(index);
        }
    }

    /// The kind of the token before the next one.
    pub(super) fn previous_kind(&self) -> Option<TokenKind> {
        Some(self.lexer.tokens.get(self.index.checked_sub(1)?)?.kind)
    }

    /// The span of the token before the next one.
    #[inline]
    pub(super) fn previous_span(&self) -> Span {
        match self.index.checked_sub(1) {
            Some(before) => self.token_at(before).span,
            None => Span::default(),
        }
    }

    /// The span from `start`, where the next token stood, to the last one taken since; that of the token before
    /// where none was.
    pub(super) fn span_since(&self, start: Span) -> Span {
        let last = self.previous_span();
        if last.start >= start.start {
            start.to(last)
        } else {
            last
        }
    }

    /// A line feed stands between the next token and the one before it, or there is none before it.
    pub(super) fn starts_line(&self) -> bool {
        let between = Span::new(self.previous_span().end, self.current.span.start);
        self.index == 0 || between.text(self.text).contains('\n')
    }

    /// The text of the next token.
    #[inline]
    pub(super) fn word(&self) -> &'s str {
        self.current.span.text(self.text)
    }

    /// The next token is a name with this text, in any case.
    #[inline]
    pub(super) fn at_word(&self, word: &str) -> bool {
        self.kind() == TokenKind::Name && self.word().eq_ignore_ascii_case(word)
    }

    /// A name; `what` says whose.
    #[inline]
    pub(super) fn name(&mut self, what: &str) -> ParseResult<Name<'s>> {
        if self.kind() != TokenKind::Name {
            return Err(self.expected(what));
        }
        let name = Name {
            text: self.word(),
            span: self.current.span,
        };
        self.bump();
        Ok(name)
    }

    /// A name that a declaration introduces; `what` says whose. The name of an elementary data type is a keyword, which is reported and
    /// taken for the name, so that nothing else is said of it.
    ///
    /// Basis: iec-61131-3: 6.1.3 and Table 10, whose column of names is headed "Keyword".
    pub(super) fn declared_name(&mut self, what: &str) -> ParseResult<Name<'s>> {
        let name = self.name(what)?;
        if ElementaryType::from_name(name.text).is_some_and(|ty| self.dialect.may_name(ty))
            && !self.dialect.free_words.contain(name.text)
        {
            self.report(Code::SyntaxError, name.span, || {
                format!(
                    "expected {what}, found the data type `{}`",
                    name.text.to_ascii_uppercase()
                )
            });
        }
        Ok(name)
    }

    /// A mark that joins what stands on one line.
    #[inline]
    pub(super) fn require(&mut self, kind: TokenKind) -> ParseResult<Token> {
        if self.kind() == kind {
            Ok(self.bump())
        } else {
            Err(self.missing(&quoted(kind.text())))
        }
    }

    /// What stands between brackets, of which the opening one is the next token.
    pub(super) fn bracketed<T>(
        &mut self,
        closer: TokenKind,
        production: impl FnOnce(&mut Self) -> ParseResult<T>,
    ) -> ParseResult<T> {
        self.bump();
        self.open += 1;
        let inner = production(self)?;
        self.require(closer)?;
        self.open -= 1;
        Ok(inner)
    }

    /// One or several of something, with commas between them.
    pub(super) fn list<T>(
        &mut self,
        mut production: impl FnMut(&mut Self) -> ParseResult<T>,
    ) -> ParseResult<Vec<T>> {
        let mut list = Vec::with_capacity(1);
        loop {
            list.push(production(self)?);
            if !self.eat(TokenKind::Comma) {
                return Ok(list);
            }
        }
    }

    /// Reads what stands behind a keyword or sign, where the next token is that one.
    pub(super) fn optional<T>(
        &mut self,
        sign: TokenKind,
        production: impl FnOnce(&mut Self) -> ParseResult<T>,
    ) -> ParseResult<Option<T>> {
        self.eat(sign).then(|| production(self)).transpose()
    }

    /// `name := value`.
    pub(super) fn named<T>(
        &mut self,
        what: &str,
        value: impl FnOnce(&mut Self) -> ParseResult<T>,
    ) -> ParseResult<(Name<'s>, T)> {
        let name = self.name(what)?;
        self.require(TokenKind::Assign)?;
        Ok((name, value(self)?))
    }
}
