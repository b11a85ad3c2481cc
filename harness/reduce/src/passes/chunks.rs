//! Passes that drop text regardless of its meaning: comments, lines, tokens, characters.
//!
//! For texts that cannot be parsed these are the only passes. For others they remove what the passes over the tree do not
//! know; nearly every such candidate breaks a rule, which costs no try.

use crate::TextView;
use crate::rules::TextState;
use stickler_syntax::Edits;
use stickler_syntax::token::TokenKind;

/// The maximum length of an unreadable text that is reduced by characters; a longer one is reduced by lines and tokens only.
const MAX_CHARACTERS: usize = 2000;

/// Drops comments.
pub(crate) fn drop_comments(view: &TextView<'_>) -> Vec<Edits> {
    let comments = view.tokens.comments.iter();
    comments.map(|at| Edits::replacing(*at, " ")).collect()
}

/// Drops lines.
pub(crate) fn drop_lines(view: &TextView<'_>) -> Vec<Edits> {
    let mut at = 0;
    let lines = view.text().split_inclusive('\n').map(|line| {
        at += line.len();
        Edits::removing(at - line.len()..at)
    });
    worth_trying(view, lines.collect())
}

/// Drops tokens.
pub(crate) fn drop_tokens(view: &TextView<'_>) -> Vec<Edits> {
    let tokens = view.tokens.list.iter();
    worth_trying(view, tokens.map(|token| Edits::removing(token.span)).collect())
}

/// Drops characters of texts that cannot be read.
pub(crate) fn drop_characters(view: &TextView<'_>) -> Vec<Edits> {
    if view.draft.rules().start() != TextState::Unreadable || view.text().len() > MAX_CHARACTERS {
        return Vec::new();
    }
    let characters = view.text().char_indices();
    let places = characters.map(|(at, character)| Edits::removing(at..at + character.len_utf8()));
    view.only_allowed(places.collect())
}

/// Drops sections with nothing between their first and last word.
pub(crate) fn drop_empty_sections(view: &TextView<'_>) -> Vec<Edits> {
    let pairs = view.tokens.list.windows(2).filter_map(|pair| match pair {
        [open, close] if (open.kind, close.kind) == (TokenKind::Type, TokenKind::EndType) => {
            Some(Edits::removing(open.span.start as usize..close.span.end as usize))
        }
        _ => None,
    });
    pairs.collect()
}

/// Keeps the changes worth a try: for an accepted text only those that can be made alone, because larger groups would nearly
/// always be refused.
fn worth_trying(view: &TextView<'_>, changes: Vec<Edits>) -> Vec<Edits> {
    match view.draft.rules().start() {
        TextState::Accepted => view.only_allowed(changes),
        TextState::Rejected | TextState::Unreadable => changes,
    }
}
