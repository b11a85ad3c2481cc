//! Names with what may stand behind them: fields, subscripts, bits, arguments.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{Argument, ExpressionId, ExpressionKind, Name};

impl<'s> Parser<'s, '_> {
    /// `a`, `a.b`, `a[1].b(x := 2)`, `a.3`.
    #[inline]
    pub(super) fn path(&mut self) -> ParseResult<ExpressionId> {
        let span = self.token().span;
        let kind = if self.kind() == TokenKind::Direct {
            self.unsupported(span, "directly represented variables (`%IX0.0`)");
            ExpressionKind::Error
        } else {
            ExpressionKind::Name(Name {
                text: self.word(),
                span,
            })
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
            _ => Err(self.missing("a field's name or a bit's number")),
        }
    }

    /// `[i, j]`.
    fn subscripts(&mut self, base: ExpressionId) -> ParseResult<ExpressionId> {
        let mut height = self.height;
        let subscripts = self.nested(|parser| {
            parser.bump();
            parser.open += 1;
            let mut subscripts = Vec::with_capacity(1);
            loop {
                subscripts.push(parser.expression()?);
                height = height.max(parser.height);
                if !parser.eat(TokenKind::Comma) {
                    break;
                }
            }
            parser.require(TokenKind::RightBracket)?;
            parser.open -= 1;
            Ok(subscripts)
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
            parser.bump();
            parser.open += 1;
            let mut arguments = Vec::new();
            while arguments.is_empty() || parser.eat(TokenKind::Comma) {
                if arguments.is_empty() && parser.kind() == TokenKind::RightParen {
                    break;
                }
                arguments.push(parser.argument()?);
                height = height.max(parser.height);
            }
            parser.require(TokenKind::RightParen)?;
            parser.open -= 1;
            Ok(arguments)
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
                Ok(Argument::Named {
                    name,
                    value: self.expression()?,
                })
            }
            _ => Ok(Argument::Positional(self.expression()?)),
        }
    }

    /// `p^`.
    fn dereference(&mut self, base: ExpressionId) -> ParseResult<ExpressionId> {
        let caret = self.bump().span;
        self.grow(0)?;
        self.unsupported(caret, "references (`^`)");
        let span = self.span_of(base).to(caret);
        Ok(self.push(ExpressionKind::Error, span))
    }
}

#[cfg(test)]
mod tests {
    use crate::parser::testing::{accepted_body, body_errors, shape};

    #[test]
    fn suffixes_are_read_from_the_left() {
        let text = "PROGRAM p x := a[i, j + 1].b.3; fbs[1](q => r); END_PROGRAM";
        let tree = shape(text);
        for form in ["Index", "Field", "Bit { base", "Call", "Output { name"] {
            assert!(tree.contains(form), "{form}");
        }
    }

    #[test]
    fn arguments_have_four_forms() {
        let tree = shape(
            "PROGRAM p f(1, a := NOT b, c => d[1], NOT e => g.h, NOT i, EN := TRUE, ENO => ok); END_PROGRAM",
        );
        assert_eq!(tree.matches("Positional").count(), 2);
        assert_eq!(tree.matches("Named").count(), 2);
        assert_eq!(tree.matches("negated: false").count(), 2);
        assert_eq!(tree.matches("negated: true").count(), 1);
    }

    #[test]
    fn a_broken_path_is_one_error() {
        for (text, error) in [
            (
                "x := a.;",
                "1:8 P0002 expected a field's name or a bit's number, found `;`",
            ),
            ("x := a[];", "1:8 P0002 expected an expression, found `]`"),
            ("x := a[1;", "1:9 P0002 expected `]`, found `;`"),
            ("f(1, );", "1:6 P0002 expected an expression, found `)`"),
            ("f(, 1);", "1:3 P0002 expected an expression, found `,`"),
            ("f(a := );", "1:8 P0002 expected an expression, found `)`"),
            ("f(a => );", "1:8 P0002 expected a variable, found `)`"),
            ("f(a => 5);", "1:8 P0002 expected a variable, found `5`"),
            ("f(a b);", "1:5 P0002 expected `)`, found `b`"),
            (
                "x := a.on;",
                "1:8 P0002 expected a field's name or a bit's number, found the keyword `ON`",
            ),
        ] {
            assert_eq!(body_errors(text), [error], "{text}");
        }
    }

    #[test]
    fn paths_and_calls_nest_to_the_limit_only() {
        assert_eq!(
            accepted_body(&format!("x := {}1{};", "f(".repeat(200), ")".repeat(200))).len(),
            1
        );
        assert_eq!(accepted_body(&format!("x := a{};", ".b".repeat(200))).len(), 1);
        for deep in ["f(", "a[", "f(x := ", "a.b[", "a.b[1](c := 1 + f("] {
            assert_eq!(
                body_errors(&format!("x := {};", deep.repeat(100_000))).len(),
                1,
                "{deep}"
            );
        }
        for long in [".b", "[1]", "()", ".3"] {
            assert_eq!(
                body_errors(&format!("x := a{};", long.repeat(100_000))).len(),
                1,
                "{long}"
            );
        }
    }
}
