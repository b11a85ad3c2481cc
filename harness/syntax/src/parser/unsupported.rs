//! Constructs of the standard, or of what is often taken for it, that are not implemented: each construct is
//! named in one diagnostic, and reading goes on behind it. The words are no keywords here, so that they remain
//! names where they cannot begin the construct.

use super::state::{Broken, ParseResult, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::CaseFolded;
use stickler_types::Code;

/// Words that begin an instruction of an instruction list.
const INSTRUCTIONS: [&str; 12] = [
    "LD", "LDN", "ST", "STN", "S", "R", "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN",
];

/// Words that begin an element of a sequential function chart.
const CHART: [&str; 4] = ["STEP", "INITIAL_STEP", "TRANSITION", "ACTION"];

impl<'s> Parser<'s, '_> {
    /// Says that the construct at `span` is not implemented; `features` names its kind in the plural.
    #[cold]
    pub(super) fn unsupported(&mut self, span: Span, features: &str) {
        self.report(Code::NotImplemented, span, || {
            format!("{features} are not implemented")
        });
    }

    pub(super) fn at_any_word(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.at_word(word))
    }

    /// VAR_ACCESS, up to its END_VAR.
    pub(super) fn unsupported_section(&mut self) {
        let token = self.bump();
        self.unsupported(token.span, &format!("{} sections", token.kind.text()));
        while !self.kind().ends_statements() && !self.kind().opens_section() {
            self.bump();
        }
        self.eat(TokenKind::EndVar);
    }

    /// `AT` and a location where none is implemented: without a name, in a structure, or by the name of a variable.
    pub(super) fn unsupported_location(&mut self) {
        if self.kind() == TokenKind::At {
            let start = self.bump().span;
            use TokenKind::{Direct, Name, Unknown};
            if matches!(self.kind(), Direct | Unknown | Name) {
                self.bump();
            }
            let features = "locations (`AT`) of anything but a variable of a section";
            self.unsupported(start.to(self.previous_span()), features);
        }
    }

    /// `<T: ANY>` behind the name of a function.
    pub(super) fn unsupported_generics(&mut self) {
        if self.kind() == TokenKind::Less {
            let start = self.bump().span;
            while matches!(self.kind(), TokenKind::Name | TokenKind::Colon | TokenKind::Comma) {
                self.generics.insert(CaseFolded(self.word()));
                self.bump();
            }
            self.eat(TokenKind::Greater);
            self.unsupported(
                start.to(self.previous_span()),
                "types as parameters of functions (`<T: ANY>`)",
            );
        }
    }

    /// Recognizes what begins with a name, stands where a statement is expected, and is none: an instruction list, or an
    /// element of a chart.
    pub(super) fn unsupported_statement(&mut self) -> ParseResult<()> {
        let next = self.nth(1);
        let start = self.token().span;
        if (next == TokenKind::Name || next == TokenKind::Direct || next.is_literal())
            && self.at_any_word(&INSTRUCTIONS)
            && !(self.at_any_word(&["S", "R"]) && self.nth(2) == TokenKind::Equal)
        {
            self.unsupported(start, "instruction lists");
            self.skip_body();
            return Err(Broken);
        }
        if matches!(next, TokenKind::Name | TokenKind::LeftParen) && self.at_any_word(&CHART) {
            // A chart begins with a step.
            self.unsupported(
                start,
                match self.at_word("ACTION") {
                    true => "actions (ACTION) of programs and function blocks",
                    false => "sequential function charts (STEP, TRANSITION, ACTION)",
                },
            );
            self.incomplete = true;
            self.skip_body();
            return Err(Broken);
        }
        Ok(())
    }

    /// `?=`, `S=` or `R=` behind the variable that begins at `start`.
    pub(super) fn unsupported_assignment(&mut self, start: Span) -> ParseResult<()> {
        let features = match self.kind() {
            TokenKind::AssignAttempt => "assignment attempts (`?=`)",
            TokenKind::Name if self.nth(1) == TokenKind::Equal && self.at_any_word(&["S", "R"]) => {
                "set and reset assignments (`S=`, `R=`)"
            }
            _ => return Ok(()),
        };
        self.unsupported(start.to(self.token().span), features);
        Err(Broken)
    }

    /// Arguments behind the type of a program instance.
    pub(super) fn unsupported_connections(&mut self) {
        if self.kind() == TokenKind::LeftParen {
            let start = self.bump().span;
            while !matches!(self.kind(), TokenKind::RightParen | TokenKind::Semicolon)
                && !self.kind().ends_statements()
            {
                self.bump();
            }
            self.eat(TokenKind::RightParen);
            self.unsupported(start.to(self.previous_span()), "connections of program instances");
        }
    }
}
