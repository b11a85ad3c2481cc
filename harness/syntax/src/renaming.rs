//! Renames the names of a program, so that they differ from those of every other program in one text.

use crate::token::TokenKind;
use crate::{Edits, tokens, words};
use std::collections::HashSet;
use stickler_types::Dialect;

/// The suffixes for the names of a program.
pub struct Renaming<'n> {
    /// The dialect of the program.
    pub dialect: &'n Dialect,
    /// The names of the program's POUs, types and enumerated values, in capitals, and their suffix.
    pub units: (&'n HashSet<String>, String),
    /// The names of the program's variables, in capitals, and their suffix; `None` in the text of a POU.
    pub variables: Option<(&'n HashSet<String>, String)>,
}

impl Renaming<'_> {
    /// Returns a text with its names changed.
    ///
    /// A name after a point is that of a field, and one before `:=` or `=>` in a call or a list of fields that of a parameter
    /// or field: neither is a variable, even where a variable has the same name.
    pub fn of(&self, text: &str) -> String {
        let mut edits = Edits::new();
        let is_of = |names: &HashSet<String>, word: &str| names.contains(&word.to_ascii_uppercase());
        let (units, suffix) = &self.units;
        for word in words(text, self.dialect).filter(|word| is_of(units, word.text)) {
            edits.replace(word.span.after(), &**suffix);
        }
        let Some((variables, suffix)) = &self.variables else {
            return edits.apply(text);
        };
        let mut before = None;
        let mut depth = 0_u32;
        let mut tokens = tokens(text, self.dialect).list.into_iter().peekable();
        while let Some(token) = tokens.next() {
            let behind = tokens.peek().map(|token| token.kind);
            let opens = matches!(before, Some(TokenKind::LeftParen | TokenKind::Comma));
            let takes = matches!(behind, Some(TokenKind::Assign | TokenKind::Arrow));
            let is_parameter = depth > 0 && opens && takes;
            let name = token.span.text(text);
            match token.kind {
                TokenKind::LeftParen => depth += 1,
                TokenKind::RightParen => depth = depth.saturating_sub(1),
                TokenKind::Name if before == Some(TokenKind::Dot) || is_parameter => {}
                TokenKind::Name if is_of(variables, name) && !is_of(units, name) => {
                    edits.replace(token.span.after(), &**suffix);
                }
                _ => {}
            }
            before = Some(token.kind);
        }
        edits.apply(text)
    }
}
