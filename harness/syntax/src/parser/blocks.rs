//! The statements that have statements in them: IF, CASE, FOR, WHILE, REPEAT.

use super::state::{OpenBlock, ParseResult, Parser};
use crate::diagnostic::quoted;
use crate::token::TokenKind;
use crate::tree::{
    CaseBranch, CaseFolded, CaseLabel, ExpressionId, ExpressionKind, Statement, StatementKind,
};

impl<'s> Parser<'s, '_> {
    /// A block which is open waits for this keyword; or it closes a statement, and the innermost block is one,
    /// so that the wrong END_… has been written.
    pub(super) fn is_awaited(&self, kind: TokenKind) -> bool {
        let mistaken = kind.closes_block()
            && !matches!(
                self.blocks.last(),
                None | Some(OpenBlock::Pou | OpenBlock::Member)
            );
        mistaken || kind == TokenKind::End || self.blocks.iter().rev().any(|block| block.awaits(kind))
    }

    /// Returns whether the next tokens were meant for an end that an open block waits for.
    pub(super) fn at_misspelt_end(&self) -> bool {
        self.misspelt_end()
            .is_some_and(|(meant, _)| self.is_awaited(meant))
    }

    /// The keyword that closes what has just been read. A wrong one is taken for it, unless it closes something
    /// further out.
    pub(super) fn close(&mut self, closer: TokenKind) {
        let kind = self.kind();
        if kind == closer {
            self.bump();
            return;
        }
        self.expected(&quoted(closer.text()));
        if let Some((meant, tokens)) = self.misspelt_end() {
            if meant == closer || !self.blocks.iter().any(|block| block.awaits(meant)) {
                self.bump_all(tokens);
            }
            return;
        }
        let alike = kind.closes_block() && closer.closes_block()
            || kind.closes_pou() && closer.closes_pou()
            || kind.closes_member() && closer.closes_member();
        if alike && !self.blocks.iter().any(|block| block.awaits(kind)) {
            self.bump();
        }
    }

    /// A statement with an END_… of its own.
    pub(super) fn block_statement(&mut self) -> ParseResult<StatementKind> {
        if self.at_limit() {
            let broken = self.too_deep();
            self.skip_block();
            self.suppress();
            return Err(broken);
        }
        self.nested(|parser| {
            Ok(match parser.kind() {
                TokenKind::If => parser.if_statement(),
                TokenKind::Case => parser.case_statement(),
                TokenKind::For => parser.for_statement(),
                TokenKind::While => parser.while_statement(),
                _ => parser.repeat_statement(),
            })
        })
    }

    /// The statements in a block.
    pub(super) fn block(&mut self, block: OpenBlock) -> Vec<Statement> {
        self.blocks.push(block);
        let body = self.statements();
        self.blocks.pop();
        body
    }

    /// IF … THEN … ELSIF … THEN … ELSE … END_IF.
    fn if_statement(&mut self) -> StatementKind {
        let mut branches = Vec::with_capacity(1);
        while branches.is_empty() || self.kind() == TokenKind::Elsif {
            self.bump();
            let condition = self.header(TokenKind::Then);
            branches.push((condition, self.block(OpenBlock::If)));
        }
        let otherwise = self.else_branch(TokenKind::EndIf);
        self.close(TokenKind::EndIf);
        StatementKind::If { branches, otherwise }
    }

    fn else_branch(&mut self, closer: TokenKind) -> Option<Vec<Statement>> {
        self.eat(TokenKind::Else)
            .then(|| self.block(OpenBlock::Else(closer)))
    }

    /// WHILE … DO … END_WHILE.
    fn while_statement(&mut self) -> StatementKind {
        self.bump();
        let condition = self.header(TokenKind::Do);
        let body = self.block(OpenBlock::While);
        self.close(TokenKind::EndWhile);
        StatementKind::While { condition, body }
    }

    /// REPEAT … UNTIL … END_REPEAT.
    fn repeat_statement(&mut self) -> StatementKind {
        self.bump();
        let body = self.block(OpenBlock::Repeat);
        let until = if self.kind() == TokenKind::Until {
            self.bump();
            self.header(TokenKind::EndRepeat)
        } else {
            let span = self.previous_span();
            self.expected("`UNTIL`");
            self.close(TokenKind::EndRepeat);
            self.push(ExpressionKind::Error, span)
        };
        StatementKind::Repeat { body, until }
    }

    /// An expression and the keyword behind it; what could not be read up to that keyword becomes an error.
    fn header(&mut self, closer: TokenKind) -> ExpressionId {
        self.header_of(closer, Self::expression).unwrap_or_else(|start| {
            let span = self.span_since(start);
            self.push(ExpressionKind::Error, span)
        })
    }

    /// Returns what `production` gives, and the keyword behind it; or where the error stands.
    fn header_of<T>(
        &mut self,
        closer: TokenKind,
        production: impl FnOnce(&mut Self) -> ParseResult<T>,
    ) -> Result<T, crate::source::Span> {
        let start = self.token().span;
        self.open = 0;
        let read = production(self);
        if read.is_ok() && self.eat(closer) {
            return read.map_err(|_| start);
        }
        if read.is_ok() {
            self.missing(&quoted(closer.text()));
            let misspelt = self.misspelt_end().filter(|(meant, _)| *meant == closer);
            let is_behind = self.kind() == TokenKind::Semicolon && self.nth(1) == closer;
            if let Some(tokens) = misspelt.map(|(_, tokens)| tokens).or(is_behind.then_some(2)) {
                self.bump_all(tokens);
                return read.map_err(|_| start);
            }
            let goes_on = self.starts_line() || self.kind().opens_statement();
            if goes_on || closer == TokenKind::Of && self.at_case_label() {
                return read.map_err(|_| start); // Only the keyword is missing.
            }
        }
        self.skip_header(closer);
        read.map_err(|_| start)
    }

    /// FOR … := … TO … BY … DO … END_FOR.
    fn for_statement(&mut self) -> StatementKind {
        self.bump();
        let header = self.header_of(TokenKind::Do, Self::for_list);
        let (control, from, to, by) = header.unwrap_or_else(|start| {
            let span = self.span_since(start);
            let error = self.push(ExpressionKind::Error, span);
            (error, error, error, None)
        });
        let body = self.block(OpenBlock::For);
        self.close(TokenKind::EndFor);
        StatementKind::For {
            control,
            from,
            to,
            by,
            body,
        }
    }

    fn for_list(&mut self) -> ParseResult<(ExpressionId, ExpressionId, ExpressionId, Option<ExpressionId>)> {
        if self.kind() != TokenKind::Name {
            return Err(self.missing("a variable"));
        }
        let control = self.path()?;
        self.require(TokenKind::Assign)?;
        let from = self.expression()?;
        self.require(TokenKind::To)?;
        let to = self.expression()?;
        let by = self.optional(TokenKind::By, Self::expression)?;
        Ok((control, from, to, by))
    }

    /// CASE … OF … ELSE … END_CASE.
    fn case_statement(&mut self) -> StatementKind {
        self.bump();
        let selector = self.header(TokenKind::Of);
        let mut branches = Vec::new();
        self.blocks.push(OpenBlock::Case);
        loop {
            if self.at_case_label() {
                branches.push(self.case_branch());
            } else if self.kind().ends_statements() && self.is_awaited(self.kind()) || self.at_misspelt_end()
            {
                break;
            } else {
                self.expected("a label");
                self.statements_until(&mut Vec::new(), Self::at_case_label);
            }
        }
        self.blocks.pop();
        let otherwise = self.else_branch(TokenKind::EndCase);
        self.close(TokenKind::EndCase);
        StatementKind::Case {
            selector,
            branches,
            otherwise,
        }
    }

    fn case_branch(&mut self) -> CaseBranch {
        let labels = self
            .header_of(TokenKind::Colon, Self::case_labels)
            .unwrap_or_else(|start| {
                let span = self.span_since(start);
                vec![CaseLabel::Value(self.push(ExpressionKind::Error, span))]
            });
        let mut body = Vec::new();
        self.statements_until(&mut body, Self::at_case_label);
        CaseBranch { labels, body }
    }

    /// `1, 5..7, RED`.
    fn case_labels(&mut self) -> ParseResult<Vec<CaseLabel>> {
        self.list(|parser| {
            let low = parser.expression()?;
            let high = parser.optional(TokenKind::DotDot, Self::expression)?;
            Ok(high.map_or(CaseLabel::Value(low), |high| CaseLabel::Range(low, high)))
        })
    }

    /// A label, and no statement, begins here: a literal, a prefix operator, or a name or call with something
    /// behind it that no statement has there.
    fn at_case_label(&mut self) -> bool {
        use TokenKind::*;
        match self.kind() {
            Name if self.nth(1) == Colon && self.is_jumped_to() => false,
            Name => {
                let mut ahead = 1;
                while self.far_ahead(ahead) == Dot && self.far_ahead(ahead + 1) == Name {
                    ahead += 2;
                }
                if self.far_ahead(ahead) == Dot && self.far_ahead(ahead + 1) == Enumerated {
                    ahead += 2;
                }
                if self.far_ahead(ahead) == LeftParen {
                    ahead = self.behind_parentheses(ahead);
                }
                matches!(
                    self.far_ahead(ahead),
                    Colon | Comma | DotDot | Plus | Minus | Star | Slash | Mod | Power
                )
            }
            Enumerated | Plus | Minus | Not | LeftParen => true,
            kind => kind.is_literal(),
        }
    }

    /// Returns whether a JMP of the text leads to the next word, so that it is a label and no enumerated value.
    fn is_jumped_to(&mut self) -> bool {
        let (text, word) = (self.text, self.word());
        let targets = self.jump_targets.get_or_insert_with(|| {
            let words = text.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
            let words = words.filter(|word| !word.is_empty());
            let pairs = words.clone().zip(words.skip(1));
            let jumps = pairs.filter(|(word, _)| word.eq_ignore_ascii_case("JMP"));
            jumps.map(|(_, target)| CaseFolded(target)).collect()
        });
        !self.dialect.lacks("jump") && targets.contains(&CaseFolded(word))
    }

    /// Counts the tokens up to what comes behind the parentheses that open there. It is not looked for beyond the
    /// end of the statement, so that each token is looked at once.
    fn behind_parentheses(&mut self, opening: usize) -> usize {
        let (mut ahead, mut open) = (opening, 0_usize);
        loop {
            match self.far_ahead(ahead) {
                TokenKind::LeftParen => open += 1,
                TokenKind::RightParen => open -= 1,
                TokenKind::Semicolon | TokenKind::End => return ahead,
                kind if kind.ends_statements() => return ahead,
                _ => {}
            }
            ahead += 1;
            if open == 0 {
                return ahead;
            }
        }
    }
}
