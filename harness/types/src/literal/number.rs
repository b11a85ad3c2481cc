//! Integer and real literals: `1_000`, `16#FF_FF`, `-5`, `-1.5E+10`.

use super::LiteralError;
use crate::elementary::ElementaryType;
use std::borrow::Cow;
use std::fmt;

/// Reads an unsigned integer: decimal, or with base 2, 8 or 16 (`2#1010_0101`, `8#17`, `16#Ff`).
///
/// One underscore may stand between two digits. There is no sign, and no base but those three.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the value does not fit 128 bits.
///
/// Basis: iec-61131-3: Table 5 (numeric literals).
pub fn unsigned_integer(text: &str) -> Result<u128, LiteralError> {
    match text.as_bytes() {
        [b'1', b'6', b'#', digits @ ..] => digits_of_base(digits, 16, 3),
        [b'8', b'#', digits @ ..] => digits_of_base(digits, 8, 2),
        [b'2', b'#', digits @ ..] => digits_of_base(digits, 2, 2),
        digits => digits_of_base(digits, 10, 0),
    }
}

/// Reads an integer: an [`unsigned_integer`], or a decimal one with `+` or `-` directly in front.
///
/// A sign cannot stand before a base: the grammar has `signed_integer | binary_integer | octal_integer | hex_integer`, and only
/// the first of them is signed. So `INT#-16#5` is malformed. A based number is the number that its digits say, never a bit
/// pattern: `INT#16#FFFF` is 65535 and no `INT`.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the value does not fit 128 bits with sign.
///
/// Basis: iec-61131-3: Table 5 and the production `Int_Literal`.
pub fn integer(text: &str) -> Result<i128, LiteralError> {
    let (negative, magnitude) = match text.as_bytes() {
        [b'-', digits @ ..] => (true, digits_of_base(digits, 10, 1)?),
        [b'+', digits @ ..] => (false, digits_of_base(digits, 10, 1)?),
        _ => (false, unsigned_integer(text)?),
    };
    let value = if negative {
        0_i128.checked_sub_unsigned(magnitude)
    } else {
        i128::try_from(magnitude).ok()
    };
    value.ok_or(LiteralError::overflow(0, "128 bits"))
}

/// The value of digits, where `at` is the offset of the first of them in the text to be reported.
fn digits_of_base(digits: &[u8], base: u32, at: usize) -> Result<u128, LiteralError> {
    // Nineteen decimal digits always fit 64 bits, and nearly every literal is that short and has no underscore.
    if base == 10 && (1..=19).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit) {
        let value = digits
            .iter()
            .fold(0_u64, |value, digit| value * 10 + u64::from(digit - b'0'));
        return Ok(u128::from(value));
    }
    let length = digit_run(digits, base);
    if length == 0 || length < digits.len() {
        return Err(LiteralError::malformed(at + length, digit_name(base)));
    }
    let mut value = 0_u128;
    for digit in digits.iter().filter_map(|&byte| digit_of(byte, base)) {
        value = value
            .checked_mul(u128::from(base))
            .and_then(|value| value.checked_add(u128::from(digit)))
            .ok_or(LiteralError::overflow(0, "128 bits"))?;
    }
    Ok(value)
}

fn digit_of(byte: u8, base: u32) -> Option<u32> {
    char::from(byte).to_digit(base)
}

fn digit_name(base: u32) -> &'static str {
    match base {
        2 => "a binary digit",
        8 => "an octal digit",
        16 => "a hexadecimal digit",
        _ => "a digit",
    }
}

/// How many bytes at the start of `bytes` are digits of `base`, with single underscores between them.
pub(super) fn digit_run(bytes: &[u8], base: u32) -> usize {
    let mut end = 0;
    loop {
        while bytes.get(end).is_some_and(|&byte| digit_of(byte, base).is_some()) {
            end += 1;
        }
        let goes_on = end > 0
            && bytes.get(end) == Some(&b'_')
            && bytes
                .get(end + 1)
                .is_some_and(|&byte| digit_of(byte, base).is_some());
        if !goes_on {
            return end;
        }
        end += 1;
    }
}

