//! Character string literals: `'it$'s'`, `"wide $20AC"`.

use super::LiteralError;
use std::fmt;

/// Parses a character string, with its quotes, into its code units.
///
/// A string in single quotes has single-byte characters: each character of the source is one unit, which must not be
/// greater than 16#FF, and `$` with two hexadecimal digits is one too. A string in double quotes has double-byte
/// characters: the units are UTF-16, and `$` takes four digits. Both accept `$$`, `$'`, `$"`, and in either case `$L` and
/// `$N` (16#0A), `$P` (16#0C), `$R` (16#0D) and `$T` (16#09). The standard allows `$'` only in single and `$"` only in
/// double quotes; this parser accepts both in both.
///
/// # Errors
/// `Malformed` where a quote is missing, or stands inside without its `$` (two single ones are one), or where there is a control character;
/// `Escape` at a `$` that begins nothing; `Character` where a character does not fit a single byte.
///
/// Basis: iec-61131-3: Tables 6 and 7 (character string literals and two-character combinations).
pub fn text(quoted: &str) -> Result<Vec<u16>, LiteralError> {
    characters(quoted, quoted.starts_with('"'))
}

/// Parses a character string as [`text`] does, but into units of which `wide` says whether they have two bytes.
///
/// # Errors
/// Those of [`text`].
pub fn characters(quoted: &str, wide: bool) -> Result<Vec<u16>, LiteralError> {
    let quote = match quoted.as_bytes().first() {
        Some(&quote @ (b'\'' | b'"')) => quote,
        _ => return Err(LiteralError::malformed(0, "a quote")),
    };
    let mut units = Vec::with_capacity(quoted.len().saturating_sub(2));
    let mut rest = quoted[1..].char_indices();
    while let Some((index, character)) = rest.next() {
        let at = index + 1;
        if character == char::from(quote) {
            return match rest.as_str() {
                "" => Ok(units),
                // Only a dialect with `doubled-apostrophes` makes one literal of this.
                more if quote == b'\'' && more.starts_with('\'') => {
                    units.push(u16::from(quote));
                    rest.next();
                    continue;
                }
                _ => Err(LiteralError::malformed(at + 1, "the end of the character string")),
            };
        }
        if character == '$' {
            let (unit, length) =
                escape(&quoted.as_bytes()[at + 1..], quote == b'"').ok_or(LiteralError::Escape { at })?;
            if !wide && unit > 0xFF {
                return Err(LiteralError::Character { at });
            }
            units.push(unit);
            // An escape is made of ASCII characters only, so its length in bytes is its length in characters.
            rest.nth(length - 1);
        } else if character.is_control() && character.is_ascii() {
            return Err(LiteralError::malformed(at, "a printable character"));
        } else if wide {
            units.extend_from_slice(character.encode_utf16(&mut [0; 2]));
        } else {
            let unit = u8::try_from(character).map_err(|_| LiteralError::Character { at })?;
            units.push(u16::from(unit));
        }
    }
    Err(LiteralError::malformed(quoted.len(), "the closing quote"))
}

/// Returns the unit that the bytes after a `$` represent, and their number.
fn escape(bytes: &[u8], wide: bool) -> Option<(u16, usize)> {
    let unit = match bytes.first()? {
        b'$' => b'$',
        b'\'' => b'\'',
        b'"' => b'"',
        b'L' | b'l' | b'N' | b'n' => b'\n',
        b'P' | b'p' => 0x0C,
        b'R' | b'r' => b'\r',
        b'T' | b't' => b'\t',
        _ => {
            let length = if wide { 4 } else { 2 };
            return Some((hexadecimal(bytes.get(..length)?)?, length));
        }
    };
    Some((u16::from(unit), 1))
}

/// Returns the number that one to four hexadecimal digits spell; `None` for any other text.
fn hexadecimal(digits: &[u8]) -> Option<u16> {
    digits.iter().try_fold(0_u16, |value, &byte| {
        let digit = char::from(byte).to_digit(16)?;
        Some(value << 4 | u16::try_from(digit).ok()?)
    })
}

/// Writes code units as a canonical character string in single quotes, or if `wide` in double ones.
///
/// A dollar sign and the string's own quote get a `$` in front; what is outside 16#20 to 16#7E becomes `$` with two digits, or
/// if `wide` four. A unit above 16#FF has no place in single quotes: it is written with four digits, which do not read back.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_text(out: &mut impl fmt::Write, units: &[u16], wide: bool) -> fmt::Result {
    let quote = if wide { '"' } else { '\'' };
    let digits = if wide { 4 } else { 2 };
    out.write_char(quote)?;
    for &unit in units {
        match u8::try_from(unit).map(char::from) {
            Ok(character) if character == '$' || character == quote => write!(out, "${character}")?,
            Ok(character @ ' '..='~') => out.write_char(character)?,
            _ => write!(out, "${unit:0digits$X}")?,
        }
    }
    out.write_char(quote)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(units: &[u16], wide: bool) -> String {
        let mut out = String::new();
        write_text(&mut out, units, wide).unwrap();
        out
    }

    #[test]
    fn every_unit_reads_back_from_its_canonical_spelling() {
        for unit in 0..=0xFF {
            assert_eq!(text(&written(&[unit, 0x30], false)), Ok(vec![unit, 0x30]));
        }
        for unit in 0..=0xFFFF {
            assert_eq!(text(&written(&[unit, 0x30], true)), Ok(vec![unit, 0x30]));
        }
    }
}
