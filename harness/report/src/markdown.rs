//! The pieces of Markdown that pages and summaries are made of, with everything escaped that came from elsewhere.

use crate::text::{MAX_SHOWN_CHARACTERS, clip, visible};

/// Formats a text that leads to an address of the web; the text alone where the address is another one.
pub(crate) fn linked(text: &str, address: &str) -> String {
    match address.starts_with("https://") || address.starts_with("http://") {
        true => {
            let address = address.replace(['<', '>', '\n'], "").replace('|', "%7C");
            format!("[{}](<{address}>)", inline(text))
        }
        false => inline(text),
    }
}

/// Returns further cells of a row of a table, whose texts are escaped already.
pub(crate) fn cells(texts: impl IntoIterator<Item = String>) -> String {
    texts.into_iter().map(|text| format!(" {text} |")).collect()
}

/// Returns a code fence: three backticks, or more than any line of the text has.
pub(crate) fn fence(text: &str) -> String {
    let longest = text
        .split(|character| character != '`')
        .map(str::len)
        .max()
        .unwrap_or(0);
    "`".repeat(longest.max(2) + 1)
}

/// Formats a text as inline code, between two backticks, so that a single one in the text is harmless.
pub(crate) fn code(text: &str) -> String {
    format!("`` {} ``", visible(text).replace(['\n', '\t'], " "))
}

/// Escapes a text for Markdown and HTML, on one line.
pub fn inline(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in clip(&visible(text).replace('\n', " "), 1, MAX_SHOWN_CHARACTERS).chars() {
        if matches!(
            character,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '&' | '~'
        ) {
            escaped.push('\\');
        }
        escaped.push(character);
    }
    escaped
}
