//! A table that keeps each word of a report or a data set once, under a number.

use indexmap::IndexSet;

/// A table of words that keeps each word once, under a number.
#[derive(Debug, Default)]
pub struct WordTable(IndexSet<String>);

impl WordTable {
    /// Returns the number of a word, which is added where it is new.
    pub fn number(&mut self, word: &str) -> u32 {
        let known = self.0.get_index_of(word);
        let number = known.unwrap_or_else(|| self.0.insert_full(word.to_owned()).0);
        // A run has fewer events than `u32` has values.
        u32::try_from(number).unwrap_or(u32::MAX)
    }

    /// Returns the word of a number; empty for a number that no word has.
    pub fn word(&self, number: u32) -> &str {
        self.0.get_index(number as usize).map_or("", String::as_str)
    }

    /// Returns all words in the order of their numbers.
    pub fn all(&self) -> impl ExactSizeIterator<Item = &String> {
        self.0.iter()
    }
}
