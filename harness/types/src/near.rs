//! Suggestions for misspelled words, and lists of words for messages.

use std::borrow::Borrow;
use std::fmt::Display;

/// The greatest edit distance at which a word is taken for a misspelling of another.
const NEAR: usize = 2;

/// Returns the most similar of `words`, if one is similar enough to `word`.
pub fn nearest<'w>(word: &str, words: impl IntoIterator<Item = &'w str>) -> Option<&'w str> {
    let lower = word.to_lowercase();
    words
        .into_iter()
        .map(|known| (strsim::damerau_levenshtein(&lower, &known.to_lowercase()), known))
        // A word of three letters is near every other of three.
        .filter(|(distance, known)| *distance <= NEAR && *distance * 2 < known.chars().count().max(2))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, known)| known)
}

/// Formats a list of words, each between backquotes: `a`, `b` and `c`.
pub fn list<'w>(words: impl IntoIterator<Item = &'w str>) -> String {
    let words: Vec<String> = words.into_iter().map(|word| format!("`{word}`")).collect();
    match words.is_empty() {
        true => "nothing".to_owned(),
        false => joined(&words, "and"),
    }
}

/// Joins words as prose does, with a word such as `and` before the last: a, b and c.
pub fn joined<W: Borrow<str>>(words: &[W], conjunction: &str) -> String {
    match words {
        [others @ .., last] if !others.is_empty() => {
            format!("{} {conjunction} {}", others.join(", "), last.borrow())
        }
        few => few.join(""),
    }
}

/// Formats items with a separator between them.
pub fn join(items: impl IntoIterator<Item: Display>, separator: &str) -> String {
    let texts: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    texts.join(separator)
}

/// Returns a suggestion for an unknown word: the most similar of `words`, or all of them.
pub fn advice(word: &str, words: &[&str]) -> String {
    match nearest(word, words.iter().copied()) {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there is {}", list(words.iter().copied())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_with_a_slip_is_known_and_another_word_is_not() {
        let words = ["check", "compile", "cc", "lib"];
        assert_eq!(nearest("chek", words), Some("check"));
        assert_eq!(nearest("Complie", words), Some("compile"));
        assert_eq!(nearest("ironplc", words), None);
        assert_eq!(nearest("cx", words), None);
        assert_eq!(nearest("lib2", words), Some("lib"));
        assert_eq!(nearest("", words), None);
    }

    #[test]
    fn advice_names_one_word_or_all() {
        assert_eq!(advice("chek", &["check", "run"]), "did you mean `check`?");
        assert_eq!(advice("colour", &["check", "run"]), "there is `check` and `run`");
        assert_eq!(list([]), "nothing");
    }
}
