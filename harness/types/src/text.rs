//! Texts for people that have little room.

/// Shortens a text to so many characters at most, at least 1; `…` stands for the rest.
pub fn shortened(text: &str, characters: usize) -> String {
    match text.char_indices().nth(characters) {
        None => text.to_owned(),
        Some(_) => text.chars().take(characters - 1).chain(['…']).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::shortened;

    #[test]
    fn a_text_that_is_shortened_is_as_long_as_its_room() {
        assert_eq!([shortened("äöüß", 4), shortened("äöüß?", 4)], ["äöüß", "äöü…"]);
    }
}
