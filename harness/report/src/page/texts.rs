//! A table of texts of several lines, which keeps each text and each line once.

use indexmap::IndexSet;
use stickler_types::WordTable;

/// The maximum number of bytes of all lines and texts; what does not fit is counted and left out, so that the page stays small
/// whatever a foreign engine prints.
const MAX_BYTES: usize = 7 << 19;

/// A table of texts. Programs of one probe have most of their lines in common, and dialects most of their programs.
#[derive(Default)]
pub(super) struct TextTable {
    /// The lines of all texts, and words that are no text of their own.
    pub(super) words: WordTable,
    texts: IndexSet<Vec<u32>>,
    /// The number of bytes that were added.
    bytes: usize,
    /// The number of texts that found no room.
    left_out: u64,
}

/// The number of a text in the table; `None` for a text that is not there.
pub(super) type TextNumber = Option<u32>;

impl TextTable {
    /// Returns the number of a text, which is added where it is new and the table has room for it.
    pub(super) fn number(&mut self, text: &str) -> TextNumber {
        if self.bytes > MAX_BYTES {
            self.left_out += 1;
            return None;
        }
        let known = self.words.all().len();
        let lines: Vec<u32> = text.lines().map(|line| self.words.number(line)).collect();
        let new = self.words.all().skip(known);
        self.bytes += new.map(|line| line.len() + 3).sum::<usize>();
        let length = lines.len();
        let (number, is_new) = self.texts.insert_full(lines);
        if is_new {
            self.bytes += 6 * length;
        }
        u32::try_from(number).ok()
    }

    /// Returns the words, the texts as numbers of words, and how many texts were left out.
    pub(super) fn into_parts(self) -> (WordTable, Vec<Vec<u32>>, u64) {
        (self.words, self.texts.into_iter().collect(), self.left_out)
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_BYTES, TextTable};

    #[test]
    fn a_text_and_a_line_are_kept_once() {
        let mut texts = TextTable::default();
        let numbers = ["a\nb", "a\nb\n", "b\nc", ""].map(|text| texts.number(text));
        assert_eq!(numbers, [Some(0), Some(0), Some(1), Some(2)]);
        let (words, texts, left_out) = texts.into_parts();
        assert!(words.all().eq(["a", "b", "c"]));
        assert_eq!((texts, left_out), (vec![vec![0, 1], vec![1, 2], vec![]], 0));
    }

    #[test]
    fn what_finds_no_room_is_counted() {
        let mut texts = TextTable::default();
        let huge = "x".repeat(MAX_BYTES);
        assert_eq!(texts.number(&huge), Some(0));
        assert_eq!(texts.number("a"), None);
        assert_eq!(texts.into_parts().2, 1);
    }
}
