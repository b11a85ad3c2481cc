//! Initial values.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{ArrayElement, Initializer, InitializerKind};

impl<'s> Parser<'s, '_> {
    /// Reads the initial value behind `:=` in a declaration.
    pub(super) fn initializer(&mut self) -> ParseResult<Initializer<'s>> {
        let start = self.token().span;
        let kind = match self.kind() {
            // `[1, 2, 3(0)]`.
            TokenKind::LeftBracket => self.nested(|parser| {
                let elements = |parser: &mut Self| parser.list(Self::array_element);
                parser
                    .bracketed(TokenKind::RightBracket, elements)
                    .map(InitializerKind::Array)
            })?,
            // `(x := 1, y := 2)`.
            TokenKind::LeftParen if self.nth(1) == TokenKind::Name && self.nth(2) == TokenKind::Assign => {
                self.nested(|parser| {
                    let field = |parser: &mut Self| parser.named("a field's name", Self::initializer);
                    let fields = parser.bracketed(TokenKind::RightParen, |parser| parser.list(field));
                    fields.map(InitializerKind::Structure)
                })?
            }
            _ => InitializerKind::Expression(self.expression()?),
        };
        Ok(Initializer {
            kind,
            span: start.to(self.previous_span()),
        })
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
}
