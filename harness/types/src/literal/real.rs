//! Real literals: `-1.5E+10`.

use super::LiteralError;
use super::duration::digits_at;
use super::number::integer;
use crate::elementary::ElementaryType;
use std::borrow::Cow;
use std::fmt;

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
    let digits = if text.len() > LONG_REAL {
        Cow::Owned(condensed(text))
    } else if text.contains('_') {
        Cow::Owned(text.replace('_', ""))
    } else {
        Cow::Borrowed(text)
    };
    let read = match ty {
        ElementaryType::Real => digits
            .parse()
            .map(|value: f32| (value.to_bits().into(), value.is_finite())),
        _ => digits
            .parse()
            .map(|value: f64| (value.to_bits(), value.is_finite())),
    };
    match read.map_err(|_| LiteralError::malformed(0, "a real number"))? {
        (raw, true) => Ok(raw),
        (_, false) => Err(LiteralError::overflow(0, ty.name())),
    }
}

/// The length from which a real literal is condensed before the standard library parses it.
///
/// The parser of the standard library limits exponents to some hundred thousand, which matters only for a literal with as
/// many zeros to compensate.
const LONG_REAL: usize = 10_000;

/// Rewrites a well-formed number as `0.` without zeros after the point, and an adjusted exponent.
fn condensed(text: &str) -> String {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent = integer(exponent).unwrap_or(if exponent.starts_with('-') {
        i128::MIN
    } else {
        i128::MAX
    });
    let digits_of = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    let whole = mantissa
        .split('.')
        .next()
        .map_or(0, |whole| digits_of(whole).len());
    let digits = digits_of(mantissa);
    let significant = digits.trim_start_matches('0');
    let point = whole as i128 - (digits.len() - significant.len()) as i128;
    // Nothing of either type has an exponent near this bound.
    let exponent = exponent.saturating_add(point).clamp(-10_000, 10_000);
    let sign = if mantissa.starts_with('-') { "-" } else { "" };
    format!("{sign}0.{significant}E{exponent}")
}

/// Checks that the bytes follow the grammar of a real number.
fn check_real(bytes: &[u8]) -> Result<(), LiteralError> {
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    at += digits_at(bytes, at)?.len();
    if bytes.get(at) != Some(&b'.') {
        return Err(LiteralError::malformed(at, "a point"));
    }
    at += 1 + digits_at(bytes, at + 1)?.len();
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        at += 1;
        at += usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
        at += digits_at(bytes, at)?.len();
    }
    if at < bytes.len() {
        Err(LiteralError::malformed(at, "the end of the real number"))
    } else {
        Ok(())
    }
}

/// Writes the canonical spelling of a raw `REAL`, or else `LREAL`: `0.1`, `-0.0`, `1.0E16`, `NaN`, `-Infinity`.
///
/// The result has the fewest decimal digits that read back to the same bits, always a point, and an exponent below 1E-4 and
/// from 1E16. A NaN has no sign and no payload.
///
/// Basis: harness/engines/README.md (how values are written).
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

/// Writes `digits` with the type and the sign of `value`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Lreal, Real};

    fn written(raw: u64, ty: ElementaryType) -> String {
        let mut out = String::new();
        write_real(&mut out, raw, ty).unwrap();
        out
    }

    #[test]
    fn canonical_reals_read_back_to_the_same_bits_and_are_as_short_as_those_of_the_standard_library() {
        for bits in crate::SplitMix64::new(1).numbers().take(20_000) {
            let (float, short) = (f64::from_bits(bits), f32::from_bits(bits as u32));
            let text = written(bits, Lreal);
            if float.is_finite() {
                assert_eq!(real(&text, Lreal), Ok(bits), "{text}");
                assert_eq!(text.replace(".0E", "E"), format!("{float:?}").replace('e', "E"));
            }
            if short.is_finite() {
                let text = written(u64::from(short.to_bits()), Real);
                assert_eq!(real(&text, Real), Ok(u64::from(short.to_bits())), "{text}");
                assert_eq!(text.replace(".0E", "E"), format!("{short:?}").replace('e', "E"));
            }
        }
    }
}
