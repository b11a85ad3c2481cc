//! JSON that can stand in an element `script` of a page.

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;
use std::io::{self, Write};

/// A compact format that escapes `<`, so that no text of the data ends the element or begins a comment in it.
struct ScriptFormatter;

impl Formatter for ScriptFormatter {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        let mut pieces = fragment.split('<');
        out.write_all(pieces.next().unwrap_or_default().as_bytes())?;
        for piece in pieces {
            out.write_all(br"\u003c")?;
            out.write_all(piece.as_bytes())?;
        }
        Ok(())
    }
}

/// Writes a value as JSON without the character `<`.
///
/// # Errors
/// Errors of writing to `out`.
pub(super) fn write(out: &mut impl Write, value: &impl Serialize) -> io::Result<()> {
    let mut serializer = Serializer::with_formatter(out, ScriptFormatter);
    Ok(value.serialize(&mut serializer)?)
}

#[cfg(test)]
mod tests {
    use super::write;

    #[test]
    fn no_text_ends_the_element_and_all_texts_come_back() {
        let texts = ["</script><script>alert(1)</script>", "<!--", "a < b", "\"<\\"];
        let mut bytes = Vec::new();
        write(&mut bytes, &texts).expect("written");
        assert!(!bytes.contains(&b'<'));
        let read: Vec<String> = serde_json::from_slice(&bytes).expect("JSON");
        assert_eq!(read, texts);
    }
}
