//! What is left of what a compiler says when what differs from program to program is left out.

/// How many words of a message tell one kind of crash or rejection from another.
const WORDS: usize = 16;

/// The first words of a message, without what changes from program to program: what has a digit in it, and what stands in
/// quotes or brackets.
pub(super) fn gist(message: &str) -> String {
    let first = message.lines().next().unwrap_or_default();
    let mut plain = String::with_capacity(first.len());
    let mut until = None;
    let mut before = ' ';
    for character in first.chars() {
        // Within or behind a word it is an apostrophe.
        let opens = closing(character).filter(|_| !before.is_alphanumeric());
        match (until, opens) {
            (Some(end), _) if character == end => until = None,
            (Some(_), _) => {}
            (None, Some(_)) => {
                plain.truncate(plain.trim_end().len());
                until = opens;
            }
            (None, None) => plain.push(character),
        }
        before = character;
    }
    let words = plain
        .split_whitespace()
        .filter(|word| !word.contains(|character: char| character.is_ascii_digit()));
    let words: Vec<&str> = words.take(WORDS).collect();
    words
        .join(" ")
        .trim_end_matches([':', ';', ',', '.', ' '])
        .to_owned()
}

/// What ends what begins like this.
const fn closing(opening: char) -> Option<char> {
    match opening {
        '(' => Some(')'),
        '`' | '\'' | '"' => Some(opening),
        _ => None,
    }
}
