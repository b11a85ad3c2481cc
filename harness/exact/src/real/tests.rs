//! Compares the arithmetic on machine integers with fractions of any size, and with the definition of the formats.

use super::*;
use crate::fractions::{Fraction, of_raw, scaled};
use ElementaryType::{Lreal, Real as Single};
use num_bigint::{BigInt, BigUint};
use std::cmp::Ordering;
use stickler_types::SplitMix64;

/// Returns raw forms around each boundary of the format, and scattered ones.
fn raw_forms(ty: ElementaryType) -> impl Iterator<Item = u64> {
    let shift = if ty == Single { 23 } else { 52 };
    let exponents = 1_u64 << (ty.bits() - 1 - shift);
    let boundaries = (0..exponents).flat_map(move |exponent| {
        let first = exponent << shift;
        [
            first,
            first + 1,
            first | 1 << (shift - 1),
            (first | ((1 << shift) - 1)),
            first ^ 5,
        ]
    });
    let mask = u64::MAX >> (64 - ty.bits());
    let sign = 1 << (ty.bits() - 1);
    let positive = boundaries
        .chain(SplitMix64::new(1).numbers().take(20_000))
        .map(move |raw| raw & mask & !sign);
    positive.flat_map(move |raw| [raw, raw | sign])
}

/// Returns the number of a finite raw form, by the definition of IEC 60559: for a biased exponent above 0 `(-1)^sign *
/// 2^(biased - bias) * (1 + fraction / 2^p)`, and for 0 `(-1)^sign * 2^(1 - bias) * fraction / 2^p`.
fn by_definition(raw: u64, ty: ElementaryType) -> Option<Fraction> {
    let (fraction_bits, exponent_bits) = if ty == Single { (23, 8) } else { (52, 11) };
    let bias = (1 << (exponent_bits - 1)) - 1;
    let fraction = Fraction::new(
        (raw % (1 << fraction_bits)).into(),
        BigInt::from(1) << fraction_bits,
    );
    let biased = (raw >> fraction_bits) % (1 << exponent_bits);
    let two = Fraction::from_integer(2.into());
    let magnitude = match biased {
        0 => two.pow(1 - bias) * fraction,
        _ if biased == (1 << exponent_bits) - 1 => return None,
        _ => two.pow(biased as i32 - bias) * (Fraction::from_integer(1.into()) + fraction),
    };
    Some(if raw >> (fraction_bits + exponent_bits) == 1 {
        -magnitude
    } else {
        magnitude
    })
}

#[test]
fn bits_are_taken_apart_by_definition_and_put_together_again() {
    for ty in [Single, Lreal] {
        for raw in raw_forms(ty) {
            let decoded = decode(raw, ty);
            assert_eq!(of_raw(raw, ty), by_definition(raw, ty), "{raw:X}");
            if let Real::Finite(number) = decoded {
                let significand = number.significand.into();
                assert_eq!(
                    nearest(number.negative, significand, false, number.exponent, ty),
                    raw
                );
            }
        }
    }
    assert_eq!(
        decode(infinite(true, Single), Single),
        Real::Infinite { negative: true }
    );
    assert_eq!(
        decode(infinite(false, Lreal), Lreal),
        Real::Infinite { negative: false }
    );
    assert_eq!(decode(not_a_number(Single), Single), Real::NotANumber);
    assert_eq!(decode(0xFF80_0001, Single), Real::NotANumber);
    assert_eq!(
        [not_a_number(Single), not_a_number(Lreal)],
        [0x7FC0_0000, 0x7FF8_0000_0000_0000]
    );
}

/// Returns the raw form that the definition requires, found by bisection over all positive raw forms.
fn by_search(magnitude: &Fraction, ty: ElementaryType) -> u64 {
    let (mut least, mut beyond) = (0, infinite(false, ty));
    while beyond - least > 1 {
        let middle = least + (beyond - least) / 2;
        if by_definition(middle, ty).is_some_and(|number| number <= *magnitude) {
            least = middle;
        } else {
            beyond = middle;
        }
    }
    let below = by_definition(least, ty).unwrap();
    // Above the largest finite number stands what would be next if the exponents went on.
    let above = by_definition(beyond, ty)
        .unwrap_or_else(|| &below * BigInt::from(2) - by_definition(least - 1, ty).unwrap());
    match (magnitude - below).cmp(&(above - magnitude)) {
        Ordering::Less => least,
        Ordering::Equal => least + least % 2,
        Ordering::Greater => beyond,
    }
}

