//! Normalizes a compiler message: drops names, numbers and quoted text so that messages of equal causes compare equal.

use stickler_types::ElementaryType;

/// The number of words that are kept of a message.
const WORDS: usize = 20;

/// Returns the first words of a message, without the parts that change from program to program: words with a digit, the
/// names of elementary data types, and text in quotes or brackets.
pub(super) fn normalize_message(message: &str) -> String {
    let first = message.lines().next().unwrap_or_default();
    let plain = without_quoted(first);
    let words = plain.split_whitespace().filter(|word| !is_of_the_program(word));
    let words: Vec<&str> = words.take(WORDS).collect();
    words
        .join(" ")
        .trim_end_matches([':', ';', ',', '.', ' '])
        .to_owned()
}

/// Returns whether a word has a digit, or is or ends with the name of an elementary data type in capitals, such as `INLINE_ARRAY_INT`;
/// `time` and `date` are ordinary words.
fn is_of_the_program(word: &str) -> bool {
    let name = word.trim_matches(|end: char| !end.is_ascii_alphanumeric());
    let last = name.rsplit('_').next().unwrap_or(name);
    let is_type = [name, last].iter().any(|name| {
        ElementaryType::from_name(name).is_some() && name.bytes().all(|byte| !byte.is_ascii_lowercase())
    });
    is_type || word.contains(|character: char| character.is_ascii_digit())
}

/// Removes text in quotes or brackets, and the space in front of it.
fn without_quoted(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    // The closing characters of the open quotes and brackets, the innermost last.
    let mut open: Vec<char> = Vec::new();
    let mut before = ' ';
    for character in text.chars() {
        // Within or after a word the character is an apostrophe.
        let closing = closing(character).filter(|end| *end != character || !before.is_alphanumeric());
        match (open.last(), closing) {
            (Some(end), _) if character == *end => _ = open.pop(),
            (Some(')'), Some(end)) => open.push(end),
            (Some(_), _) => {}
            (None, Some(end)) => {
                plain.truncate(plain.trim_end().len());
                open.push(end);
            }
            (None, None) => plain.push(character),
        }
        before = character;
    }
    plain
}

/// Returns the character that closes this quote or bracket.
const fn closing(opening: char) -> Option<char> {
    match opening {
        '(' => Some(')'),
        '‘' => Some('’'),
        '“' => Some('”'),
        '`' | '\'' | '"' => Some(opening),
        _ => None,
    }
}
