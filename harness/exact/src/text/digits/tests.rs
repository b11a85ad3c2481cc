//! Checks digits against the definition: that they read back, that fewer do not, and that no other equally few lie nearer.

use super::*;
use crate::real::{self, Real};
use ElementaryType::{Lreal, Real as Single};
use stickler_types::SplitMix64;

/// Returns raw forms of positive finite numbers around each power of two, and scattered ones.
fn raw_forms(ty: ElementaryType) -> Vec<u64> {
    let (shift, exponents) = if ty == Single { (23, 255) } else { (52, 2047) };
    let scattered = SplitMix64::new(1)
        .numbers()
        .map(|bits| (bits >> 1) % (exponents << shift));
    let near_powers = (0..exponents).flat_map(|exponent| {
        let first = exponent << shift;
        [first.saturating_sub(1), first, first + 1]
    });
    near_powers
        .chain(scattered.take(5_000))
        .filter(|&raw| raw != 0)
        .collect()
}

fn parts(raw: u64, ty: ElementaryType) -> (u64, i32) {
    match real::decode(raw, ty) {
        Real::Finite(number) => (number.significand, number.exponent),
        other => panic!("{raw:X} is {other:?}"),
    }
}

fn shortest_of(raw: u64, ty: ElementaryType) -> RoundedDecimal {
    let (significand, exponent) = parts(raw, ty);
    shortest(significand, exponent, real::is_lowest_of_binade(raw, ty), ty)
}

/// Returns `number * 10^exponent` as numerator and denominator.
fn decimal_fraction(number: impl Into<BigUint>, exponent: i32) -> (BigUint, BigUint) {
    let power = |exponent: i32| BigUint::from(10_u32).pow(u32::try_from(exponent).unwrap_or(0));
    (number.into() * power(exponent), power(-exponent))
}

fn read_back(number: impl Into<BigUint>, exponent: i32, ty: ElementaryType) -> u64 {
    let (numerator, denominator) = decimal_fraction(number, exponent);
    quotient::nearest(false, &numerator, &denominator, ty)
}

/// Returns the digits as one whole number, and the power of ten to multiply it with.
fn joined(decimal: &RoundedDecimal) -> (u64, i32) {
    let number = decimal
        .digits
        .iter()
        .fold(0, |number, &digit| number * 10 + u64::from(digit));
    (number, decimal.exponent + 1 - decimal.digits.len() as i32)
}

/// Returns the distance of `number * 10^exponent` from a real number, multiplied by the product of both denominators.
fn distance(number: u64, exponent: i32, raw: u64, ty: ElementaryType) -> BigUint {
    let (significand, binary_exponent) = parts(raw, ty);
    let exact = DecimalFraction::binary(significand, binary_exponent);
    let (numerator, denominator) = decimal_fraction(number, exponent);
    let (one, other) = (numerator * exact.denominator, exact.numerator * denominator);
    if one > other { one - other } else { other - one }
}

#[test]
fn the_shortest_digits_read_back_and_none_as_few_lie_nearer() {
    for ty in [Single, Lreal] {
        for raw in raw_forms(ty) {
            let decimal = shortest_of(raw, ty);
            let (number, exponent) = joined(&decimal);
            assert_eq!(read_back(number, exponent, ty), raw, "{number}E{exponent}");
            let own = distance(number, exponent, raw, ty);
            for other in [number - 1, number + 1] {
                let others = distance(other, exponent, raw, ty);
                assert!(
                    read_back(other, exponent, ty) != raw
                        || own < others
                        || (own == others && number > other),
                    "{other}E{exponent} is as near to {raw:X} as {number}E{exponent}"
                );
            }
        }
    }
}

#[test]
fn no_fewer_digits_read_back() {
    for ty in [Single, Lreal] {
        for raw in raw_forms(ty) {
            let (number, exponent) = joined(&shortest_of(raw, ty));
            // With one digit less only these two could be next to the number. The power of ten above may have still fewer.
            for fewer in [number / 10, number / 10 + 1] {
                let is_shorter = fewer.to_string().trim_end_matches('0').len() < number.to_string().len();
                assert!(
                    fewer == 0 || !is_shorter || number < 10 || read_back(fewer, exponent + 1, ty) != raw,
                    "{fewer}E{} would do for {raw:X}",
                    exponent + 1
                );
            }
        }
    }
}

fn spelled(decimal: &RoundedDecimal) -> String {
    decimal
        .digits
        .iter()
        .map(|digit| char::from(b'0' + digit))
        .collect()
}

#[test]
fn the_canonical_writer_of_literals_finds_the_same_digits() {
    for ty in [Single, Lreal] {
        for raw in raw_forms(ty) {
            let mut written = String::new();
            stickler_types::literal::write_real(&mut written, raw, ty).unwrap();
            let digits = written.split('E').next().unwrap_or_default().replace('.', "");
            let decimal = shortest_of(raw, ty);
            assert_eq!(spelled(&decimal), digits.trim_matches('0'), "{written}");
        }
    }
}

#[test]
fn of_two_equally_near_the_greater_is_taken() {
    // 2097152.25, where neighbours are a quarter apart: both .2 and .3 read back, and are .05 away.
    let (significand, exponent) = (2_097_152 * 4 + 1, -2);
    let decimal = shortest(significand, exponent, false, Single);
    assert_eq!(decimal.digits, [2, 0, 9, 7, 1, 5, 2, 3]);
    // The least number of all: from 3 to 7 times 1E-324 all would read back.
    assert_eq!(shortest(1, -1074, false, Lreal).digits, [5]);
}

#[test]
fn the_number_of_significant_digits_is_kept() {
    for ty in [Single, Lreal] {
        for raw in raw_forms(ty).into_iter().step_by(7) {
            let (significand, exponent) = parts(raw, ty);
            for count in [1, 6, 10, 17] {
                let decimal = significant(significand, exponent, count);
                assert!((1..=usize::from(count)).contains(&decimal.digits.len()));
                let (number, places) = joined(&decimal);
                // Half a unit of the last place that was asked for, and no more.
                let unit = decimal.exponent + 1 - i32::from(count);
                let (numerator, denominator) = decimal_fraction(1_u32, unit);
                let exact = DecimalFraction::binary(significand, exponent);
                // Both differences have the product of the denominators in common.
                let difference = distance(number, places, raw, ty) * &denominator * 2_u32;
                let (_, own_denominator) = decimal_fraction(number, places);
                let bound = numerator * exact.denominator * own_denominator;
                assert!(difference <= bound, "{raw:X} with {count} digits");
            }
            // 255 digits are more than enough to read back.
            let decimal = significant(significand, exponent, 255);
            let digits = spelled(&decimal);
            let scale = decimal.exponent + 1 - digits.len() as i32;
            assert_eq!(read_back(digits.parse::<BigUint>().unwrap(), scale, ty), raw);
        }
    }
}
