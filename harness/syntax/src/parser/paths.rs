//! Names with what may stand behind them: fields, subscripts, bits, arguments.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{Argument, ExpressionId, ExpressionKind, Name};

impl<'s> Parser<'s, '_> {
    /// `a`, `a.b`, `a[1].b(x := 2)`, `a.3`.
    #[inline]
    pub(super) fn path(&mut self) -> ParseResult<ExpressionId> {
        if self.kind() == TokenKind::Dot {
            let point = self.bump().span;
            self.unsupported(point, "names of global variables behind a point (`.name`)");
        }
        let mut span = self.token().span;
        let kind = if self.kind() == TokenKind::Direct {
            self.unsupported(span, "directly represented variables (`%IX0.0`)");
            ExpressionKind::Error
        } else {
            let name = self.own_instance().unwrap_or(Name {
                text: self.word(),
                span,
            });
            span = name.span;
            ExpressionKind::Name(name)
        };
        self.bump();
        self.height = 1;
        let mut path = self.push(kind, span);
        loop {
            path = match self.kind() {
                TokenKind::Dot => self.member(path)?,
                TokenKind::LeftBracket => self.subscripts(path)?,
                TokenKind::LeftParen => self.call(path)?,
                TokenKind::Caret => self.dereference(path)?,
                _ => return Ok(path),
            };
        }
    }

    /// `.field`, or the suffix of a partial access.
    fn member(&mut self, base: ExpressionId) -> ParseResult<ExpressionId> {
        let dot = self.bump();
        self.grow(0)?;
        match self.kind() {
            TokenKind::Name => {
                let field = Name {
                    text: self.word(),
                    span: self.bump().span,
                };
                let span = self.span_of(base).to(field.span);
                Ok(self.push(ExpressionKind::Field { base, field }, span))
            }
            TokenKind::Integer | TokenKind::Partial => Ok(self.partial_access(base, dot)),
            TokenKind::Enumerated => Ok(self.qualified_value(base)),
            _ => Err(self.missing("a field's name or a bit's number")),
        }
    }

    /// `[i, j]`.
    fn subscripts(&mut self, base: ExpressionId) -> ParseResult<ExpressionId> {
        let mut height = self.height;
        let subscripts = self.nested(|parser| {
            let subscript = |parser: &mut Self| {
                let subscript = parser.expression()?;
                height = height.max(parser.height);
                Ok(subscript)
            };
            parser.bracketed(TokenKind::RightBracket, |parser| parser.list(subscript))
        })?;
        self.height = height;
        self.grow(0)?;
        let span = self.span_of(base).to(self.previous_span());
        Ok(self.push(ExpressionKind::Index { base, subscripts }, span))
    }

    /// `(a, b := c, d => e)`.
    fn call(&mut self, callee: ExpressionId) -> ParseResult<ExpressionId> {
        let mut height = self.height;
        let arguments = self.nested(|parser| {
            parser.bracketed(TokenKind::RightParen, |parser| {
                let mut arguments = Vec::with_capacity(1);
                let may_end_with_comma = parser.dialect.comma_behind_arguments;
                while parser.kind() != TokenKind::RightParen || !(arguments.is_empty() || may_end_with_comma)
                {
                    arguments.push(parser.argument()?);
                    height = height.max(parser.height);
                    if !parser.eat(TokenKind::Comma) {
                        break;
                    }
                }
                Ok(arguments)
            })
        })?;
        self.height = height;
        self.grow(0)?;
        let span = self.span_of(callee).to(self.previous_span());
        Ok(self.push(ExpressionKind::Call { callee, arguments }, span))
    }

    /// `value`, `name := value`, `name => variable` or `NOT name => variable`.
    fn argument(&mut self) -> ParseResult<Argument<'s>> {
        let negated = self.kind() == TokenKind::Not;
        let ahead = usize::from(negated);
        match (self.nth(ahead), self.nth(ahead + 1)) {
            (TokenKind::Name, TokenKind::Arrow) => {
                if negated {
                    self.bump();
                }
                let name = self.name("an output")?;
                self.bump();
                if !matches!(self.kind(), TokenKind::Name | TokenKind::Direct) {
                    return Err(self.missing("a variable"));
                }
                Ok(Argument::Output {
                    name,
                    negated,
                    target: self.path()?,
                })
            }
            (TokenKind::Name, TokenKind::Assign) if !negated => {
                let name = self.name("an input")?;
                self.bump();
                let value = self.expression()?;
                Ok(Argument::Named { name, value })
            }
            _ => Ok(Argument::Positional(self.expression()?)),
        }
    }

    /// `p^`.
    fn dereference(&mut self, base: ExpressionId) -> ParseResult<ExpressionId> {
        let caret = self.bump().span;
        self.grow(0)?;
        let span = self.span_of(base).to(caret);
        let kind = match self.has("dereference", caret, "^") {
            true => ExpressionKind::Dereference { base },
            false => ExpressionKind::Error,
        };
        Ok(self.push(kind, span))
    }
}
