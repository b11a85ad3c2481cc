//! Holds the conversions to arithmetic on integers, which knows no floating point and so cannot share its
//! mistakes.

use super::real::{decode, parts};
use super::{Conversion, ConversionRule};
use ElementaryType::{Bool, Dt, Lreal, Real, Time, Tod};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ConversionChoices, ElementaryType, OutOfRange, Rounding, SplitMix64};

fn conversion(from: ElementaryType, to: ElementaryType, rounding: Rounding) -> Conversion {
    let choices = COMMON_CHOICES.with_rounding(rounding);
    let rule = ConversionRule::between(from, to, &choices).expect("the pair has a meaning");
    Conversion { from, to, rule }
}

fn convert(from: ElementaryType, to: ElementaryType, raw: u64) -> u64 {
    conversion(from, to, Rounding::Truncate).apply(raw)
}

/// Bits around each power of two, and scattered ones of every length.
fn telling_bits() -> impl Iterator<Item = u64> {
    let around = (0..64).flat_map(|n| [-2_i64, -1, 0, 1, 2].map(|by| (1_u64 << n).wrapping_add_signed(by)));
    let scattered = SplitMix64::new(1)
        .numbers()
        .take(20_000)
        .enumerate()
        .map(|(n, bits)| bits >> (n % 64));
    around
        .chain(scattered)
        .flat_map(|bits| [bits, bits.wrapping_neg()])
}

fn integers() -> impl Iterator<Item = ElementaryType> {
    ElementaryType::ALL.into_iter().filter(|ty| ty.is_whole())
}

/// The nearest number with so many significant bits, ties to even.
fn rounded(value: i128, digits: u32) -> i128 {
    let magnitude = value.unsigned_abs();
    let excess = (128 - magnitude.leading_zeros()).saturating_sub(digits);
    if excess == 0 {
        return value;
    }
    let (kept, cut, half) = (
        magnitude >> excess,
        magnitude & ((1 << excess) - 1),
        1 << (excess - 1),
    );
    let up = cut > half || (cut == half && kept % 2 == 1);
    ((kept + u128::from(up)) << excess).cast_signed() * value.signum()
}

#[test]
fn integers_become_each_other_modulo_the_target_s_width() {
    for from in integers().chain([Bool]) {
        for to in integers().filter(|&to| to != from) {
            for bits in telling_bits().step_by(7) {
                let raw = from.wrap(bits.into());
                let expected = to.wrap(from.integer_value(raw));
                assert_eq!(convert(from, to, raw), expected, "{bits:#x}: {from} to {to}");
            }
        }
    }
}

#[test]
fn integers_become_reals_with_one_rounding() {
    for from in integers() {
        for bits in telling_bits() {
            let raw = from.wrap(bits.into());
            let value = from.integer_value(raw);
            let real = decode(convert(from, Real, raw), Real) as i128;
            assert_eq!(real, rounded(value, 24), "{value} of {from} as REAL");
            let long_real = decode(convert(from, Lreal, raw), Lreal) as i128;
            assert_eq!(long_real, rounded(value, 53), "{value} of {from} as LREAL");
        }
    }
}

#[test]
fn long_reals_become_reals_with_one_rounding() {
    for bits in telling_bits() {
        // Any significand, with an exponent at which it is an integer of 128 bits.
        let value = f64::from_bits((bits & !(0x7FF << 52)) | ((1023 + 52 + bits % 60) << 52));
        let real = decode(convert(Lreal, Real, value.to_bits()), Real);
        assert_eq!(real as i128, rounded(value as i128, 24), "{value}");
        assert_eq!(
            convert(Real, Lreal, convert(Lreal, Real, value.to_bits())),
            real.to_bits()
        );
    }
}

/// A finite real number rounded to an integer, modulo 2^64, bit by bit.
fn integer_modulo(value: f64, rounding: Rounding) -> u64 {
    let (significand, exponent) = parts(value);
    let negative = value.is_sign_negative();
    let mut whole = significand;
    let (mut half, mut rest) = (false, false);
    for _ in 0..exponent.unsigned_abs() {
        if exponent > 0 {
            whole = whole.wrapping_mul(2);
        } else {
            rest |= half;
            half = whole % 2 == 1;
            whole /= 2;
        }
    }
    let away = match rounding {
        Rounding::Truncate => false,
        Rounding::HalfToEven => half && (rest || whole % 2 == 1),
        Rounding::HalfAwayFromZero => half,
        Rounding::Up => (half || rest) && !negative,
        Rounding::Down => (half || rest) && negative,
        Rounding::AwayFromZero => half || rest,
    };
    let magnitude = whole.wrapping_add(away.into());
    if negative {
        magnitude.wrapping_neg()
    } else {
        magnitude
    }
}