#[test]
fn rounding_gives_the_nearest_number_of_all() {
    let mut source = SplitMix64::new(1).numbers();
    let mut next = || source.next().unwrap_or_default();
    for ty in [Single, Lreal] {
        let (least, greatest) = if ty == Single { (-160, 110) } else { (-1090, 1000) };
        for round in 0..600 {
            let bits = next() % 60;
            // Half of them with few bits set, so that ties and exact numbers come up.
            let magnitude = match round % 2 {
                0 => (next() >> bits) & next(),
                _ => (1 << (next() % 63)) | (1 << (next() % 63)),
            };
            let exponent = least + (next() % (greatest - least) as u64) as i32;
            let exact = scaled(magnitude, 2, exponent);
            let given = nearest(false, magnitude.into(), false, exponent, ty);
            assert_eq!(given, by_search(&exact, ty), "{magnitude} * 2^{exponent} as {ty}");
            let numerator = BigUint::from(magnitude) << exponent.max(0);
            let denominator = BigUint::from(1_u32) << (-exponent).max(0);
            assert_eq!(
                given,
                crate::quotient::nearest(false, &numerator, &denominator, ty)
            );
        }
    }
}

#[test]
fn the_edges_of_the_formats() {
    let power = |exponent, ty| nearest(false, 1, false, exponent, ty);
    assert_eq!(
        [power(-149, Single), power(-150, Single), power(-151, Single)],
        [1, 0, 0]
    );
    assert_eq!([power(-1074, Lreal), power(-1075, Lreal)], [1, 0]);
    assert_eq!(nearest(false, 3, false, -151, Single), 1);
    assert_eq!(power(127, Single), 0x7F00_0000);
    assert_eq!(power(128, Single), infinite(false, Single));
    // 2^128 - 2^103 lies in the middle between the largest finite number and what would be next.
    let middle = (1_u128 << 25) - 1;
    assert_eq!(nearest(true, middle, false, 103, Single), infinite(true, Single));
    assert_eq!(nearest(false, (middle << 80) - 1, false, 23, Single), 0x7F7F_FFFF);
    assert_eq!(nearest(true, 0, false, 0, Lreal), 1 << 63);
    // 2^-1022 is the least normal number; a unit below it is the largest subnormal one.
    assert_eq!(nearest(false, (1 << 53) - 1, false, -1075, Lreal), 1 << 52);
    assert_eq!(nearest(false, (1 << 54) - 3, false, -1076, Lreal), (1 << 52) - 1);
}

fn whole_by_fractions(exact: &Fraction, rounding: Rounding) -> BigInt {
    let half = Fraction::new(1.into(), 2.into());
    let away = |exact: &Fraction| {
        if exact.numer().sign() == num_bigint::Sign::Minus {
            (exact - &half).ceil()
        } else {
            (exact + &half).floor()
        }
    };
    let whole = match rounding {
        Rounding::Truncate => exact.trunc(),
        Rounding::Up => exact.ceil(),
        Rounding::Down => exact.floor(),
        Rounding::AwayFromZero if exact.numer().sign() == num_bigint::Sign::Minus => exact.floor(),
        Rounding::AwayFromZero => exact.ceil(),
        Rounding::HalfAwayFromZero => away(exact),
        Rounding::HalfToEven => {
            let below = exact.floor();
            let is_odd = (below.to_integer() % 2) != BigInt::ZERO;
            match (exact - &below).cmp(&half) {
                Ordering::Less => below,
                Ordering::Equal if !is_odd => below,
                _ => below + BigInt::from(1),
            }
        }
    };
    whole.to_integer()
}

#[test]
fn integers_are_those_that_fractions_round_to() {
    for ty in [Single, Lreal] {
        // Exponents around one, where there is something to round, come up too rarely by chance.
        let near_one = SplitMix64::new(1).numbers().take(20_000).map(|bits| {
            let (shift, bias) = if ty == Single { (23, 127) } else { (52, 1023) };
            let exponent = bias + bits % 66 - 3;
            (bits & ((1 << shift) - 1) & !(u64::MAX >> (bits >> 58))) | exponent << shift
        });
        for raw in raw_forms(ty).chain(near_one) {
            let Real::Finite(finite) = decode(raw, ty) else {
                continue;
            };
            let exact = by_definition(raw, ty).unwrap();
            for rounding in Rounding::ALL {
                let expected = whole_by_fractions(&exact, rounding);
                match to_whole(finite, rounding) {
                    Whole::Number(number) => {
                        assert_eq!(BigInt::from(number), expected, "{raw:X} {rounding:?}")
                    }
                    Whole::Huge { negative } => {
                        let modulus: BigInt = BigInt::from(1) << 64;
                        assert_eq!(expected.clone() % &modulus, BigInt::ZERO, "{raw:X}");
                        assert_eq!(negative, expected < BigInt::ZERO);
                        assert!(expected.magnitude() >= modulus.magnitude());
                    }
                }
            }
        }
    }
}
