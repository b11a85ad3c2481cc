//! The table that says what a byte can begin or belong to.

use crate::token::TokenKind;

/// The kind of token that a byte begins.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ByteClass {
    /// Whitespace: space, tab, line feed, carriage return, form feed.
    Space,
    /// A letter or an underscore.
    Letter,
    /// A decimal digit.
    Digit,
    /// `'` or `"`.
    Quote,
    /// Punctuation that is a token by itself, whatever follows.
    Mark,
    /// Punctuation that may have to be read together with what follows.
    Punctuation,
    /// Characters that begin no token: control characters, other ASCII characters, everything beyond ASCII.
    Unknown,
}

/// The class of each byte.
pub(super) const CLASS: [ByteClass; 256] = {
    let mut table = [ByteClass::Unknown; 256];
    let mut byte = 0;
    while byte < 128 {
        table[byte] = match byte as u8 {
            b' ' | b'\t' | b'\n' | b'\r' | 0x0C => ByteClass::Space,
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => ByteClass::Letter,
            b'0'..=b'9' => ByteClass::Digit,
            b'\'' | b'"' => ByteClass::Quote,
            b';' | b',' | b')' | b'[' | b']' | b'+' | b'-' | b'&' | b'^' => ByteClass::Mark,
            b':' | b'(' | b'.' | b'*' | b'/' | b'=' | b'<' | b'>' | b'?' | b'%' | b'{' => {
                ByteClass::Punctuation
            }
            _ => ByteClass::Unknown,
        };
        byte += 1;
    }
    table
};

/// The class of a byte.
#[inline]
pub(super) fn class(byte: u8) -> ByteClass {
    CLASS[usize::from(byte)]
}

/// The byte may stand in an identifier, or in the digits of a based literal.
#[inline]
pub(super) fn is_word(byte: u8) -> bool {
    matches!(class(byte), ByteClass::Letter | ByteClass::Digit)
}

/// The token that each [`ByteClass::Mark`] is.
const MARKS: [TokenKind; 256] = {
    let mut table = [TokenKind::Unknown; 256];
    table[b';' as usize] = TokenKind::Semicolon;
    table[b',' as usize] = TokenKind::Comma;
    table[b')' as usize] = TokenKind::RightParen;
    table[b'[' as usize] = TokenKind::LeftBracket;
    table[b']' as usize] = TokenKind::RightBracket;
    table[b'+' as usize] = TokenKind::Plus;
    table[b'-' as usize] = TokenKind::Minus;
    table[b'&' as usize] = TokenKind::Ampersand;
    table[b'^' as usize] = TokenKind::Caret;
    table
};

/// The token that a byte of [`ByteClass::Mark`] is.
#[inline]
pub(super) fn mark(byte: u8) -> TokenKind {
    MARKS[usize::from(byte)]
}
