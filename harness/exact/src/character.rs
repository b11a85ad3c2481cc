//! Conversions between characters and between texts of either width.
//!
//! Basis: iec-61131-3: Table 10 (`STRING` and `CHAR` have single-byte, `WSTRING` and `WCHAR` double-byte characters). What becomes
//! of a character that the narrow types lack no source says.

use stickler_types::ElementaryType;

/// The substitute for a character that STRING and CHAR do not have.
const REPLACEMENT: u16 = b'?' as u16;

/// Returns a code unit as the type holds it: unchanged, or a question mark where the type is narrow and lacks it.
pub(crate) const fn unit(unit: u16, to: ElementaryType) -> u16 {
    let narrow = matches!(to, ElementaryType::String | ElementaryType::Char);
    if narrow && unit > 0xFF { REPLACEMENT } else { unit }
}

/// Returns the code unit of a character's raw form.
pub(crate) const fn of_raw(raw: u64) -> u16 {
    // A character has at most 16 bits.
    raw as u16
}

/// Returns the raw form of the first character of a text; 0 if the text is empty.
pub(crate) fn first(units: &[u16], to: ElementaryType) -> u64 {
    units.first().map_or(0, |&first| unit(first, to).into())
}

/// Converts a text to the other width, character by character.
pub(crate) fn text(units: &[u16], to: ElementaryType) -> Vec<u16> {
    units.iter().map(|&one| unit(one, to)).collect()
}
