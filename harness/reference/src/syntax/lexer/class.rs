//! The table that says what a byte can begin or belong to.

/// What a byte begins.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// Whitespace: space, tab, line feed, carriage return, form feed.
    Space,
    /// A letter or an underscore.
    Letter,
    /// A decimal digit.
    Digit,
    /// `'` or `"`.
    Quote,
    /// Punctuation.
    Punctuation,
    /// Nothing: control characters, other ASCII characters, everything beyond ASCII.
    Unknown,
}

/// The class of each byte.
pub(super) const CLASS: [Class; 256] = {
    let mut table = [Class::Unknown; 256];
    let mut byte = 0;
    while byte < 128 {
        table[byte] = match byte as u8 {
            b' ' | b'\t' | b'\n' | b'\r' | 0x0C => Class::Space,
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => Class::Letter,
            b'0'..=b'9' => Class::Digit,
            b'\'' | b'"' => Class::Quote,
            b':' | b';' | b',' | b'(' | b')' | b'[' | b']' | b'.' | b'+' | b'-' | b'*' | b'/' | b'='
            | b'<' | b'>' | b'&' | b'^' | b'?' | b'%' | b'{' => Class::Punctuation,
            _ => Class::Unknown,
        };
        byte += 1;
    }
    table
};

/// The class of a byte.
#[inline]
pub(super) fn class(byte: u8) -> Class {
    CLASS[usize::from(byte)]
}

/// The byte may stand in an identifier, or in the digits of a based literal.
#[inline]
pub(super) fn is_word(byte: u8) -> bool {
    matches!(class(byte), Class::Letter | Class::Digit)
}
