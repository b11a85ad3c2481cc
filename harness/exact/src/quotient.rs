//! Quotients of integers of any size, rounded once: to an integer, or to a number of IEC 60559.

use crate::real;
use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};
use std::cmp::Ordering;
use stickler_types::ElementaryType;

/// Returns the raw form nearest to `numerator / denominator` or its negative, ties to even; zero keeps the sign.
///
/// This is [`real::nearest`] for numbers of any size. The denominator must not be zero.
pub(crate) fn nearest(negative: bool, numerator: &BigUint, denominator: &BigUint, to: ElementaryType) -> u64 {
    // Enough bits for either format and the two below that decide the rounding.
    const MIN_BITS: i32 = 66;
    let bits = |n: &BigUint| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    // The bits before the point, or one more. Far outside the formats their exact number does not matter.
    let length = bits(numerator)
        .saturating_sub(bits(denominator))
        .clamp(-100_000, 100_000) as i32
        + 1;
    let shift = MIN_BITS - length;
    let (quotient, rest) = shifted(numerator, shift).div_rem(&shifted(denominator, -shift));
    let magnitude = quotient.to_u128().unwrap_or(u128::MAX);
    real::nearest(negative, magnitude, !rest.is_zero(), -shift, to)
}

/// Returns `number * 2^exponent` for a positive exponent, and `number` otherwise.
fn shifted(number: &BigUint, exponent: i32) -> BigUint {
    number << u32::try_from(exponent).unwrap_or(0)
}

/// Returns the integer nearest to `numerator / denominator`, ties to even. The denominator must not be zero.
pub(crate) fn half_to_even(numerator: &BigUint, denominator: &BigUint) -> BigUint {
    let (below, rest) = numerator.div_rem(denominator);
    let up = match (rest * 2_u32).cmp(denominator) {
        Ordering::Less => false,
        Ordering::Greater => true,
        Ordering::Equal => below.is_odd(),
    };
    below + u32::from(up)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fractions::{Fraction, distance, of_raw};
    use ElementaryType::{Lreal, Real};
    use num_bigint::BigInt;

    fn number(raw: u64, ty: ElementaryType) -> Fraction {
        of_raw(raw, ty).expect("a finite number")
    }

    /// Checks a result against the definition: no finite number is nearer, and of two equally near ones it is the even one.
    fn check(numerator: &BigUint, denominator: &BigUint, ty: ElementaryType) {
        let exact = Fraction::new(numerator.clone().into(), denominator.clone().into());
        let raw = nearest(false, numerator, denominator, ty);
        let distance = |raw| distance(&number(raw, ty), &exact);
        for other in [raw.saturating_sub(1), raw + 1] {
            if other == raw || other == real::infinite(false, ty) {
                continue;
            }
            let (own, others) = (distance(raw), distance(other));
            assert!(
                own < others || (own == others && raw.is_multiple_of(2)),
                "{exact} gave {raw:X}, but {other:X} is nearer"
            );
        }
    }

    #[test]
    fn a_quotient_gives_the_nearest_number_and_the_even_one_of_two() {
        let mut numbers = stickler_types::SplitMix64::new(1).numbers();
        let mut next = || numbers.next().unwrap_or_default() >> 11;
        for _ in 0..2_000 {
            let (numerator, denominator) = (BigUint::from(next()), BigUint::from(next() | 1));
            let shift = next() % 280;
            for ty in [Real, Lreal] {
                check(&(&numerator << (shift % 70)), &denominator, ty);
                check(&numerator, &(&denominator << (shift % 120)), ty);
            }
            check(&(&numerator << shift), &denominator, Lreal);
            check(&numerator, &(&denominator << (4 * shift)), Lreal);
        }
    }

    #[test]
    fn ties_between_neighbours_go_to_the_even_one() {
        for ty in [Real, Lreal] {
            let raws = [0x7F_FFFF, 0x80_0000, 0x3F80_0000, 0x3F80_0001, 0x7F7F_FFFE];
            for raw in (0..4).chain(raws) {
                let between = (number(raw, ty) + number(raw + 1, ty)) / BigInt::from(2);
                let (numerator, denominator) = between.into_raw();
                let [numerator, denominator] = [numerator, denominator].map(|n| n.to_biguint().unwrap());
                assert_eq!(nearest(false, &numerator, &denominator, ty), raw + raw % 2);
                let many = 1_000_000_000_000_u64;
                let above = nearest(false, &(&numerator * many + 1_u32), &(denominator * many), ty);
                assert_eq!(above, raw + 1);
            }
        }
    }

    #[test]
    fn what_is_far_outside_becomes_zero_or_an_infinity() {
        let (one, large) = (BigUint::from(1_u32), BigUint::from(1_u32) << 300_000_u32);
        for ty in [Real, Lreal] {
            assert_eq!(nearest(false, &large, &one, ty), real::infinite(false, ty));
            assert_eq!(nearest(true, &large, &one, ty), real::infinite(true, ty));
            assert_eq!(nearest(false, &one, &large, ty), 0);
            assert_eq!(nearest(true, &one, &large, ty), 1 << (ty.bits() - 1));
            assert_eq!(nearest(true, &BigUint::zero(), &large, ty), 1 << (ty.bits() - 1));
        }
    }

    #[test]
    fn a_quotient_is_rounded_to_the_nearest_integer() {
        let rounded = |numerator: u32, denominator: u32| half_to_even(&numerator.into(), &denominator.into());
        let given =
            [(1, 2), (3, 2), (5, 2), (7, 3), (8, 3), (6, 3)].map(|(above, below)| rounded(above, below));
        assert_eq!(given, [0_u32, 2, 2, 2, 3, 2].map(BigUint::from));
    }
}
