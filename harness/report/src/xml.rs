//! Text as XML 1.0 takes it.

use crate::spool::Spool;

/// Adds text, escaped for both content and attribute values. What XML cannot say (control characters, U+FFFE, U+FFFF)
/// becomes U+FFFD.
pub(crate) fn add_text(out: &mut Spool, text: &str) {
    let mut rest = text;
    while let Some(at) = rest.find(needs_escape) {
        let (plain, tail) = rest.split_at(at);
        out.add(plain.as_bytes());
        let mut characters = tail.chars();
        let special = characters.next().unwrap_or_default();
        out.add(escaped(special).as_bytes());
        rest = characters.as_str();
    }
    out.add(rest.as_bytes());
}

/// Adds ` name="value"`.
pub(crate) fn add_attribute(out: &mut Spool, name: &str, value: &str) {
    out.add(b" ");
    out.add(name.as_bytes());
    out.add(b"=\"");
    // In an attribute a line end would be read as a space.
    match value.contains(['\n', '\t']) {
        true => add_text(out, &value.replace(['\n', '\t'], " ")),
        false => add_text(out, value),
    }
    out.add(b"\"");
}

fn needs_escape(character: char) -> bool {
    match character {
        '<' | '>' | '&' | '"' => true,
        '\n' | '\t' => false,
        '\u{fffe}' | '\u{ffff}' => true,
        _ => character < ' ',
    }
}

fn escaped(character: char) -> &'static str {
    match character {
        '<' => "&lt;",
        '>' => "&gt;",
        '&' => "&amp;",
        '"' => "&quot;",
        _ => "\u{fffd}",
    }
}
