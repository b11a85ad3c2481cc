//! Comments and words of a source text, found without a parser.

use std::ops::Range;

/// Returns the ranges of comments outside character strings: `(* … *)`, not nested, and `// …`.
pub(super) fn comments(text: &str) -> Vec<Range<usize>> {
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

/// Returns the length up to the end of `end`, which is searched from `from` on.
fn end_of(bytes: &[u8], end: &[u8], from: usize) -> usize {
    let rest = bytes.get(from..).unwrap_or_default();
    let found = rest.windows(end.len()).position(|window| window == end);
    found.map_or(bytes.len(), |at| from + at + end.len())
}

/// Returns the length of a character string with its quotes; it ends with its line at the latest.
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

/// Returns the ranges of words, and of every other character that is no blank by itself. A number with a fraction and an exponent
/// is one word: a part of it is another kind of literal.
pub(super) fn words(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut in_word = false;
    for (at, character) in text.char_indices() {
        let end = at + character.len_utf8();
        let continues = || {
            let word = found.last().map_or("", |last| &text[last.clone()]);
            in_word && continues_number(word, character, &text[end..])
        };
        let is_word = character.is_alphanumeric() || character == '_' || character == '#' || continues();
        match found.last_mut() {
            Some(last) if is_word && in_word => last.end = end,
            _ if character.is_whitespace() => {}
            _ => found.push(at..end),
        }
        in_word = is_word;
    }
    found
}

/// Returns whether a sign belongs to the number that a word begins: the point of a fraction, the sign of an exponent.
fn continues_number(word: &str, sign: char, behind: &str) -> bool {
    let digits = word.rsplit('#').next().unwrap_or_default();
    let is_number = digits.starts_with(|first: char| first.is_ascii_digit());
    let is_part = match sign {
        '.' => !digits.contains('.'),
        '+' | '-' => digits.contains('.') && digits.ends_with(['E', 'e']),
        _ => false,
    };
    is_number && is_part && behind.starts_with(|next: char| next.is_ascii_digit())
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
        let text = "-1.5E-3+REAL#0.5 a[1..2] x1.3 2-3";
        let found: Vec<&str> = words(text).into_iter().map(|at| &text[at]).collect();
        let expected = [
            "-", "1.5E-3", "+", "REAL#0.5", "a", "[", "1", ".", ".", "2", "]", "x1", ".", "3", "2", "-", "3",
        ];
        assert_eq!(found, expected);
    }
}
