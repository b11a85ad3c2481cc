//! Changes of a text by the places of its parts.

use std::ops::Range;

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