/// Reads a real number, such as `-1_000.5E+10`, into the raw form of `ty`: `REAL`, or else `LREAL`.
///
/// The decimal digits are rounded once, to nearest and ties to even, straight to the width of the type. What is too small
/// becomes zero of the same sign. A point with digits on both sides is required, as the grammar has it; signs may stand in front
/// and behind the `E`; one underscore may stand between two digits. The words for what is not finite are not read here.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the value rounds to an infinity.
///
/// Basis: iec-61131-3: Table 5 (real literals); IEC 60559 for the rounding.
pub fn real(text: &str, ty: ElementaryType) -> Result<u64, LiteralError> {
    check_real(text.as_bytes())?;
    let digits = if text.contains('_') {
        Cow::Owned(text.replace('_', ""))
    } else {
        Cow::Borrowed(text)
    };
    let (raw, finite) = if ty == ElementaryType::Real {
        digits
            .parse::<f32>()
            .map(|value| (u64::from(value.to_bits()), value.is_finite()))
    } else {
        digits
            .parse::<f64>()
            .map(|value| (value.to_bits(), value.is_finite()))
    }
    .map_err(|_| LiteralError::malformed(0, "a real number"))?;
    if finite {
        Ok(raw)
    } else {
        Err(LiteralError::overflow(0, ty.name()))
    }
}

/// Whether the bytes follow the grammar of a real number.
fn check_real(bytes: &[u8]) -> Result<(), LiteralError> {
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    at = digits_at(bytes, at)?;
    if bytes.get(at) != Some(&b'.') {
        return Err(LiteralError::malformed(at, "a point"));
    }
    at = digits_at(bytes, at + 1)?;
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        at += 1;
        at += usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
        at = digits_at(bytes, at)?;
    }
    if at < bytes.len() {
        Err(LiteralError::malformed(at, "the end of the real number"))
    } else {
        Ok(())
    }
}

/// The offset behind the decimal digits that must stand at `at`.
fn digits_at(bytes: &[u8], at: usize) -> Result<usize, LiteralError> {
    match digit_run(&bytes[at..], 10) {
        0 => Err(LiteralError::malformed(at, "a digit")),
        length => Ok(at + length),
    }
}

/// Writes the canonical spelling of a raw `REAL`, or else `LREAL`: `0.1`, `-0.0`, `1.0E16`, `NaN`, `-Infinity`.
///
/// These are the fewest decimal digits that read back to the same bits, always with a point, and with an exponent below 1E-4
/// and from 1E16. A NaN has no sign and no payload.
///
/// Basis: stickler-design: §4.
pub fn write_real(out: &mut impl fmt::Write, raw: u64, ty: ElementaryType) -> fmt::Result {
    if ty == ElementaryType::Real {
        let value = f32::from_bits(raw as u32);
        let plain = value == 0.0 || (1e-4..1e16).contains(&value.abs());
        write_digits(out, f64::from(value), plain, value)
    } else {
        let value = f64::from_bits(raw);
        let plain = value == 0.0 || (1e-4..1e16).contains(&value.abs());
        write_digits(out, value, plain, value)
    }
}

/// Writes `digits`, whose kind and sign are those of `value`.
fn write_digits(
    out: &mut impl fmt::Write,
    value: f64,
    plain: bool,
    digits: impl fmt::Display + fmt::UpperExp + fmt::Debug,
) -> fmt::Result {
    if value.is_nan() {
        return out.write_str("NaN");
    }
    if value.is_infinite() {
        return out.write_str(if value < 0.0 { "-Infinity" } else { "Infinity" });
    }
    let mut text = if plain {
        format!("{digits}")
    } else {
        format!("{digits:E}")
    };
    if !text.contains('.') {
        let end = text.find('E').unwrap_or(text.len());
        text.insert_str(end, ".0");
    }
    out.write_str(&text)
}
