//! Removes the colours of a terminal from a text.

/// Returns the text without terminal control sequences: some compilers colour their output also where no terminal reads it.
pub(crate) fn without_colours(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::without_colours;

    #[test]
    fn what_steers_a_terminal_is_gone_and_all_else_stays() {
        let coloured =
            "\u{1b}[1m\u{1b}[38;5;9merror\u{1b}[0m: ä\n\u{1b}]8;;https://x\u{7}more\u{1b}]8;;\u{7}\n";
        assert_eq!(without_colours(coloured), "error: ä\nmore\n");
        assert_eq!(without_colours("a\u{1b}["), "a");
    }
}
