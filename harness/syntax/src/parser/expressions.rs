//! Expressions: operators by precedence, prefix operators, parentheses, literals.

use super::state::{MAX_HEIGHT, ParseResult, Parser, Pending};
use crate::token::TokenKind;
use crate::tree::{
    BinaryOperator, ExpressionId, ExpressionKind, Literal, LiteralKind, Prefixed, UnaryOperator,
};

impl<'s> Parser<'s, '_> {
    /// An expression. Operators wait on a stack, so that neither a long chain nor many precedences take room on
    /// the thread's own.
    ///
    /// Basis: Table 71 of the third edition; infix operators of one precedence associate to the left.
    pub(super) fn expression(&mut self) -> ParseResult<ExpressionId> {
        let base = self.pending.len();
        let result = self.infix_chain(base);
        self.pending.truncate(base);
        result
    }

    #[inline]
    fn infix_chain(&mut self, base: usize) -> ParseResult<ExpressionId> {
        let mut operand = self.operand()?;
        while let Some((operator, precedence)) = self.infix_operator() {
            operand = self.reduce(base, precedence, operand)?;
            self.bump();
            self.pending.push(Pending {
                operator,
                precedence,
                left: operand,
                left_height: self.height,
            });
            operand = self.operand()?;
        }
        self.reduce(base, 0, operand)
    }

    /// Gives their right operand to the waiting operators that bind at least as tight as `precedence`.
    #[inline]
    fn reduce(
        &mut self,
        base: usize,
        precedence: u8,
        mut operand: ExpressionId,
    ) -> ParseResult<ExpressionId> {
        while self.pending.len() > base {
            let Some(top) = self.pending.pop_if(|top| top.precedence >= precedence) else {
                break;
            };
            self.grow(top.left_height)?;
            let span = self.span_of(top.left).to(self.span_of(operand));
            let kind = ExpressionKind::Binary {
                operator: top.operator,
                left: top.left,
                right: operand,
            };
            operand = self.push(kind, span);
        }
        Ok(operand)
    }

    /// The expression read last becomes part of another one, beside an operand of the given height.
    #[inline]
    pub(super) fn grow(&mut self, beside: u32) -> ParseResult<()> {
        self.height = beside.max(self.height + 1);
        if self.height > MAX_HEIGHT {
            Err(self.too_deep())
        } else {
            Ok(())
        }
    }

    /// The operator that stands here, and how tight it binds.
    #[inline]
    fn infix_operator(&mut self) -> Option<(BinaryOperator, u8)> {
        use BinaryOperator as Operator;
        let (operator, precedence) = match self.kind() {
            TokenKind::Ampersand | TokenKind::Power if !self.dialect.ampersand_and_power => {
                self.expected("an operator that the dialect has");
                return None;
            }
            TokenKind::Or => (Operator::Or, 1),
            TokenKind::Xor => (Operator::Xor, 2),
            TokenKind::And | TokenKind::Ampersand => (Operator::And, 3),
            TokenKind::Equal => (Operator::Equal, 4),
            TokenKind::NotEqual => (Operator::NotEqual, 4),
            TokenKind::Less => (Operator::Less, 5),
            TokenKind::Greater => (Operator::Greater, 5),
            TokenKind::LessOrEqual => (Operator::LessOrEqual, 5),
            TokenKind::GreaterOrEqual => (Operator::GreaterOrEqual, 5),
            TokenKind::Plus => (Operator::Add, 6),
            TokenKind::Minus => (Operator::Subtract, 6),
            TokenKind::Star => (Operator::Multiply, 7),
            TokenKind::Slash => (Operator::Divide, 7),
            TokenKind::Mod => (Operator::Modulo, 7),
            TokenKind::Power => (Operator::Power, 8),
            TokenKind::Name if self.at_word("AND_THEN") => self.short_circuit(Operator::AndThen, 3),
            TokenKind::Name if self.at_word("OR_ELSE") => self.short_circuit(Operator::OrElse, 1),
            _ => return None,
        };
        Some((operator, precedence))
    }

    /// AND_THEN or OR_ELSE, and how tight it binds.
    fn short_circuit(&mut self, operator: BinaryOperator, precedence: u8) -> (BinaryOperator, u8) {
        self.has("short-circuit", self.token().span, operator.as_str());
        (operator, precedence)
    }

    /// An operand: prefix operators bind tighter than any infix operator.
    #[inline]
    fn operand(&mut self) -> ParseResult<ExpressionId> {
        match self.kind() {
            TokenKind::Name | TokenKind::Direct => self.path(),
            TokenKind::Minus => self.prefixed(UnaryOperator::Negate),
            TokenKind::Plus => self.prefixed(UnaryOperator::Plus),
            TokenKind::Not if self.names_an_input(1) => self.path(),
            TokenKind::Not => self.prefixed(UnaryOperator::Not),
            TokenKind::And | TokenKind::Or | TokenKind::Xor | TokenKind::Mod
                if self.nth(1) == TokenKind::LeftParen =>
            {
                self.path()
            }
            TokenKind::LeftBracket if self.dialect.aggregates_as_values => self.aggregate(),
            TokenKind::LeftParen if self.dialect.aggregates_as_values && self.names_an_input(0) => {
                self.aggregate()
            }
            TokenKind::LeftParen => self.parenthesized(),
            TokenKind::Dot if self.nth(1) == TokenKind::Name => self.path(),
            TokenKind::Enumerated => Ok(self.enumerated_value()),
            kind if kind.is_literal() => Ok(self.literal()),
            TokenKind::LeftBracket => Err(self
                .expected("an expression (`[…]` gives the elements of an array their initial values only)")),
            _ => Err(self.missing("an expression")),
        }
    }

    /// Returns whether `(IN :=` stands so many tokens ahead: behind NOT, so that it is a function.
    fn names_an_input(&self, ahead: usize) -> bool {
        let ahead = [0, 1, 2].map(|count| self.nth(ahead + count));
        ahead == [TokenKind::LeftParen, TokenKind::Name, TokenKind::Assign]
    }

    /// `[1, 2]` or `(x := 1)` as a value.
    fn aggregate(&mut self) -> ParseResult<ExpressionId> {
        let initializer = Box::new(self.initializer()?);
        self.grow(0)?;
        let span = initializer.span;
        Ok(self.push(ExpressionKind::Aggregate(initializer), span))
    }

    fn prefixed(&mut self, operator: UnaryOperator) -> ParseResult<ExpressionId> {
        let start = self.token().span;
        let operand = self.nested(|parser| {
            parser.bump();
            parser.operand()
        })?;
        self.grow(0)?;
        let span = start.to(self.span_of(operand));
        Ok(self.push(ExpressionKind::Unary { operator, operand }, span))
    }

    /// `value`, or `target := value`, which is a value itself. Where `target` begins a line, a semicolon is missing before it.
    ///
    /// Basis: codesys-pages: _cds_exst_operator_expression.
    pub(super) fn assigned_value(&mut self) -> ParseResult<ExpressionId> {
        let mut value = self.expression()?;
        let mut targets = Vec::new();
        while self.kind() == TokenKind::Assign && self.is_path(value) {
            self.back();
            let begins_line = self.starts_line();
            self.bump();
            if begins_line {
                break;
            }
            let span = self.bump().span;
            self.has("assignment-expression", span, "an assignment as a value");
            targets.push(value);
            value = self.expression()?;
        }
        for target in targets.into_iter().rev() {
            self.grow(0)?;
            let span = self.span_of(target).to(self.span_of(value));
            value = self.push(ExpressionKind::Assigned { target, value }, span);
        }
        Ok(value)
    }

    /// The expression is a variable, or a part of one.
    fn is_path(&self, id: ExpressionId) -> bool {
        use ExpressionKind::{Bit, Dereference, Field, Index, Name, Part};
        let expression = self.expressions.get(id.0 as usize);
        expression.is_some_and(|expression| {
            matches!(
                expression.kind,
                Name(_) | Field { .. } | Index { .. } | Dereference { .. } | Bit { .. } | Part { .. }
            )
        })
    }

    /// `(inner)`.
    fn parenthesized(&mut self) -> ParseResult<ExpressionId> {
        let start = self.token().span;
        let inner = self.nested(|parser| parser.bracketed(TokenKind::RightParen, Self::assigned_value))?;
        self.grow(0)?;
        Ok(self.push(
            ExpressionKind::Parenthesized(inner),
            start.to(self.previous_span()),
        ))
    }

    /// `COLOR#RED`.
    fn enumerated_value(&mut self) -> ExpressionId {
        let value = Prefixed::new(self.word(), self.token().span.start);
        let span = self.bump().span;
        self.height = 1;
        self.push(ExpressionKind::EnumeratedValue(value), span)
    }

    /// A literal, which stands here.
    #[inline]
    pub(super) fn literal(&mut self) -> ExpressionId {
        self.height = 1;
        let token = self.token();
        let has = match token.kind {
            TokenKind::Based | TokenKind::TypedBased if self.word().rsplit('#').nth(1) == Some("8") => {
                self.has("octal-literal", token.span, "8#")
            }
            _ => true,
        };
        let kind = match token.kind {
            _ if !has => ExpressionKind::Error,
            TokenKind::Integer => self.plain(LiteralKind::Integer),
            TokenKind::Based => self.plain(LiteralKind::BasedInteger),
            TokenKind::Real => self.plain(LiteralKind::Real),
            TokenKind::True | TokenKind::False => self.plain(LiteralKind::Boolean),
            TokenKind::SingleByteText => self.plain(LiteralKind::SingleByteText),
            TokenKind::DoubleByteText => self.plain(LiteralKind::DoubleByteText),
            TokenKind::TypedInteger => self.typed(LiteralKind::Integer),
            TokenKind::TypedBased => self.typed(LiteralKind::BasedInteger),
            TokenKind::TypedReal => self.typed(LiteralKind::Real),
            TokenKind::TypedBoolean => self.typed(LiteralKind::Boolean),
            TokenKind::TypedSingleByteText => self.typed(LiteralKind::SingleByteText),
            TokenKind::TypedDoubleByteText => self.typed(LiteralKind::DoubleByteText),
            TokenKind::Duration => self.typed(LiteralKind::Duration),
            TokenKind::Date => self.typed(LiteralKind::Date),
            TokenKind::TimeOfDay => self.typed(LiteralKind::TimeOfDay),
            TokenKind::DateAndTime => self.typed(LiteralKind::DateAndTime),
            _ => ExpressionKind::Error,
        };
        self.bump();
        self.push(kind, token.span)
    }

    #[inline]
    fn plain(&self, kind: LiteralKind) -> ExpressionKind<'s> {
        ExpressionKind::Literal(Literal::new(kind, self.word(), self.token().span.start, 0))
    }

    fn typed(&self, kind: LiteralKind) -> ExpressionKind<'s> {
        let prefix = self.word().find('#').unwrap_or(0);
        ExpressionKind::Literal(Literal::new(kind, self.word(), self.token().span.start, prefix))
    }
}
