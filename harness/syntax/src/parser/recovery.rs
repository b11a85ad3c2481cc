//! Recovery: finds where reading goes on after an error. Everything here moves forward only, and none of it recurses.

use super::state::{Broken, ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::VariableKind;

impl Parser<'_, '_> {
    /// Moves behind the `;` of a broken statement, or up to what cannot belong to it any more.
    pub(super) fn skip_statement(&mut self) {
        self.skip_past_semicolon(|kind| kind == TokenKind::Assign);
    }

    /// Moves behind the `;` of a broken declaration, or up to what cannot belong to it any more.
    pub(super) fn skip_declaration(&mut self) {
        self.skip_past_semicolon(|kind| matches!(kind, TokenKind::Colon | TokenKind::Comma));
    }

    /// A name at the start of a line begins something new if a token that `begins` holds for follows it, and no
    /// bracket is open.
    fn skip_past_semicolon(&mut self, begins: impl Fn(TokenKind) -> bool) {
        loop {
            match self.kind() {
                TokenKind::Semicolon => {
                    self.bump();
                    return;
                }
                TokenKind::Name if self.is_anew() && begins(self.nth(1)) => return,
                TokenKind::Name if self.at_misspelt_end() || self.at_word("END_UNION") => return,
                TokenKind::LeftParen | TokenKind::LeftBracket => self.open += 1,
                TokenKind::RightParen | TokenKind::RightBracket => self.open = self.open.saturating_sub(1),
                kind if kind.ends_statements() || kind.opens_section() || kind.opens_block() => return,
                _ => {}
            }
            self.bump();
        }
    }

    /// The next token begins a line, and no bracket is open; or one is, but what should have closed it may stand
    /// in a string that was not closed on the line before.
    fn is_anew(&self) -> bool {
        (self.open == 0 || self.previous_kind() == Some(TokenKind::Malformed)) && self.starts_line()
    }

    /// Moves behind `closer`, which ends the broken header of a statement, or up to what cannot belong to the
    /// header any more.
    pub(super) fn skip_header(&mut self, closer: TokenKind) {
        loop {
            match self.kind() {
                kind if kind == closer => {
                    self.bump();
                    return;
                }
                TokenKind::Semicolon => return,
                TokenKind::Name if self.nth(1) == TokenKind::Assign && self.starts_line() => return,
                kind if kind.ends_statements() || kind.opens_section() || kind.opens_statement() => return,
                _ => {
                    self.bump();
                }
            }
        }
    }

    /// The keyword that was meant, and how many tokens are there instead, where `ENDIF`, `END IF` or its like
    /// stands for the end of a statement: with nothing behind it that would make a variable or a call of it.
    pub(super) fn misspelt_end(&self) -> Option<(TokenKind, usize)> {
        use TokenKind::{Assign, Case, Dot, For, If, LeftBracket, LeftParen, Repeat, While};
        if self.kind() != TokenKind::Name {
            return None;
        }
        let (end, rest) = self.word().split_at_checked(3)?;
        if !end.eq_ignore_ascii_case("END") {
            return None;
        }
        let opens = |kind: &TokenKind| match rest {
            "" => self.nth(1) == *kind,
            _ => rest.eq_ignore_ascii_case(kind.text()),
        };
        let opener = [If, Case, For, While, Repeat].into_iter().find(opens)?;
        let used = matches!(self.nth(1), Assign | Dot | LeftParen | LeftBracket);
        let closer = match opener {
            If => TokenKind::EndIf,
            Case => TokenKind::EndCase,
            For => TokenKind::EndFor,
            While => TokenKind::EndWhile,
            _ => TokenKind::EndRepeat,
        };
        (!used).then_some((closer, if rest.is_empty() { 2 } else { 1 }))
    }

    /// Returns whether END_VAR was meant: `END_VAR_INPUT`.
    pub(super) fn at_misspelt_section_end(&self) -> bool {
        let begins = self.word().get(..7);
        begins.is_some_and(|begins| begins.eq_ignore_ascii_case("END_VAR")) && !self.names_a_variable()
    }

    /// Returns whether a keyword opens a section here, or a word that was meant for one: `VAR_CONSTANT` and `VAR_IN` in front of a
    /// declaration.
    pub(super) fn at_section(&self) -> bool {
        let begins = self.word().get(..4);
        let meant = begins.is_some_and(|begins| begins.eq_ignore_ascii_case("VAR_"));
        self.kind().opens_section()
            || self.kind() == TokenKind::Name
                && meant
                && self.nth(1) == TokenKind::Name
                && matches!(self.nth(2), TokenKind::Colon | TokenKind::Comma | TokenKind::At)
    }

    /// Says what is wrong with a word that was meant for the keyword of a section, and returns the section; `None` at a keyword.
    pub(super) fn misspelt_section(&mut self) -> Option<VariableKind> {
        if self.kind() != TokenKind::Name {
            return None;
        }
        let meant = self.word().to_ascii_uppercase();
        match meant.as_str() {
            "VAR_GENERIC" => {
                self.unsupported(self.token().span, &format!("{meant} sections"));
            }
            _ => {
                self.expected("a section such as `VAR`, `VAR CONSTANT` or `VAR_INPUT`");
            }
        }
        Some(match &meant[4..] {
            "IN" | "INPUTS" => VariableKind::Input,
            "OUT" | "OUTPUTS" => VariableKind::Output,
            _ => VariableKind::Local,
        })
    }

    /// Moves to the start of the next line, or to the next section, statement or END_… on this one.
    pub(super) fn skip_line(&mut self) {
        while !self.starts_line() || self.position() == 0 {
            let kind = self.kind();
            if kind.ends_statements() || kind.opens_section() || kind.opens_statement() {
                return;
            }
            self.bump();
        }
    }

    /// Moves behind the END_… of the statement that begins here, or to the end of the POU.
    pub(super) fn skip_block(&mut self) {
        let mut open = 0_usize;
        loop {
            let kind = self.kind();
            if kind == TokenKind::End || kind.closes_pou() || kind.opens_declaration() {
                return;
            }
            self.bump();
            if kind.opens_block() {
                open += 1;
            } else if kind.closes_block() {
                open = open.saturating_sub(1);
                if open == 0 {
                    return;
                }
            }
        }
    }

    /// Moves to the next declaration of the top level.
    pub(super) fn skip_to_declaration(&mut self) {
        while self.kind() != TokenKind::End
            && !self.kind().opens_declaration()
            && !self.at_namespace()
            && self.at_object().is_none()
        {
            self.bump();
        }
    }

    /// Moves to the end of the POU's body.
    pub(super) fn skip_body(&mut self) {
        while self.kind() != TokenKind::End && !self.kind().closes_pou() && !self.kind().opens_declaration() {
            self.bump();
        }
    }

    /// The `;` behind a statement (`swallowed` is `:=`) or a declaration (`:`). Where it is missing, that is said
    /// of the end of what stands before; then reading goes on where the next token begins a line or something
    /// new.
    ///
    /// `x :=`, and on the next line `y := 2;`, read as the value `y` so far: if `swallowed` stands behind such a
    /// name, the name is given back.
    pub(super) fn semicolon(&mut self, swallowed: TokenKind) -> ParseResult<()> {
        if self.eat(TokenKind::Semicolon) {
            return Ok(());
        }
        if self.kind().is_reported() {
            return Err(Broken);
        }
        if self.kind() == swallowed && self.previous_kind() == Some(TokenKind::Name) {
            self.back();
            if self.starts_line() && self.previous_kind() == Some(TokenKind::Assign) {
                return Err(self.expected_at(self.previous_span().after(), "a value"));
            }
            self.bump();
        }
        let broken = self.expected_at(self.previous_span().after(), "`;`");
        let kind = self.kind();
        let resumes = kind.ends_statements() || kind.opens_section() || kind.opens_statement();
        if resumes || self.starts_line() {
            Ok(())
        } else {
            Err(broken)
        }
    }
}
