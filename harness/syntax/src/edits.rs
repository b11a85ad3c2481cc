//! Changes of a text by the places of its parts.

use crate::token::{TokenKind, tokens, words};
use std::collections::HashSet;
use std::ops::Range;
use stickler_types::Dialect;

/// Replacements of ranges of a text, which are applied together.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Edits(Vec<Edit>);

/// A range of a text, in bytes, and what takes its place.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Edit {
    at: Range<usize>,
    with: String,
}

impl Edits {
    /// Returns an empty list of edits.
    pub fn new() -> Edits {
        Edits::default()
    }

    /// Returns one edit: `with` in the place of a range.
    pub fn replacing(at: impl Into<Range<usize>>, with: impl Into<String>) -> Edits {
        let mut edits = Edits::new();
        edits.replace(at, with);
        edits
    }

    /// Returns one edit that removes a range.
    pub fn removing(at: impl Into<Range<usize>>) -> Edits {
        Edits::replacing(at, "")
    }

    /// Adds a replacement of a range; of an empty range it is an insertion.
    pub fn replace(&mut self, at: impl Into<Range<usize>>, with: impl Into<String>) {
        self.0.push(Edit {
            at: at.into(),
            with: with.into(),
        });
    }

    /// Adds the removal of a range.
    pub fn remove(&mut self, at: impl Into<Range<usize>>) {
        self.replace(at, "");
    }

    /// Adds the edits of others.
    pub fn extend(&mut self, others: impl IntoIterator<Item = Edits>) {
        self.0.extend(others.into_iter().flat_map(|edits| edits.0));
    }

    /// Returns whether there is no edit.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns a text with the edits made.
    ///
    /// Of overlapping edits the one that begins first is made, and of two that begin together the longer one; one that does
    /// not fit the text is left out. Two insertions at one place are both made; an insertion where a replacement begins is
    /// left out.
    pub fn apply(&self, text: &str) -> String {
        let mut edits: Vec<&Edit> = self.0.iter().collect();
        edits.sort_by_key(|edit| (edit.at.start, usize::MAX - edit.at.end));
        let mut edited = String::with_capacity(text.len());
        let mut copied = 0;
        for Edit { at, with } in edits {
            let fits = at.start >= copied && at.start <= at.end && text.is_char_boundary(at.end);
            let kept = text.get(copied..at.start).filter(|_| fits);
            if let Some(kept) = kept {
                edited.push_str(kept);
                edited.push_str(with);
                copied = at.end;
            }
        }
        edited.push_str(text.get(copied..).unwrap_or_default());
        edited
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Span;

    #[test]
    fn edits_are_made_in_the_order_of_the_text() {
        let mut edits = Edits::replacing(4..5, "two");
        edits.replace(Span { start: 0, end: 1 }, "one");
        edits.replace(8..8, "!");
        edits.remove(5..6);
        assert_eq!(edits.apply("a b c d "), "one b twod !");
    }

    #[test]
    fn of_overlapping_edits_the_first_and_longest_is_made() {
        let mut edits = Edits::replacing(0..2, "x");
        edits.replace(0..4, "long");
        edits.replace(3..5, "y");
        assert_eq!(edits.apply("abcdef"), "longef");
    }

    #[test]
    fn edits_that_do_not_fit_are_left_out() {
        for at in [7..9, 1..2] {
            assert_eq!(Edits::removing(at).apply("aä"), "aä");
        }
    }
}
