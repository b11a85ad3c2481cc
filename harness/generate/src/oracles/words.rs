//! Words of a source text, found by a scanner that knows only comments, pragmas and character strings; a rendering must not
//! lose, add or change any.
//!
//! Basis: iec-61131-3: Table 3 (comments), Table 4 (pragmas), Tables 5 and 6 (character strings); in the third edition
//! comments nest, and there are `//` and `/* */`.

/// Hashes the words and marks of `text` regardless of their order.
///
/// Names, keywords and numbers are case-insensitive, character strings are not. Left out is what a rendering may choose:
/// blanks, comments (which may be `nested`), pragmas, semicolons, a comma before the end of a list; `&` counts as AND, `.%X3` as `.3`, and a bracket as a
/// parenthesis, since the length of a text may be written between either.
pub(super) fn census(text: &str, nested: bool) -> u64 {
    SourceWords::new(text, nested).fold(0, |sum: u64, word| sum.wrapping_add(word.hash()))
}

/// Returns the words that occur more often in `first` than in `second`.
pub(super) fn missing(first: &str, second: &str, nested: bool) -> Vec<String> {
    let [mut here, mut there] = [first, second].map(|text| {
        SourceWords::new(text, nested)
            .map(|word| word.spelling())
            .collect::<Vec<_>>()
    });
    here.sort_unstable();
    there.sort_unstable();
    let mut there = there.into_iter().peekable();
    here.retain(|word| {
        while there.next_if(|other| other < word).is_some() {}
        there.next_if(|other| other == word).is_none()
    });
    here
}

/// A word or mark.
#[derive(Clone, Copy, Debug)]
enum SourceWord<'t> {
    /// A name, a keyword or the digits of a number.
    Letters(&'t [u8]),
    /// The number of a bit, a byte …; all numbers larger than 64 bits are equal.
    Index(u64),
    /// A character string with its quotes.
    Quoted(&'t [u8]),
    /// Any other character.
    Mark(u8),
}

impl SourceWord<'_> {
    fn hash(self) -> u64 {
        match self {
            // Clearing this bit turns letters into capitals, and keeps digits and the underscore different from them.
            SourceWord::Letters(bytes) => hash(1, bytes, 0xDF),
            SourceWord::Quoted(bytes) => hash(2, bytes, 0xFF),
            SourceWord::Index(index) => hash(3, &index.to_le_bytes(), 0xFF),
            SourceWord::Mark(mark) => hash(4, &[mark], 0xFF),
        }
    }

    fn spelling(self) -> String {
        match self {
            SourceWord::Letters(bytes) => String::from_utf8_lossy(bytes).to_ascii_uppercase(),
            SourceWord::Quoted(bytes) => String::from_utf8_lossy(bytes).into_owned(),
            SourceWord::Index(index) => index.to_string(),
            SourceWord::Mark(mark) => char::from(mark).to_string(),
        }
    }
}

fn hash(kind: u64, bytes: &[u8], mask: u8) -> u64 {
    const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
    let mask = u64::from_le_bytes([mask; 8]);
    let mut hash = (bytes.len() as u64) << 3 | kind;
    for chunk in bytes.chunks(8) {
        let mut eight = [0; 8];
        eight[..chunk.len()].copy_from_slice(chunk);
        hash = (hash ^ (u64::from_le_bytes(eight) & mask)).wrapping_mul(FACTOR);
        hash ^= hash >> 29;
    }
    hash
}

/// A scanner of words.
struct SourceWords<'t> {
    rest: &'t [u8],
    nested: bool,
    /// Whether the word before was a point.
    dotted: bool,
}

impl<'t> SourceWords<'t> {
    fn new(text: &'t str, nested: bool) -> SourceWords<'t> {
        SourceWords {
            rest: text.as_bytes(),
            nested,
            dotted: false,
        }
    }

    /// Takes `length` bytes, or all that are left.
    fn take(&mut self, length: usize) -> &'t [u8] {
        let (taken, rest) = self.rest.split_at(length.min(self.rest.len()));
        self.rest = rest;
        taken
    }

    /// Skips a comment or a pragma that begins here; returns `false` if none does.
    fn skip_remark(&mut self) -> bool {
        let length = match self.rest {
            [b'(', b'*', ..] => self.block(b"(*", b"*)"),
            [b'/', b'*', ..] => self.block(b"/*", b"*/"),
            [b'/', b'/', ..] => position(self.rest, |byte| byte == b'\n'),
            [b'{', ..] => position(self.rest, |byte| byte == b'}') + 1,
            _ => return false,
        };
        self.take(length);
        true
    }

