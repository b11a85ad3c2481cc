//! Values written by a format: `TO_STRING(BYTE#16#FF, '{0:D8}')`.
//!
//! Basis: plcnext-conversions: TO_STRING.

use super::{real, writing};
use stickler_types::{BitStringText, ElementaryType, MomentText, RealText};

/// Returns a format, in code units, with the value in place of its first `{0[:specifier][precision]}`; the value itself where the format is
/// empty, and nothing in its place where the specifier is not of its type.
pub fn formatted(raw: u64, from: ElementaryType, format: &[u16]) -> Vec<u16> {
    let format = match format {
        [] => "{0}".to_owned(),
        _ => String::from_utf16_lossy(format),
    };
    let behind = format
        .split_once('{')
        .and_then(|(before, rest)| Some((before, rest.split_once('}')?)));
    let Some((before, (specification, after))) = behind else {
        return format.encode_utf16().collect();
    };
    let value = specified(raw, from, specification).unwrap_or_default();
    [before, &value, after].concat().encode_utf16().collect()
}

/// Returns a value by what stands in braces: I or nothing is its literal, D an integer or bit string in as many decimal digits, E or e a real
/// number with so many digits, or 6, behind its point. `None` where that is no specification, not of this type, or of more than 99 digits.
fn specified(raw: u64, from: ElementaryType, specification: &str) -> Option<String> {
    let specification = specification.strip_prefix('0')?;
    let mut letters = specification.trim_start_matches(':').chars();
    let specifier = letters.next().unwrap_or('I');
    let precision: Option<usize> = letters.as_str().parse().ok();
    let is_read = letters.as_str().is_empty() || precision.is_some_and(|digits| digits <= 99);
    match specifier.to_ascii_uppercase() {
        _ if !is_read => None,
        'I' => {
            let reals = RealText::SignificantDigits(if from == ElementaryType::Real { 7 } else { 15 });
            let text = writing::write(raw, from, reals, BitStringText::FullWidth, MomentText::Literal);
            Some(text.replace("e+", "E+").replace("e-", "E-"))
        }
        'D' if from.is_whole() => {
            let number = from.integer_value(raw);
            let (sign, width) = (if number < 0 { "-" } else { "" }, precision.unwrap_or(1));
            Some(format!("{sign}{:0width$}", number.unsigned_abs()))
        }
        'E' if from.is_real() => {
            let number = format!("{:.*e}", precision.unwrap_or(6), real::decode(raw, from));
            let (mantissa, exponent) = number.split_once('e')?;
            let exponent: i32 = exponent.parse().ok()?;
            let sign = if exponent < 0 { '-' } else { '+' };
            Some(format!(
                "{mantissa}{specifier}{sign}{:02}",
                exponent.unsigned_abs()
            ))
        }
        _ => None,
    }
}
