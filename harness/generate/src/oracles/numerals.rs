//! A second reader of numeric literals by exact arithmetic, independent of the reader of the reference, which the oracle
//! `literal` compares with it.
//!
//! Basis: iec-61131-3: Table 5 (numeric literals); IEC 60559 for the rounding of reals.

use num_bigint::{BigInt, BigUint};
use std::cmp::Ordering;
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
    digits: BigUint,
    exponent: BigInt,
    /// The number of decimal digits from the first that is not 0.
    length: usize,
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
    let [whole, fraction] = [whole, fraction].map(|part| part.replace('_', ""));
    let all = whole + &fraction;
    Some(DecimalNumber {
        negative: mantissa.starts_with('-'),
        digits: digits(&all, 10)?,
        exponent: exponent - fraction.len(),
        length: all.trim_start_matches('0').len(),
    })
}

impl DecimalNumber {
    /// Returns whether this number rounds to the raw form of a REAL or LREAL: to nearest, ties to even.
    pub(super) fn rounds_to(&self, raw: u64, ty: ElementaryType) -> bool {
        let format = BinaryFormat::of(ty);
        let magnitude = raw & !format.sign();
        if (raw != magnitude) != self.negative || magnitude >= format.infinity() {
            return false;
        }
        let even = magnitude.is_multiple_of(2);
        let fits = |side: Ordering, wrong: Ordering| side != wrong && (even || side != Ordering::Equal);
        let upper = self.compare(&format.half_above(magnitude));
        fits(upper, Ordering::Greater)
            && magnitude
                .checked_sub(1)
                .is_none_or(|below| fits(self.compare(&format.half_above(below)), Ordering::Less))
    }

    /// Returns whether this number rounds to an infinity, regardless of its sign.
    pub(super) fn overflows(&self, ty: ElementaryType) -> bool {
        let format = BinaryFormat::of(ty);
        self.compare(&format.half_above(format.infinity() - 1)) != Ordering::Less
    }

    /// Compares the magnitude of this number with another that is not 0.
    fn compare(&self, other: &Dyadic) -> Ordering {
        // Beyond this power of ten the digits do not matter, and the power would be too large to compute.
        const FAR: i32 = 400;
        let first = &self.exponent + self.length;
        if self.length == 0 || first < BigInt::from(-FAR) {
            return Ordering::Less;
        }
        if first > BigInt::from(FAR) {
            return Ordering::Greater;
        }
        // From here on the exponent is at most the length of the text.
        let ten = BigUint::from(10_u8);
        let power = u32::try_from(self.exponent.magnitude()).unwrap_or(u32::MAX);
        let (mut left, mut right) = (self.digits.clone(), other.significand.clone());
        if self.exponent.sign() == num_bigint::Sign::Minus {
            right *= ten.pow(power);
        } else {
            left *= ten.pow(power);
        }
        if other.exponent < 0 {
            left <<= other.exponent.unsigned_abs();
        } else {
            right <<= other.exponent.unsigned_abs();
        }
        left.cmp(&right)
    }
}

/// A significand times a power of two.
struct Dyadic {
    significand: BigUint,
    exponent: i32,
}

/// An interchange format of IEC 60559, by its widths.
struct BinaryFormat {
    /// The number of bits of the fraction.
    fraction: u32,
    /// The number of bits of the exponent.
    exponent: u32,
}

impl BinaryFormat {
    fn of(ty: ElementaryType) -> BinaryFormat {
        match ty {
            ElementaryType::Real => BinaryFormat {
                fraction: 23,
                exponent: 8,
            },
            _ => BinaryFormat {
                fraction: 52,
                exponent: 11,
            },
        }
    }

    const fn sign(&self) -> u64 {
        1 << (self.fraction + self.exponent)
    }

    const fn infinity(&self) -> u64 {
        ((1 << self.exponent) - 1) << self.fraction
    }

    /// Returns the number halfway from a finite magnitude to the next; after the last finite one to the number that would
    /// follow.
    fn half_above(&self, magnitude: u64) -> Dyadic {
        let fraction = magnitude & ((1 << self.fraction) - 1);
        let biased = (magnitude >> self.fraction) as i32;
        let significand = if biased == 0 {
            fraction
        } else {
            fraction | 1 << self.fraction
        };
        let bias = (1 << (self.exponent - 1)) - 1;
        Dyadic {
            significand: BigUint::from(significand * 2 + 1),
            exponent: biased.max(1) - bias - self.fraction as i32 - 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Lreal, Real};

    #[test]
    fn integers_are_those_of_the_grammar() {
        for (text, value) in [
            ("0", 0),
            ("-1_0", -10),
            ("+7", 7),
            ("16#fF", 255),
            ("2#1_0", 2),
            ("8#17", 15),
        ] {
            assert_eq!(integer(text), Some(BigInt::from(value)), "{text}");
        }
        for text in [
            "", "-", "_1", "1_", "1__0", "-16#1", "16#", "10#1", "2#2", "1 ", "٣", "1#1#1",
        ] {
            assert_eq!(integer(text), None, "{text}");
        }
    }

    #[test]
    fn reals_round_to_nearest_and_ties_to_even() {
        for (text, bits) in [
            ("0.0", 0.0_f64),
            ("-0.0", -0.0),
            ("0.1", 0.1),
            ("9007199254740993.0", 9_007_199_254_740_992.0),
            ("9007199254740995.0", 9_007_199_254_740_996.0),
            ("4.9E-324", 5e-324),
            ("2.4E-324", 0.0),
            ("1.7976931348623157E+308", f64::MAX),
            ("1.0E-99999999999999999999", 0.0),
        ] {
            let decimal = real(text).expect("a real");
            let raw = bits.to_bits();
            assert!(decimal.rounds_to(raw, Lreal), "{text}");
            assert!(!decimal.rounds_to(raw + 1, Lreal), "{text}");
            assert!(raw << 1 == 0 || !decimal.rounds_to(raw - 1, Lreal), "{text}");
        }
        let tie = real("1.000000059604644775390625").expect("a real");
        assert!(tie.rounds_to(1.0_f32.to_bits().into(), Real));
        assert!(!tie.rounds_to(1.000_000_1_f32.to_bits().into(), Real));
    }

    #[test]
    fn a_real_overflows_from_half_a_step_above_the_largest_finite() {
        for (text, overflows) in [
            ("340282356779733661637539395458142568447.9", false),
            ("340282356779733661637539395458142568448.0", true),
            ("1.0E99999999999999999999", true),
            ("0.0E99999999999999999999", false),
        ] {
            assert_eq!(real(text).expect("a real").overflows(Real), overflows, "{text}");
        }
    }

    #[test]
    fn what_is_no_real_is_none() {
        for text in [
            "1", "1.", ".5", "1.0E", "1.0E16#1", "1.0E5.0", "--1.0", "1.0E5E5", "NaN",
        ] {
            assert!(real(text).is_none(), "{text}");
        }
    }
}
