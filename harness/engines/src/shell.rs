//! Quoting for a POSIX shell.

use std::borrow::Cow;

/// Quotes a word so that a POSIX shell takes it for one argument. Words of letters, digits and `-_./:@=,+%` stay as they are.
pub fn shell_quote(word: &str) -> Cow<'_, str> {
    let safe = |byte: u8| byte.is_ascii_alphanumeric() || b"-_./:@=,+%".contains(&byte);
    if !word.is_empty() && word.bytes().all(safe) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', r"'\''")).into()
}

#[cfg(test)]
mod tests {
    use super::shell_quote;

    #[test]
    fn a_shell_takes_a_quoted_word_for_one_argument() {
        for (word, quoted) in [
            ("widening/integer@ironplc-ed2", "widening/integer@ironplc-ed2"),
            ("a(INT,-1)", "'a(INT,-1)'"),
            ("it's", r"'it'\''s'"),
            ("", "''"),
            ("*", "'*'"),
        ] {
            assert_eq!(shell_quote(word), quoted);
            assert_eq!(shlex::split(quoted).as_deref(), Some(&[word.to_owned()][..]));
        }
    }
}