    /// Skips what stands between words.
    fn skip_between(&mut self) {
        loop {
            let blank = position(self.rest, |byte| !byte.is_ascii_whitespace() && byte != b';');
            self.take(blank);
            if !self.skip_remark() {
                return;
            }
        }
    }

    /// Returns the length of a comment with these delimiters.
    fn block(&self, opening: &[u8; 2], closing: &[u8; 2]) -> usize {
        let (mut at, mut depth) = (2, 1);
        while depth > 0 {
            let Some(pair) = self.rest.get(at..at + 2) else {
                return self.rest.len();
            };
            if pair == closing {
                depth -= 1;
            } else if pair == opening && self.nested {
                depth += 1;
            } else {
                at += 1;
                continue;
            }
            at += 2;
        }
        at
    }

    /// Returns the length of a character string with this quote, up to the end of its line if it is not closed.
    fn quoted(&self, quote: u8) -> usize {
        let mut at = 1;
        loop {
            match self.rest.get(at) {
                Some(b'$') => at += 2,
                Some(byte) if *byte == quote => return at + 1,
                Some(b'\n') | None => return at,
                Some(_) => at += 1,
            }
        }
    }

    /// Reads the number of a bit after a point, with `%X` or without.
    fn index(&mut self) -> Option<SourceWord<'t>> {
        let prefix = match self.rest {
            [b'%', b'x' | b'X', ..] => 2,
            [b'%', ..] => 1,
            _ => 0,
        };
        let digits = self.rest.get(prefix..).unwrap_or_default();
        let digits = &digits[..position(digits, |byte| !is_word(byte))];
        if digits.is_empty() || !digits.iter().all(|byte| byte.is_ascii_digit() || *byte == b'_') {
            return None;
        }
        self.take(prefix + digits.len());
        let value = |index: u64, digit: &u8| index.saturating_mul(10).saturating_add(u64::from(digit - b'0'));
        Some(SourceWord::Index(
            digits.iter().filter(|byte| **byte != b'_').fold(0, value),
        ))
    }
}

impl<'t> Iterator for SourceWords<'t> {
    type Item = SourceWord<'t>;

    fn next(&mut self) -> Option<SourceWord<'t>> {
        self.skip_between();
        if let Some(rest) = self.rest.strip_prefix(b",") {
            let comma = std::mem::replace(&mut self.rest, rest);
            self.skip_between();
            if !self.rest.starts_with(b")") {
                self.rest = comma;
            }
        }
        let first = *self.rest.first()?;
        if std::mem::take(&mut self.dotted)
            && let Some(index) = self.index()
        {
            return Some(index);
        }
        self.dotted = first == b'.';
        Some(match first {
            b'&' => {
                self.take(1);
                SourceWord::Letters(b"AND")
            }
            b'\'' | b'"' => SourceWord::Quoted(self.take(self.quoted(first))),
            b'[' | b']' => {
                self.take(1);
                SourceWord::Mark(if first == b'[' { b'(' } else { b')' })
            }
            _ if is_word(first) => SourceWord::Letters(self.take(position(self.rest, |byte| !is_word(byte)))),
            _ => {
                self.take(1);
                SourceWord::Mark(first)
            }
        })
    }
}

/// Returns the index of the first byte for which `is` holds, or the length.
fn position(bytes: &[u8], is: impl Fn(u8) -> bool) -> usize {
    bytes.iter().position(|byte| is(*byte)).unwrap_or(bytes.len())
}

const fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_rendering_may_choose_does_not_count() {
        let text = "x := a.%X03 & f(b, {} ); (* it's (* nested *) *) { p } s := 'a;''(*' // end";
        let rendered = "X:=A.3 AND F(B) S := 'a;''(*'";
        assert_eq!(missing(text, rendered, true), [""; 0]);
        assert_eq!(census(text, true), census(rendered, true));
    }

    #[test]
    fn a_word_more_or_less_counts() {
        for (first, second, missed) in [
            ("a b a", "a b", "A"),
            ("a + b", "a b", "+"),
            ("'a'", "'A'", "'a'"),
            ("x.3", "x.4", "3"),
            ("16#F", "16#G", "F"),
        ] {
            assert_eq!(missing(first, second, false), [missed]);
            assert_ne!(census(first, false), census(second, false));
        }
    }

    #[test]
    fn what_is_not_closed_goes_to_the_end() {
        for text in ["a (* b", "a /* b", "a { b", "a // b", "a (* b (* c *)"] {
            assert_eq!(census(text, true), census("a", true), "{text}");
        }
        assert_eq!(missing("'a\nb", "b", false), ["'a"]);
        assert_eq!(missing("'$", "", false), ["'$"]);
    }
}
