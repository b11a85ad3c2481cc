//! Wraps paragraphs into lines that fit a terminal.

/// The width of a line, in characters.
const WIDTH: usize = 80;

/// Breaks a paragraph into lines of at most 80 characters, except for longer words.
pub fn wrap(paragraph: &str) -> String {
    wrap_within(paragraph, WIDTH)
}

/// Breaks a paragraph into lines of at most `width` characters, except for longer words.
pub fn wrap_within(paragraph: &str, width: usize) -> String {
    let mut text = String::with_capacity(paragraph.len() + 1);
    let mut column = 0;
    for word in paragraph.split_whitespace() {
        let letters = word.chars().count();
        match column {
            0 => {}
            _ if column + 1 + letters > width => {
                text.push('\n');
                column = 0;
            }
            _ => {
                text.push(' ');
                column += 1;
            }
        }
        text.push_str(word);
        column += letters;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, wrap};

    #[test]
    fn a_paragraph_is_broken_between_words_and_loses_none() {
        let paragraph = "word ".repeat(100) + &"x".repeat(WIDTH + 5) + " end";
        let wrapped = wrap(&paragraph);
        assert!(wrapped.split_whitespace().eq(paragraph.split_whitespace()));
        assert!(
            wrapped
                .lines()
                .all(|line| line.len() <= WIDTH || !line.contains(' ')),
            "{wrapped}"
        );
        assert!(wrapped.lines().count() <= 9, "{wrapped}");
    }
}
