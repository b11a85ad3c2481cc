//! Decimal digits of real numbers: the fewest that read back, or a given number of them, by exact integers.

use crate::quotient;
use crate::real::{self, Real, Whole};
use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};
use std::cmp::Ordering;
use stickler_types::{ElementaryType, Rounding};

/// A positive number in decimal digits: `d.ddd * 10^exponent`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct RoundedDecimal {
    /// The digits, each from 0 to 9, the first and the last of them not 0.
    pub(super) digits: Vec<u8>,
    /// The power of ten of the first digit.
    pub(super) exponent: i32,
}

/// A positive fraction of integers of any size.
struct DecimalFraction {
    numerator: BigUint,
    denominator: BigUint,
}

impl DecimalFraction {
    /// Returns `significand * 2^exponent` as a fraction.
    fn binary(significand: u64, exponent: i32) -> DecimalFraction {
        DecimalFraction {
            numerator: BigUint::from(significand) << u32::try_from(exponent).unwrap_or(0),
            denominator: BigUint::from(1_u32) << u32::try_from(-exponent).unwrap_or(0),
        }
    }

    /// Returns the fraction multiplied by 10^places.
    fn scaled(&self, places: i32) -> DecimalFraction {
        let power = |places: i32| BigUint::from(10_u32).pow(u32::try_from(places).unwrap_or(0));
        DecimalFraction {
            numerator: &self.numerator * power(places),
            denominator: &self.denominator * power(-places),
        }
    }

    /// Returns the greatest integer that is not above the fraction, and whether there is a rest.
    fn floor(&self) -> (BigUint, bool) {
        let (below, rest) = self.numerator.div_rem(&self.denominator);
        (below, !rest.is_zero())
    }

    /// Returns the power of ten of the first digit.
    fn decimal_exponent(&self) -> i32 {
        let bits = |n: &BigUint| i64::try_from(n.bits()).unwrap_or(i64::MAX);
        // The logarithm to base 2 is above this, by less than two; 30103 / 100000 is that of 2 to base 10, rounded up.
        let log = bits(&self.numerator) - bits(&self.denominator) - 1;
        let mut exponent = (log * 30_103).div_euclid(100_000) as i32 - 1;
        while self.scaled(-exponent - 1).floor().0 > BigUint::zero() {
            exponent += 1;
        }
        exponent
    }
}

/// Returns the fewest digits that read back to the positive finite number `significand * 2^exponent` of the type; among
/// equally few digits those nearest to the number, and of two equally near ones the greater.
///
/// `is_lowest_of_binade` tells that the next smaller number is only half as far away as the next greater one.
///
/// Basis: harness/engines/README.md (how values are written), which leaves the nearness open.
pub(super) fn shortest(
    significand: u64,
    exponent: i32,
    is_lowest_of_binade: bool,
    ty: ElementaryType,
) -> RoundedDecimal {
    // 9 and 17 digits always read back; one more decides to which side the last of them is rounded.
    let most = if ty == ElementaryType::Real { 10 } else { 18 };
    let number = DecimalFraction::binary(significand, exponent);
    let first = number.decimal_exponent();
    let places = most - 1 - first;
    // What reads back lies between the middles to both neighbours. A middle itself reads as the even one.
    let below = if is_lowest_of_binade {
        DecimalFraction::binary(4 * significand - 1, exponent - 2)
    } else {
        DecimalFraction::binary(2 * significand - 1, exponent - 1)
    };
    let interval = Interval {
        least: Bound::of(&below, places),
        number: Bound::of(&number, places),
        greatest: Bound::of(
            &DecimalFraction::binary(2 * significand + 1, exponent - 1),
            places,
        ),
        closed: significand.is_multiple_of(2),
    };
    let found = (1..=most.unsigned_abs())
        .rev()
        .find_map(|dropped| interval.nearest_multiple(10_u64.pow(dropped)));
    decimal(&found.unwrap_or(interval.number.floor).to_string(), -places)
}

