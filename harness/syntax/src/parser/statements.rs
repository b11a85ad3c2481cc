//! Lists of statements, and the statements that are no blocks.

use super::state::{Broken, OpenBlock, ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{ExpressionId, ExpressionKind, Statement, StatementKind};

impl<'s> Parser<'s, '_> {
    /// The body of a POU.
    pub(super) fn statements(&mut self) -> Vec<Statement> {
        let mut list = Vec::new();
        self.statements_until(&mut list, |_| false);
        list
    }

    /// Statements up to a token which an open block waits for, or to where `stop` holds.
    pub(super) fn statements_until(&mut self, list: &mut Vec<Statement>, stop: impl Fn(&mut Self) -> bool) {
        loop {
            let kind = self.kind();
            if kind.ends_statements() {
                if self.is_awaited(kind) {
                    return;
                }
                self.expected("a statement");
                self.bump();
                self.eat(TokenKind::Semicolon);
            } else if kind.opens_section() {
                self.expected("a statement (variable sections stand before the statements)");
                let section = self.variable_block();
                self.late_sections.extend(section);
            } else if self.at_member() {
                if self.blocks.last() == Some(&OpenBlock::Member) {
                    return;
                }
                self.member_declaration();
            } else if stop(self) || self.at_misspelt_end() {
                return;
            } else {
                self.statement(list);
            }
        }
    }

    /// One statement and its `;`. One that could not be read is left out, as if it were not there.
    fn statement(&mut self, list: &mut Vec<Statement>) {
        let start = self.position();
        let first = self.token().span;
        self.open = 0;
        if self.eat(TokenKind::Semicolon) {
            list.push(Statement {
                kind: StatementKind::Empty,
                span: first,
            });
            return;
        }
        match self.statement_kind() {
            Ok(kind) => {
                let is_block = kind.is_block();
                let span = first.to(self.previous_span());
                let end = match is_block && self.dialect.ends_without_semicolon {
                    _ if matches!(kind, StatementKind::Label(_)) => Ok(()),
                    true => {
                        self.eat(TokenKind::Semicolon);
                        Ok(())
                    }
                    false => self.semicolon(TokenKind::Assign),
                };
                if is_block || end.is_ok() {
                    list.push(Statement { kind, span });
                }
                if end.is_err() {
                    self.skip_statement();
                }
            }
            Err(Broken) => self.skip_statement(),
        }
        if self.position() == start {
            self.bump();
        }
    }

    fn statement_kind(&mut self) -> ParseResult<StatementKind> {
        match self.kind() {
            TokenKind::Name if self.at_continue() => self.keyword_statement(StatementKind::Continue),
            TokenKind::Name | TokenKind::Direct => self.assignment_or_call(),
            TokenKind::Dot if self.nth(1) == TokenKind::Name => self.assignment_or_call(),
            TokenKind::Exit => self.keyword_statement(StatementKind::Exit),
            TokenKind::Return => self.keyword_statement(StatementKind::Return),
            kind if kind.opens_block() => self.block_statement(),
            _ if self.dialect.values_as_statements => self.expression().map(StatementKind::Call),
            _ => Err(self.expected("a statement")),
        }
    }

    fn keyword_statement(&mut self, kind: StatementKind) -> ParseResult<StatementKind> {
        self.bump();
        Ok(kind)
    }

    /// CONTINUE is no keyword of the second edition, so that it may name a variable there.
    fn at_continue(&self) -> bool {
        let used_as_name = matches!(
            self.nth(1),
            TokenKind::Assign | TokenKind::Dot | TokenKind::LeftParen | TokenKind::LeftBracket
        );
        !used_as_name && self.at_word("CONTINUE")
    }

    /// `variable := value` or `call(…)`.
    fn assignment_or_call(&mut self) -> ParseResult<StatementKind> {
        if !matches!(self.nth(1), TokenKind::Assign | TokenKind::LeftParen) {
            self.unsupported_statement()?;
            if self.at_word("JMP") && self.nth(1) == TokenKind::Name {
                let word = self.bump().span;
                return self.label(word, "JMP").map(StatementKind::Jump);
            }
            if self.at_label() {
                let label = self.label(self.token().span, "NAME:").map(StatementKind::Label);
                self.bump();
                return label;
            }
        }
        let start = self.token().span;
        let target = self.path()?;
        if self.kind() == TokenKind::Assign {
            if self.is_call(target) {
                return Err(self.expected("`;` (a call cannot be assigned to)"));
            }
            self.bump();
            let value = self.assigned_value()?;
            return Ok(StatementKind::Assignment { target, value });
        }
        if self.kind() == TokenKind::Name && self.nth(1) == TokenKind::Equal && self.at_word("REF") {
            return self.binding(target);
        }
        self.unsupported_assignment(start)?;
        let is_value = self.kind() == TokenKind::Semicolon && self.dialect.values_as_statements;
        if self.is_call(target) || is_value {
            return Ok(StatementKind::Call(target));
        }
        Err(match self.kind() {
            TokenKind::Equal => self.expected("`:=`"),
            _ => self.missing("`:=` or a call"),
        })
    }

    /// Returns whether `label:` stands here: the statement behind it tells it from a mistaken `:=`.
    fn at_label(&self) -> bool {
        use TokenKind::{Assign, Colon, Dot, LeftBracket, LeftParen, Name, Semicolon};
        let is_statement = match self.nth(2) {
            Name => {
                matches!(self.nth(3), Assign | LeftParen | LeftBracket | Dot | Colon | Name)
            }
            kind => kind == Semicolon || kind.opens_statement() || kind.ends_statements(),
        };
        self.nth(1) == Colon && is_statement
    }

    /// The name of a label; at `place` a dialect that has none is told of `what`.
    fn label(&mut self, place: Span, what: &str) -> ParseResult<ExpressionId> {
        let has = self.has("jump", place, what);
        let name = self.name("a label")?;
        let id = self.push(ExpressionKind::Name(name), name.span);
        if has { Ok(id) } else { Err(Broken) }
    }

    /// `target REF= value`.
    fn binding(&mut self, target: ExpressionId) -> ParseResult<StatementKind> {
        let start = self.bump().span;
        let span = start.to(self.bump().span);
        let has = self.has("reference-binding", span, "REF=");
        let value = self.expression()?;
        match has {
            true => Ok(StatementKind::Binding { target, value }),
            false => Err(Broken),
        }
    }

    fn is_call(&self, id: ExpressionId) -> bool {
        let expression = self.expressions.get(id.0 as usize);
        expression.is_some_and(|expression| matches!(expression.kind, ExpressionKind::Call { .. }))
    }
}
