//! The table that says what a byte can begin or belong to.

use crate::syntax::token::TokenKind;

/// The kind of token that a byte begins.
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
    /// Punctuation that is a token by itself, whatever follows.
    Mark,
    /// Punctuation that may have to be read together with what follows.
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
            b';' | b',' | b')' | b'[' | b']' | b'+' | b'-' | b'&' | b'^' => Class::Mark,
            b':' | b'(' | b'.' | b'*' | b'/' | b'=' | b'<' | b'>' | b'?' | b'%' | b'{' => Class::Punctuation,
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

/// The token that each [`Class::Mark`] is.
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

/// The token that a byte of [`Class::Mark`] is.
#[inline]
pub(super) fn mark(byte: u8) -> TokenKind {
    MARKS[usize::from(byte)]
}
