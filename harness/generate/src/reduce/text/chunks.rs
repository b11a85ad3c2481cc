//! Text dropped without a look at what it means: comments, lines, words, characters.
//!
//! For texts that nobody can parse this is all there is. For others it takes what the passes over the tree have no name for;
//! nearly every such candidate is refused by the reference, which costs no try.

use super::draft::{Change, Draft};
use crate::reduce::Sites;
use std::ops::Range;

/// A text that cannot be read is cut into characters only up to this length; beyond, lines and words must do.
const MOST_CHARACTERS: usize = 2000;

/// Drops comments.
pub(super) fn drop_comments(draft: &mut Draft, sites: &mut Sites) {
    draft.change("comments", sites, |draft| {
        comments(&draft.text)
            .into_iter()
            .map(|at| Change::of(at, " "))
            .collect()
    });
}

/// Drops lines.
pub(super) fn drop_lines(draft: &mut Draft, sites: &mut Sites) {
    draft.change("lines", sites, |draft| {
        let mut at = 0;
        let lines = draft.text.split_inclusive('\n').map(|line| {
            at += line.len();
            Change::drop(at - line.len()..at)
        });
        worth_trying(draft, lines.collect())
    });
}

/// Drops words and signs.
pub(super) fn drop_words(draft: &mut Draft, sites: &mut Sites) {
    draft.change("words", sites, |draft| {
        let changes = words(&draft.text).into_iter().map(Change::drop);
        worth_trying(draft, changes.collect())
    });
}

/// Drops characters, of texts that cannot be read.
pub(super) fn drop_characters(draft: &mut Draft, sites: &mut Sites) {
    draft.change("characters", sites, |draft| {
        if !draft.began_unreadable() || draft.text.len() > MOST_CHARACTERS {
            return Vec::new();
        }
        let characters = draft.text.char_indices();
        let places = characters.map(|(at, character)| at..at + character.len_utf8());
        draft.only_allowed(places.map(Change::drop).collect())
    });
}

/// Drops sections between whose first and last word nothing is left.
pub(super) fn drop_empty_sections(draft: &mut Draft, sites: &mut Sites) {
    draft.change("empty sections", sites, |draft| {
        let words = words(&draft.text);
        let pairs = words.windows(2).filter_map(|pair| {
            let [open, close] = pair else { return None };
            let is = |at: &Range<usize>, word: &str| draft.text[at.clone()].eq_ignore_ascii_case(word);
            (is(open, "TYPE") && is(close, "END_TYPE")).then(|| Change::drop(open.start..close.end))
        });
        pairs.collect()
    });
}

/// Of a text that was accepted, only what can go alone: much together would nearly always be refused.
fn worth_trying(draft: &Draft, changes: Vec<Change>) -> Vec<Change> {
    if draft.began_accepted() {
        draft.only_allowed(changes)
    } else {
        changes
    }
}

/// The places of comments: `(* … *)`, not nested, and `// …`; those in character strings are none.
fn comments(text: &str) -> Vec<Range<usize>> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(byte) = bytes.get(at) {
        let rest = &text.as_bytes()[at..];
        at += match byte {
            b'\'' | b'"' => string_length(rest),
            b'(' if rest.starts_with(b"(*") => {
                let length = end_of(rest, b"*)", 2);
                found.push(at..at + length);
                length
            }
            b'/' if rest.starts_with(b"//") => {
                let length = rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len());
                found.push(at..at + length);
                length
            }
            _ => 1,
        };
    }
    found
}

/// The length up to and with `end`, which is sought from `from` on.
fn end_of(bytes: &[u8], end: &[u8], from: usize) -> usize {
    let rest = bytes.get(from..).unwrap_or_default();
    let found = rest.windows(end.len()).position(|window| window == end);
    found.map_or(bytes.len(), |at| from + at + end.len())
}

/// The length of a character string, its quotes included; it ends with its line at the latest.
fn string_length(bytes: &[u8]) -> usize {
    let quote = bytes.first().copied();
    let mut at = 1;
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'$' => at += 2,
            b'\n' => return at,
            byte if Some(*byte) == quote => return at + 1,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Words, and every other character that is no blank by itself.
pub(super) fn words(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut in_word = false;
    for (at, character) in text.char_indices() {
        let end = at + character.len_utf8();
        let is_word = character.is_alphanumeric() || character == '_' || character == '#';
        match found.last_mut() {
            Some(last) if is_word && in_word => last.end = end,
            _ if character.is_whitespace() => {}
            _ => found.push(at..end),
        }
        in_word = is_word;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{comments, words};

    #[test]
    fn comments_are_found_and_strings_are_none() {
        let text = "a (* x *) '(* $' *)' // y\nb (* open";
        let found: Vec<&str> = comments(text).into_iter().map(|at| &text[at]).collect();
        assert_eq!(found, ["(* x *)", "// y", "(* open"]);
    }

    #[test]
    fn words_are_whole_and_signs_stand_alone() {
        let text = "x := INT#5;";
        let found: Vec<&str> = words(text).into_iter().map(|at| &text[at]).collect();
        assert_eq!(found, ["x", ":", "=", "INT#5", ";"]);
    }
}