/// Real numbers at which roundings and ranges differ, and scattered ones.
fn reals() -> impl Iterator<Item = f64> {
    const SPECIAL: &str = "0 -0 0.5 1.5 2.5 -0.5 -1.5 0.49999999999999994 4503599627370497.5 1e300 -1e300 9.2e18 9223372036854775807 \
        -9223372036854775808 1.9e19 127.4 127.5 127.6 128 -128.5 -128.6 -129 1e18 1e19 2e19 -1e19";
    let special = SPECIAL
        .split_whitespace()
        .map(|number| number.parse().expect("a number"));
    special.chain(SplitMix64::new(2).numbers().take(20_000).map(|bits| {
        // Exponents from far below 1 to where only zeros are left of 64 bits.
        f64::from_bits((bits & !(0x7FF << 52)) | ((1023 - 60 + bits % 190) << 52))
    }))
}

#[test]
fn reals_become_integers_modulo_the_target_s_width_or_the_nearest_that_it_holds() {
    for value in reals() {
        for rounding in Rounding::ALL {
            let whole = integer_modulo(value, rounding).cast_signed();
            // Beyond 2^62 the numbers are whole, and below 128 bits hold them.
            let unbounded = if value.abs() < 4e18 {
                whole.into()
            } else {
                value as i128
            };
            for to in integers() {
                let converted = |out_of_range| {
                    let rule = ConversionRule::FromReal(rounding, out_of_range);
                    Conversion {
                        from: Lreal,
                        to,
                        rule,
                    }
                    .apply(value.to_bits())
                };
                let wrapped = converted(OutOfRange::Wrap);
                assert_eq!(wrapped, to.wrap(whole.into()), "{value} {rounding:?} to {to}");
                let (low, high) = to.integer_range().expect("an integer");
                let nearest = to.wrap(unbounded.clamp(low, high));
                assert_eq!(
                    converted(OutOfRange::Saturate),
                    nearest,
                    "{value} {rounding:?} to {to}"
                );
            }
        }
    }
}

/// Returns whether a real number is the nearest to `nanoseconds / 1 000 000`: neither neighbour is nearer.
fn is_nearest(nanoseconds: i128, ty: ElementaryType, raw: u64) -> bool {
    let distance = |raw: u64| {
        let value = decode(raw, ty);
        let (significand, exponent) = parts(value);
        assert!(
            (-80..=0).contains(&exponent),
            "the test's numbers stay within 128 bits"
        );
        let milliseconds = i128::from(significand) * if value < 0.0 { -1 } else { 1 };
        (milliseconds * 1_000_000 - (nanoseconds << -exponent)).unsigned_abs()
    };
    // Neighbours across a power of two have another exponent; there one comparison of two is enough.
    let same_exponent = |other: u64| parts(decode(other, ty)).1 == parts(decode(raw, ty)).1;
    [raw - 1, raw + 1]
        .into_iter()
        .filter(|&other| same_exponent(other))
        .all(|other| distance(raw) <= distance(other))
}

#[test]
fn what_is_no_number_becomes_zero() {
    for value in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for to in integers().chain([Time, Tod, Dt]) {
            assert_eq!(convert(Real, to, value.to_bits().into()), 0, "{value} to {to}");
        }
    }
}

#[test]
fn durations_become_reals_with_one_rounding() {
    for bits in SplitMix64::new(3)
        .numbers()
        .take(20_000)
        .enumerate()
        .map(|(n, bits)| (bits >> (1 + n % 62)) | 1)
    {
        for ty in [Real, Lreal] {
            assert!(
                is_nearest(bits.into(), ty, convert(Time, ty, bits)),
                "{bits} ns as {ty}"
            );
            let negative = convert(Time, ty, bits.wrapping_neg());
            assert_eq!(decode(negative, ty), -decode(convert(Time, ty, bits), ty));
        }
    }
}

#[test]
fn a_real_becomes_the_duration_that_the_same_long_real_becomes() {
    for bits in SplitMix64::new(5).numbers().take(20_000).map(|bits| bits >> 32) {
        let long = convert(Real, Lreal, bits);
        for to in [Time, Tod, Dt] {
            assert_eq!(
                convert(Real, to, bits),
                convert(Lreal, to, long),
                "{bits:#x} to {to}"
            );
        }
    }
}

#[test]
fn many_values_are_converted_as_each_one_is() {
    let outside = |rounding| {
        OutOfRange::ALL
            .iter()
            .map(move |&out_of_range| (rounding, out_of_range))
    };
    let plain = || ElementaryType::ALL.into_iter().filter(|ty| !ty.is_text());
    for (rounding, out_of_range) in Rounding::ALL.into_iter().flat_map(outside) {
        let choices = ConversionChoices {
            out_of_range,
            ..COMMON_CHOICES.with_rounding(rounding)
        };
        for (from, to) in plain().flat_map(|from| plain().map(move |to| (from, to))) {
            let Some(rule) = ConversionRule::between(from, to, &choices) else {
                continue;
            };
            let conversion = Conversion { from, to, rule };
            let numbers = SplitMix64::new(7).numbers().take(40);
            let operands: Vec<u64> = numbers.map(|bits| crate::raw::narrow(bits, from)).collect();
            let mut results = vec![0; operands.len()];
            conversion.apply_to_slice(&operands, &mut results);
            let each: Vec<u64> = operands
                .iter()
                .map(|operand| conversion.apply(*operand))
                .collect();
            assert_eq!(results, each, "{conversion:?} of {operands:x?}");
        }
    }
}
