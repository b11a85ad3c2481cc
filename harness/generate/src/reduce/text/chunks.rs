//! Passes that drop text regardless of its meaning: comments, lines, words, characters.
//!
//! For texts that cannot be parsed these are the only passes. For others they remove what the passes over the tree do not
//! know; the reference refuses nearly every such candidate, which costs no try.

use super::draft::{TextChange, TextDraft};
use super::words::{comments, words};
use crate::reduce::Sites;
use std::ops::Range;

/// The maximum length of an unreadable text that is reduced by characters; a longer one is reduced by lines and words only.
const MAX_CHARACTERS: usize = 2000;

/// Drops comments.
pub(super) fn drop_comments(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("comments", sites, |draft| {
        comments(&draft.text)
            .into_iter()
            .map(|at| TextChange::of(at, " "))
            .collect()
    });
}

/// Drops lines.
pub(super) fn drop_lines(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("lines", sites, |draft| {
        let mut at = 0;
        let lines = draft.text.split_inclusive('\n').map(|line| {
            at += line.len();
            TextChange::drop(at - line.len()..at)
        });
        worth_trying(draft, lines.collect())
    });
}

/// Drops words and signs.
pub(super) fn drop_words(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("words", sites, |draft| {
        let changes = words(&draft.text).into_iter().map(TextChange::drop);
        worth_trying(draft, changes.collect())
    });
}

/// Drops characters of texts that cannot be read.
pub(super) fn drop_characters(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("characters", sites, |draft| {
        if !draft.began_unreadable() || draft.text.len() > MAX_CHARACTERS {
            return Vec::new();
        }
        let characters = draft.text.char_indices();
        let places = characters.map(|(at, character)| at..at + character.len_utf8());
        draft.only_allowed(places.map(TextChange::drop).collect())
    });
}

/// Drops sections with nothing between their first and last word.
pub(super) fn drop_empty_sections(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("empty sections", sites, |draft| {
        let words = words(&draft.text);
        let pairs = words.windows(2).filter_map(|pair| {
            let [open, close] = pair else { return None };
            let is = |at: &Range<usize>, word: &str| draft.text[at.clone()].eq_ignore_ascii_case(word);
            (is(open, "TYPE") && is(close, "END_TYPE")).then(|| TextChange::drop(open.start..close.end))
        });
        pairs.collect()
    });
}

/// Keeps the changes worth a try: for an accepted text only those that can be made alone, because larger groups would nearly
/// always be refused.
fn worth_trying(draft: &TextDraft, changes: Vec<TextChange>) -> Vec<TextChange> {
    if draft.began_accepted() {
        draft.only_allowed(changes)
    } else {
        changes
    }
}
