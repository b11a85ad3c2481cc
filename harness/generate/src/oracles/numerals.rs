//! A second reader of numeric literals by exact arithmetic, independent of the reader of the reference, which the oracle
//! `literal` compares with it.
//!
//! Basis: iec-61131-3: Table 5 (numeric literals); IEC 60559 for the rounding of reals.

use num_bigint::{BigInt, BigUint, Sign};
use stickler_exact::nearest_decimal;
use stickler_types::ElementaryType;

/// Parses digits with single underscores between them: no sign, at least one digit.
fn digits(text: &str, base: u32) -> Option<BigUint> {
    let sound = |group: &str| !group.is_empty() && group.chars().all(|digit| digit.is_digit(base));
    if !text.split('_').all(sound) {
        return None;
    }
    BigUint::parse_bytes(text.replace('_', "").as_bytes(), base)
}

/// Parses an unsigned integer literal; `None` if the text is none.
pub(super) fn unsigned(text: &str) -> Option<BigInt> {
    let number = match text.split_once('#') {
        Some(("2", binary)) => digits(binary, 2),
        Some(("8", octal)) => digits(octal, 8),
        Some(("16", hexadecimal)) => digits(hexadecimal, 16),
        Some(_) => None,
        None => digits(text, 10),
    };
    number.map(BigInt::from)
}

/// Parses an integer literal, which may have a sign if it is decimal; `None` if the text is none.
pub(super) fn integer(text: &str) -> Option<BigInt> {
    match text.split_at_checked(1) {
        Some(("-", magnitude)) => digits(magnitude, 10).map(|magnitude| -BigInt::from(magnitude)),
        Some(("+", magnitude)) => digits(magnitude, 10).map(BigInt::from),
        _ => unsigned(text),
    }
}

/// A decimal number: digits times a power of ten.
#[derive(Clone, Debug)]
pub(super) struct DecimalNumber {
    negative: bool,
    /// The digits, each from 0 to 9.
    digits: Vec<u8>,
    exponent: i64,
}

/// Parses a real literal; `None` if the text is none.
pub(super) fn real(text: &str) -> Option<DecimalNumber> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((_, exponent)) if exponent.contains('#') => return None,
        Some((mantissa, exponent)) => (mantissa, integer(exponent)?),
        None => (text, BigInt::ZERO),
    };
    let unsigned = mantissa.strip_prefix(['+', '-']).unwrap_or(mantissa);
    let (whole, fraction) = unsigned.split_once('.')?;
    digits(whole, 10)?;
    digits(fraction, 10)?;
    let value = |text: &str| {
        text.bytes()
            .filter(u8::is_ascii_digit)
            .map(|digit| digit - b'0')
            .collect()
    };
    let [whole, fraction]: [Vec<u8>; 2] = [whole, fraction].map(value);
    let is_far = if exponent.sign() == Sign::Minus {
        i64::MIN
    } else {
        i64::MAX
    };
    Some(DecimalNumber {
        negative: mantissa.starts_with('-'),
        exponent: i64::try_from(exponent)
            .unwrap_or(is_far)
            .saturating_sub(fraction.len() as i64),
        digits: [whole, fraction].concat(),
    })
}

impl DecimalNumber {
    /// Returns the raw form of the REAL or LREAL nearest to this number, ties to even; `None` if that is an infinity.
    pub(super) fn raw(&self, ty: ElementaryType) -> Option<u64> {
        let raw = nearest_decimal(self.negative, &self.digits, self.exponent, ty);
        ty.real_value(raw).is_some_and(f64::is_finite).then_some(raw)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_numerals() {
        let none = || "none".to_owned();
        check_examples("tests/numerals.md", |example| match example.wanted() {
            "integer" => integer(example.text("text")).map_or_else(none, |number| number.to_string()),
            _ => real(example.text("text")).map_or_else(none, |_| "some".to_owned()),
        });
    }
}
