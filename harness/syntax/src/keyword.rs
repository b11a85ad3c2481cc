//! Recognizes keywords: one probe of a table whose hash is free of collisions, without allocation.

use super::token::{TokenKind, keywords};

macro_rules! list {
    ($($kind:ident = $text:literal,)*) => { &[$((TokenKind::$kind, $text)),*] };
}

/// The keywords and their kinds.
const KEYWORDS: &[(TokenKind, &str)] = keywords!(list);

/// The length of `END_FUNCTION_BLOCK`.
const MAX_LEN: usize = 18;

const SLOTS: usize = 256;

/// The index in [`KEYWORDS`] of the keyword with each hash, or `u8::MAX`.
const TABLE: [u8; SLOTS] = table();

/// A hash of a word's length and of three of its letters, without regard to case. The factors were found by
/// trial: [`table`] does not compile where two keywords share a slot.
const fn hash(word: &[u8]) -> usize {
    let length = word.len();
    let first = (word[0] & 0x1F) as usize;
    let last = (word[length - 1] & 0x1F) as usize;
    let middle = (word[length * 2 / 3] & 0x1F) as usize;
    (first * FACTORS.0 + last * FACTORS.1 + middle * FACTORS.2 + length * FACTORS.3) % SLOTS
}

const FACTORS: (usize, usize, usize, usize) = (129, 94, 108, 232);

const fn table() -> [u8; SLOTS] {
    let mut table = [u8::MAX; SLOTS];
    let mut index = 0;
    while index < KEYWORDS.len() {
        let slot = hash(KEYWORDS[index].1.as_bytes());
        assert!(table[slot] == u8::MAX, "two keywords share a slot");
        table[slot] = index as u8;
        index += 1;
    }
    table
}

/// The kind of `word`, which is not empty: a keyword in any ASCII case, or a name.
#[inline]
pub(super) fn classify(word: &[u8]) -> TokenKind {
    if !(2..=MAX_LEN).contains(&word.len()) {
        return TokenKind::Name;
    }
    match KEYWORDS.get(usize::from(TABLE[hash(word)])) {
        Some((kind, text)) if text.as_bytes().eq_ignore_ascii_case(word) => *kind,
        _ => TokenKind::Name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_is_found_in_any_case() {
        for (kind, text) in KEYWORDS {
            assert_eq!(classify(text.as_bytes()), *kind);
            assert_eq!(classify(text.to_lowercase().as_bytes()), *kind);
            assert_eq!(classify(format!("{text}_").as_bytes()), TokenKind::Name);
            assert!(text.len() <= MAX_LEN && kind.is_keyword());
        }
    }

    #[test]
    fn other_words_are_names() {
        for word in "x _ step class end INT ENDIF a_name_longer_than_any_keyword".split(' ') {
            assert_eq!(classify(word.as_bytes()), TokenKind::Name, "{word}");
        }
    }
}
