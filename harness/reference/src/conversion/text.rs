//! Characters and texts of either width.

use stickler_types::ElementaryType;

/// Stands for a character that STRING and CHAR do not have.
const REPLACEMENT: u16 = b'?' as u16;

/// A character of either width as CHAR, where it may have to be replaced, or as WCHAR.
pub fn character(raw: u64, to: ElementaryType) -> u64 {
    let narrow = matches!(to, ElementaryType::Char | ElementaryType::String);
    if narrow && raw > 0xFF {
        REPLACEMENT.into()
    } else {
        raw
    }
}

/// A text of either width as STRING, where characters may have to be replaced, or as WSTRING.
pub fn between(units: &[u16], to: ElementaryType) -> Vec<u16> {
    units
        .iter()
        .map(|&unit| character(unit.into(), to) as u16)
        .collect()
}
