//! Decimal digits of real numbers: the fewest that read back, or a given number of them.
//!
//! The standard library finds the digits. It writes a number exactly: in the fewest digits that read back, those nearest to it, or in a given
//! number of digits, rounded half to even.

use crate::quotient;
use crate::real::{self, Finite, Real, Whole};
use num_bigint::BigUint;
use stickler_types::{ElementaryType, Rounding};

/// A number without its sign in decimal digits: `d.ddd * 10^exponent`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct RoundedDecimal {
    /// The digits, the first and the last of them not 0; none of 0.
    pub(super) digits: String,
    /// The power of ten of the first digit.
    pub(super) exponent: i32,
}

impl RoundedDecimal {
    /// Reads what the standard library writes: `-1.25e-7`.
    fn read(scientific: &str) -> RoundedDecimal {
        let (digits, exponent) = scientific.split_once('e').unwrap_or((scientific, "0"));
        let digits = digits.replace(['.', '-'], "");
        RoundedDecimal {
            digits: digits.trim_end_matches('0').to_owned(),
            exponent: exponent.parse().unwrap_or(0),
        }
    }
}

/// Returns the fewest digits that read back to a finite number of the type; among equally few digits those nearest to the number.
///
/// Basis: harness/engines/README.md (how values are written), which leaves the nearness open.
pub(super) fn shortest(raw: u64, ty: ElementaryType) -> RoundedDecimal {
    RoundedDecimal::read(&match ty {
        // A REAL has 32 bits.
        ElementaryType::Real => format!("{:e}", f32::from_bits(raw as u32)),
        _ => format!("{:e}", f64::from_bits(raw)),
    })
}

/// Returns a finite number with `count` significant digits, at least one, rounded half to even, without zeros at the end.
pub(super) fn significant(raw: u64, ty: ElementaryType, count: u8) -> RoundedDecimal {
    let places = usize::from(count.max(1)) - 1;
    // Each REAL is a number of the wider format too.
    let number = ty.real_value(raw).unwrap_or_default();
    RoundedDecimal::read(&format!("{number:.places$e}"))
}

/// Returns a positive number of a type as [`stickler_types::RealText::ByWidth`] scales and rounds it; `raw` is its raw form.
pub(super) fn scaled(number: Finite, raw: u64, ty: ElementaryType) -> RoundedDecimal {
    let Finite {
        significand,
        exponent,
        ..
    } = number;
    let places = if ty == ElementaryType::Real {
        // Basis: codesys-recording: REAL_TO_STRING; the digits that it shows follow from 10/33 in the place of the logarithm of 2.
        let binary = exponent + significand.ilog2() as i32;
        6 - (binary * 10).div_euclid(33)
    } else {
        // So many digits that none of them is rounded up to the next power of ten.
        14 - significant(raw, ty, u8::MAX).exponent
    };
    let part = |places: i32, bits: i32| {
        let power = BigUint::from(10_u32).pow(u32::try_from(places).unwrap_or(0));
        power << u32::try_from(bits).unwrap_or(0)
    };
    let numerator = part(places, exponent) * significand;
    let raw = quotient::nearest(false, &numerator, &part(-places, -exponent), ty);
    let digits = if let Real::Finite(number) = real::decode(raw, ty)
        && let Whole::Number(number) = real::to_whole(number, Rounding::HalfAwayFromZero)
    {
        number.to_string()
    } else {
        "0".to_owned()
    };
    RoundedDecimal {
        exponent: digits.len() as i32 - 1 - places,
        digits: digits.trim_end_matches('0').to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fractions::{Fraction, distance, of_raw, scaled};
    use ElementaryType::{Lreal, Real as Single};
    use num_bigint::BigInt;
    use stickler_types::SplitMix64;

    /// Returns raw forms of positive finite numbers around each power of two, and scattered ones.
    fn raw_forms(ty: ElementaryType) -> impl Iterator<Item = u64> {
        let (shift, exponents) = if ty == Single { (23, 255) } else { (52, 2047) };
        let scattered = SplitMix64::new(1)
            .numbers()
            .map(move |bits| (bits >> 1) % (exponents << shift));
        let near_powers = (0..exponents).flat_map(move |exponent| {
            let first: u64 = exponent << shift;
            [first.saturating_sub(1), first, first + 1]
        });
        let raws = near_powers.chain(scattered.take(5_000));
        raws.filter(|&raw| raw != 0)
    }

    fn exact(raw: u64, ty: ElementaryType) -> Fraction {
        of_raw(raw, ty).expect("a finite number")
    }

    fn read_back(decimal: &Fraction, ty: ElementaryType) -> u64 {
        let [numerator, denominator] =
            [decimal.numer(), decimal.denom()].map(|part| part.to_biguint().unwrap_or_default());
        quotient::nearest(false, &numerator, &denominator, ty)
    }

    /// Returns the digits as one whole number, and the power of ten to multiply it with.
    fn joined(decimal: &RoundedDecimal) -> (BigInt, i32) {
        let scale = decimal.exponent + 1 - decimal.digits.len() as i32;
        (decimal.digits.parse().expect("digits"), scale)
    }

    #[test]
    fn the_shortest_digits_read_back_and_none_as_few_lie_nearer_and_no_fewer_do() {
        for (ty, raw) in [Single, Lreal]
            .into_iter()
            .flat_map(|ty| raw_forms(ty).map(move |raw| (ty, raw)))
        {
            let (number, scale) = joined(&shortest(raw, ty));
            let (exact, own) = (exact(raw, ty), scaled(number.clone(), 10, scale));
            assert_eq!(read_back(&own, ty), raw, "{number}E{scale}");
            for other in [&number - 1, &number + 1].map(|other| scaled(other, 10, scale)) {
                let is_nearer = distance(&other, &exact) < distance(&own, &exact);
                assert!(!is_nearer || read_back(&other, ty) != raw, "{number}E{scale}");
            }
            // With one digit less only these two could be next to the number.
            let fewer: BigInt = &number / 10;
            for other in [fewer.clone(), fewer + 1].map(|other| scaled(other, 10, scale + 1)) {
                let is_long = number >= BigInt::from(10) && other.numer() != &BigInt::ZERO;
                assert!(!is_long || read_back(&other, ty) != raw, "{number}E{scale}");
            }
        }
    }

    #[test]
    fn a_number_of_digits_is_rounded_to_the_nearest_and_half_to_even() {
        for (ty, raw) in [Single, Lreal]
            .into_iter()
            .flat_map(|ty| raw_forms(ty).step_by(7).map(move |raw| (ty, raw)))
        {
            for count in [1, 6, 10, 17, 255] {
                let decimal = significant(raw, ty, count);
                assert!((1..=usize::from(count)).contains(&decimal.digits.len()));
                let (number, scale) = joined(&decimal);
                let unit = scaled(1, 10, decimal.exponent + 1 - i32::from(count));
                let difference = distance(&scaled(number, 10, scale), &exact(raw, ty));
                assert!(
                    difference * BigInt::from(2) <= unit,
                    "{raw:X} with {count} digits"
                );
            }
        }
        let digits = |number: f64| significant(number.to_bits(), Lreal, 2).digits;
        assert_eq!([0.125, 0.375, 1.25, 9.75].map(digits), ["12", "38", "12", "98"]);
    }
}
