//! Initial values.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{ArrayElement, Initializer, InitializerKind, Name};

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
        self.bump();
        self.open += 1;
        let mut elements = Vec::new();
        loop {
            elements.push(self.array_element()?);
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.require(TokenKind::RightBracket)?;
        self.open -= 1;
        Ok(InitializerKind::Array(elements))
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
        self.bump();
        self.open += 1;
        let mut values = Vec::new();
        if self.kind() != TokenKind::RightParen {
            values.push(self.nested(Self::initializer)?);
            while self.eat(TokenKind::Comma) {
                values.push(self.nested(Self::initializer)?);
            }
        }
        self.require(TokenKind::RightParen)?;
        self.open -= 1;
        Ok(ArrayElement { repetition, values })
    }

    /// `(x := 1, y := 2)`.
    fn structure_initializer(&mut self) -> ParseResult<InitializerKind<'s>> {
        self.bump();
        self.open += 1;
        let mut fields: Vec<(Name<'s>, Initializer<'s>)> = Vec::new();
        loop {
            let name = self.name("a field's name")?;
            self.require(TokenKind::Assign)?;
            fields.push((name, self.initializer()?));
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.require(TokenKind::RightParen)?;
        self.open -= 1;
        Ok(InitializerKind::Structure(fields))
    }
}