/// A bound, scaled so that the digits in question are whole: equal to `floor`, or greater by less than 1.
#[derive(Clone, Copy)]
struct Bound {
    floor: u64,
    has_rest: bool,
}

impl Bound {
    fn of(fraction: &DecimalFraction, places: i32) -> Bound {
        let (floor, has_rest) = fraction.scaled(places).floor();
        Bound {
            // About eighteen digits.
            floor: floor.to_u64().unwrap_or(u64::MAX),
            has_rest,
        }
    }

    /// Compares an integer with the bound.
    fn order(self, integer: u64) -> Ordering {
        match integer.cmp(&self.floor) {
            Ordering::Equal if self.has_rest => Ordering::Less,
            order => order,
        }
    }
}

/// A number, and the bounds of the interval in which every number reads back to it.
struct Interval {
    least: Bound,
    number: Bound,
    greatest: Bound,
    /// Whether the bounds belong to the interval.
    closed: bool,
}

impl Interval {
    /// Returns the multiple of an even `step` that lies within the bounds and nearest to the number; of two equally near
    /// ones the greater.
    ///
    /// If any multiple lies within, so does the next one below the number or the next one above.
    fn nearest_multiple(&self, step: u64) -> Option<u64> {
        let below = self.number.floor / step * step;
        let above = below + step;
        // Half a step is whole, so that what follows the number's floor cannot decide between below and above.
        let candidates = if self.number.floor - below < step / 2 {
            [below, above]
        } else {
            [above, below]
        };
        candidates.into_iter().find(|&candidate| self.contains(candidate))
    }

    fn contains(&self, integer: u64) -> bool {
        let (above, below) = (self.least.order(integer), self.greatest.order(integer));
        match self.closed {
            true => above.is_ge() && below.is_le(),
            false => above.is_gt() && below.is_lt(),
        }
    }
}

/// Returns the positive number `significand * 2^exponent` with `count` significant digits, at least one, rounded half to
/// even, without zeros at the end.
pub(super) fn significant(significand: u64, exponent: i32, count: u8) -> RoundedDecimal {
    let number = DecimalFraction::binary(significand, exponent);
    let places = i32::from(count.max(1)) - 1 - number.decimal_exponent();
    let scaled = number.scaled(places);
    let rounded = quotient::half_to_even(&scaled.numerator, &scaled.denominator);
    decimal(&rounded.to_string(), -places)
}

/// Returns the positive number `significand * 2^exponent` of a type as [`stickler_types::RealText::ByWidth`] scales and rounds it.
pub(super) fn scaled(significand: u64, exponent: i32, ty: ElementaryType) -> RoundedDecimal {
    let number = DecimalFraction::binary(significand, exponent);
    let places = if ty == ElementaryType::Real {
        // Basis: codesys-recording: REAL_TO_STRING; the digits that it shows follow from 10/33 in the place of the logarithm of 2.
        let binary = exponent + significand.ilog2() as i32;
        6 - (binary * 10).div_euclid(33)
    } else {
        14 - number.decimal_exponent()
    };
    let scaled = number.scaled(places);
    let raw = quotient::nearest(false, &scaled.numerator, &scaled.denominator, ty);
    let whole = match real::decode(raw, ty) {
        Real::Finite(number) => real::to_whole(number, Rounding::HalfAwayFromZero),
        _ => Whole::Huge { negative: false },
    };
    match whole {
        Whole::Number(number) => decimal(&number.to_string(), -places),
        Whole::Huge { .. } => decimal("0", 0),
    }
}

/// Returns the positive number with these decimal digits times 10^`exponent`.
fn decimal(written: &str, exponent: i32) -> RoundedDecimal {
    let digits: Vec<u8> = written
        .trim_end_matches('0')
        .bytes()
        .map(|digit| digit - b'0')
        .collect();
    RoundedDecimal {
        digits,
        exponent: exponent + written.len() as i32 - 1,
    }
}

#[cfg(test)]
mod tests;
