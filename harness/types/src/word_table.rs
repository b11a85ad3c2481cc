//! A table that keeps each word of a report or a data set once, under a number.

use std::collections::HashMap;

/// A table of words that keeps each word once, under a number.
#[derive(Debug, Default)]
pub struct WordTable {
    numbers: HashMap<String, u32>,
    words: Vec<String>,
}

impl WordTable {
    /// Returns the number of a word, which is added where it is new.
    pub fn number(&mut self, word: &str) -> u32 {
        if let Some(number) = self.numbers.get(word) {
            return *number;
        }
        // A run has fewer events than `u32` has values.
        let number = u32::try_from(self.words.len()).unwrap_or(u32::MAX);
        self.words.push(word.to_owned());
        self.numbers.insert(word.to_owned(), number);
        number
    }

    /// Returns the word of a number; empty for a number that no word has.
    #[must_use]
    pub fn word(&self, number: u32) -> &str {
        self.words.get(number as usize).map_or("", String::as_str)
    }

    /// Returns all words in the order of their numbers.
    #[must_use]
    pub fn all(&self) -> &[String] {
        &self.words
    }
}
