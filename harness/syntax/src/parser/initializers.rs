//! Initial values.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{ArrayElement, Initializer, InitializerKind};

impl<'s> Parser<'s, '_> {
    /// Reads the initial value behind `:=` in a declaration.
    pub(super) fn initializer(&mut self) -> ParseResult<Initializer<'s>> {
        let start = self.token().span;
        let kind = match self.kind() {
            TokenKind::LeftBracket => self.nested(Self::array_initializer)?,
            TokenKind::LeftParen if self.nth(1) == TokenKind::Name && self.nth(2) == TokenKind::Assign => {
                self.nested(Self::structure_initializer)?
            }
            _ => InitializerKind::Expression(self.expression()?),
        };
        Ok(Initializer {
            kind,
            span: start.to(self.previous_span()),
        })
    }

    /// `[1, 2, 3(0)]`.
    fn array_initializer(&mut self) -> ParseResult<InitializerKind<'s>> {
        let elements = |parser: &mut Self| parser.list(Self::array_element);
        self.bracketed(TokenKind::RightBracket, elements)
            .map(InitializerKind::Array)
    }

    /// A value, or `3(value)`, `3(value, value)` or `3()`.
    fn array_element(&mut self) -> ParseResult<ArrayElement<'s>> {
        if !matches!(self.kind(), TokenKind::Integer | TokenKind::Based)
            || self.nth(1) != TokenKind::LeftParen
        {
            return Ok(ArrayElement {
                repetition: None,
                values: vec![self.initializer()?],
            });
        }
        let repetition = Some(self.literal());
        let values = self.bracketed(TokenKind::RightParen, |parser| match parser.kind() {
            TokenKind::RightParen => Ok(Vec::new()),
            _ => parser.list(|parser| parser.nested(Self::initializer)),
        })?;
        Ok(ArrayElement { repetition, values })
    }

    /// `(x := 1, y := 2)`.
    fn structure_initializer(&mut self) -> ParseResult<InitializerKind<'s>> {
        let field = |parser: &mut Self| parser.named("a field's name", Self::initializer);
        self.bracketed(TokenKind::RightParen, |parser| parser.list(field))
            .map(InitializerKind::Structure)
    }
}
