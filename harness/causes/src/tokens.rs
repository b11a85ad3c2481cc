//! The tokens of a program of any dialect, also of one that nobody can read, with their lines and columns.

use std::sync::LazyLock;
use stickler_syntax::source::LineIndex;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::SourceUnit;
use stickler_types::{Dialect, DialectName};

/// A token with its place in the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ProgramToken<'t> {
    pub(crate) kind: ProgramTokenKind,
    pub(crate) text: &'t str,
    /// The place of its first byte in the text.
    pub(crate) start: usize,
    /// The line, from 1.
    pub(crate) line: u32,
    /// The column, from 1, in characters.
    pub(crate) column: u32,
    /// Whether it is the name of a directly represented variable where that is declared: `x` of `x AT %MW5 : INT;`.
    pub(crate) is_located: bool,
}

/// The kind of a token.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ProgramTokenKind {
    /// A keyword, the name of a type, or another name.
    Word,
    /// A number without a type: `5`, `16#FF`, `1.0E300`.
    Number,
    /// A literal with a prefix: `INT#5`, `T#5ms`, `STRING#'a'`.
    Typed,
    /// A character string.
    Text,
    /// `%X7` and its like.
    Partial,
    /// An operator or another sign.
    Sign,
}

impl ProgramToken<'_> {
    /// Returns whether the token is this word, in any case of letters.
    pub(crate) fn is(&self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word)
    }

    /// Returns the place behind its last byte in the text.
    pub(crate) fn end(&self) -> usize {
        self.start + self.text.len()
    }
}

/// Rules by which comments do not nest, so that the ends of those that stand in others are left, by which they are seen.
static UNNESTED: LazyLock<Dialect> = LazyLock::new(|| Dialect {
    nested_comments: false,
    ..Dialect::of(DialectName::IRONPLC_ED3).clone()
});

/// Returns the tokens of a text. Comments and blanks are left out, and locations, so that the type of each variable stands behind its name.
pub(crate) fn tokens(text: &str) -> Vec<ProgramToken<'_>> {
    let lines = LineIndex::new(text);
    let mut found: Vec<ProgramToken<'_>> = Vec::new();
    for token in stickler_syntax::tokens(text, &UNNESTED).list {
        let here = token.span.text(text);
        let place = lines.position(text, token.span.start);
        found.push(ProgramToken {
            kind: kind(token.kind, here),
            text: here,
            start: token.span.start as usize,
            line: place.line,
            column: place.column,
            is_located: false,
        });
        if let [.., name, at, location] = &mut found[..]
            && location.text.starts_with('%')
            && at.is("AT")
        {
            name.is_located = true;
            found.truncate(found.len() - 2);
        }
    }
    found
}

/// Returns the tree of a program of any dialect; what no dialect has is left out.
pub(crate) fn parsed(program: &str) -> SourceUnit<'_> {
    stickler_syntax::parse(program, Dialect::of(DialectName::IRONPLC_ED3)).0
}

/// Returns the kind of a token; one that is malformed is what it begins like.
fn kind(kind: TokenKind, text: &str) -> ProgramTokenKind {
    let begins = |is: fn(char) -> bool| text.starts_with(is);
    match kind {
        TokenKind::Partial | TokenKind::Direct => ProgramTokenKind::Partial,
        _ if begins(|first| matches!(first, '\'' | '"')) => ProgramTokenKind::Text,
        _ if begins(|first| first.is_ascii_digit()) => ProgramTokenKind::Number,
        _ if !begins(|first| first.is_alphabetic() || first == '_') => ProgramTokenKind::Sign,
        _ if text.contains('#') => ProgramTokenKind::Typed,
        _ => ProgramTokenKind::Word,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_told_apart_by_what_they_are() {
        use ProgramTokenKind::{Number, Partial, Sign, Text, Typed, Word};
        let text = "x-1.0E+5 INT#-5 (* c *) T#1d2h D#2024-02-29 'it$'s' .%X7 16#FF 'open";
        let found: Vec<_> = tokens(text)
            .iter()
            .map(|token| (token.text, token.kind))
            .collect();
        let expected = [
            ("x", Word),
            ("-", Sign),
            ("1.0E+5", Number),
            ("INT#-5", Typed),
            ("T#1d2h", Typed),
            ("D#2024-02-29", Typed),
            ("'it$'s'", Text),
            (".", Sign),
            ("%X7", Partial),
            ("16#FF", Number),
            ("'open", Text),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_location_is_a_mark_of_its_variable() {
        let found = tokens("x AT %IX0.1 : BOOL;\n y AT %mw5 : INT; w.%W1 := z");
        let texts: Vec<&str> = found.iter().map(|token| token.text).collect();
        assert_eq!(texts[..8], ["x", ":", "BOOL", ";", "y", ":", "INT", ";"]);
        let located = found.iter().filter(|token| token.is_located);
        assert!(
            located
                .map(|token| (token.text, token.line, token.column))
                .eq([("x", 1, 1), ("y", 2, 2)])
        );
    }
}
