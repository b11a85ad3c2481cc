//! Holds the conversions to arithmetic on integers, which knows no floating point and so cannot share its
//! mistakes.

use super::real::{decode, parts};
use super::{Conversion, ConversionRule};
use ElementaryType::{
    Bool, Byte, Dint, Dt, Int, Lint, Lreal, Lword, Real, Time, Tod, Udint, Uint, Ulint, Word,
};
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
    ElementaryType::ALL
        .into_iter()
        .filter(|ty| ty.is_integer() || ty.is_bit_string())
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
                assert_eq!(
                    convert(from, to, raw),
                    expected,
                    "{bits:#x}: {} to {}",
                    from.name(),
                    to.name()
                );
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
            assert_eq!(real, rounded(value, 24), "{value} of {} as REAL", from.name());
            let long_real = decode(convert(from, Lreal, raw), Lreal) as i128;
            assert_eq!(
                long_real,
                rounded(value, 53),
                "{value} of {} as LREAL",
                from.name()
            );
        }
    }
    // By way of LREAL this one would be rounded to a tie first, and then to even, down.
    let twice = (1 << 60) + (1 << 36) + 1;
    assert_eq!(
        convert(Lint, Real, twice),
        u64::from(((1_u64 << 60) as f32 + (1_u64 << 37) as f32).to_bits())
    );
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
    let too_big = f64::from(f32::MAX) * 2.0;
    assert_eq!(
        convert(Lreal, Real, too_big.to_bits()),
        u64::from(f32::INFINITY.to_bits())
    );
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
    };
    let magnitude = whole.wrapping_add(away.into());
    if negative {
        magnitude.wrapping_neg()
    } else {
        magnitude
    }
}

#[test]
fn reals_become_integers_modulo_the_target_s_width() {
    let special = [
        0.0,
        -0.0,
        0.5,
        1.5,
        2.5,
        -0.5,
        -1.5,
        0.499_999_999_999_999_94,
        4_503_599_627_370_497.5,
        1e300,
        -1e300,
    ];
    let special = special.into_iter().chain([
        9.2e18,
        9_223_372_036_854_775_807.0,
        -9_223_372_036_854_775_808.0,
        1.9e19,
    ]);
    let scattered = SplitMix64::new(2).numbers().take(20_000).map(|bits| {
        // Exponents from far below 1 to where only zeros are left of 64 bits.
        f64::from_bits((bits & !(0x7FF << 52)) | ((1023 - 60 + bits % 190) << 52))
    });
    for value in special.chain(scattered) {
        for rounding in [
            Rounding::Truncate,
            Rounding::HalfToEven,
            Rounding::HalfAwayFromZero,
            Rounding::Up,
            Rounding::Down,
        ] {
            let whole = integer_modulo(value, rounding);
            for to in integers() {
                let got = conversion(Lreal, to, rounding).apply(value.to_bits());
                assert_eq!(
                    got,
                    to.wrap(whole.cast_signed().into()),
                    "{value} {rounding:?} to {}",
                    to.name()
                );
            }
        }
    }
}

#[test]
fn reals_become_the_nearest_integer_that_the_target_holds_where_that_is_chosen() {
    let special = [
        127.4, 127.5, 127.6, 128.0, -128.5, -128.6, -129.0, 0.5, -0.5, 1e18, 1e19, 2e19, -1e19, 1e300,
    ];
    for value in special {
        for rounding in [
            Rounding::Truncate,
            Rounding::HalfToEven,
            Rounding::HalfAwayFromZero,
            Rounding::Up,
            Rounding::Down,
        ] {
            for to in integers() {
                let rule = ConversionRule::FromReal(rounding, OutOfRange::Saturate);
                let got = Conversion {
                    from: Lreal,
                    to,
                    rule,
                }
                .apply(f64::to_bits(value));
                let (low, high) = to.integer_range().expect("an integer");
                // Beyond 2^62 the numbers are whole, and below 128 bits hold them.
                let whole = if value.abs() < 4e18 {
                    i128::from(integer_modulo(value, rounding).cast_signed())
                } else {
                    value as i128
                };
                let expected = to.wrap(whole.clamp(low, high));
                assert_eq!(got, expected, "{value} {rounding:?} to {}", to.name());
            }
        }
    }
    for (value, expected) in [
        (f32::NAN, 0),
        (f32::INFINITY, 127),
        (f32::NEG_INFINITY, -128),
        (f32::MAX, 127),
    ] {
        let rule = ConversionRule::FromReal(Rounding::Truncate, OutOfRange::Saturate);
        let (from, to) = (Real, ElementaryType::Sint);
        let got = Conversion { from, to, rule }.apply(value.to_bits().into());
        assert_eq!(got.cast_signed(), expected, "{value}");
    }
}

#[test]
fn many_values_are_converted_as_each_one_is() {
    let roundings = [
        Rounding::Truncate,
        Rounding::HalfToEven,
        Rounding::HalfAwayFromZero,
        Rounding::Up,
        Rounding::Down,
    ];
    let choices = roundings.into_iter().flat_map(|rounding| {
        OutOfRange::ALL.iter().map(move |out_of_range| ConversionChoices {
            out_of_range: *out_of_range,
            ..COMMON_CHOICES.with_rounding(rounding)
        })
    });
    for choices in choices {
        for from in ElementaryType::ALL.into_iter().filter(|ty| !ty.is_text()) {
            for to in ElementaryType::ALL.into_iter().filter(|ty| !ty.is_text()) {
                let Some(rule) = ConversionRule::between(from, to, &choices) else {
                    continue;
                };
                let conversion = Conversion { from, to, rule };
                let operands = SplitMix64::new(7)
                    .numbers()
                    .take(40)
                    .map(|bits| crate::raw::narrow(bits, from));
                conversion.apply_to_all(operands, |operand, result| {
                    assert_eq!(
                        result,
                        conversion.apply(operand),
                        "{conversion:?} of {operand:#x}"
                    );
                });
            }
        }
    }
}

#[test]
fn what_is_no_number_becomes_zero() {
    for value in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for to in integers().chain([Time, Tod, Dt]) {
            assert_eq!(
                convert(Real, to, value.to_bits().into()),
                0,
                "{value} to {}",
                to.name()
            );
        }
    }
}

#[test]
fn only_zero_is_false() {
    assert_eq!([0, 1, u64::MAX].map(|raw| convert(Lint, Bool, raw)), [0, 1, 1]);
    let real = |value: f64| convert(Lreal, Bool, value.to_bits());
    assert_eq!([0.0, -0.0, f64::MIN_POSITIVE, f64::NAN].map(real), [0, 0, 1, 1]);
    assert_eq!(convert(Real, Bool, (-0.0_f32).to_bits().into()), 0);
    assert_eq!(convert(Bool, Real, 1), u64::from(1.0_f32.to_bits()));
    assert_eq!(convert(Bool, Byte, 1), 1);
}

#[test]
fn durations_count_in_milliseconds() {
    assert_eq!(convert(Time, Dint, 1_500_999_999), 1_500);
    assert_eq!(
        convert(Time, Dint, (-1_999_999_i64).cast_unsigned()),
        (-1_i64).cast_unsigned()
    );
    assert_eq!(convert(Time, Uint, 65_537_000_000), 1);
    assert_eq!(
        convert(Int, Time, (-5_i64).cast_unsigned()),
        (-5_000_000_i64).cast_unsigned()
    );
    assert_eq!(convert(Ulint, Time, u64::MAX), (-1_000_000_i64).cast_unsigned());
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
                "{bits} ns as {}",
                ty.name()
            );
            let negative = convert(Time, ty, bits.wrapping_neg());
            assert_eq!(decode(negative, ty), -decode(convert(Time, ty, bits), ty));
        }
    }
    assert_eq!(convert(Time, Lreal, 0), 0);
    assert_eq!(convert(Time, Real, 1_500_000), u64::from(1.5_f32.to_bits()));
}

#[test]
fn a_real_becomes_the_duration_that_the_same_long_real_becomes() {
    for bits in SplitMix64::new(5).numbers().take(20_000).map(|bits| bits >> 32) {
        let long = convert(Real, Lreal, bits);
        for to in [Time, Tod, Dt] {
            assert_eq!(
                convert(Real, to, bits),
                convert(Lreal, to, long),
                "{bits:#x} to {}",
                to.name()
            );
        }
    }
}

#[test]
fn reals_become_durations_rounded_to_the_nanosecond() {
    let to_time = |milliseconds: f64| convert(Lreal, Time, milliseconds.to_bits()).cast_signed();
    assert_eq!(to_time(1.5), 1_500_000);
    assert_eq!(to_time(0.1), 100_000);
    // Exactly 2.5 and 3.5 nanoseconds cannot be written in ms; these are multiples of 2^-6 ms.
    assert_eq!(to_time(1.0 / 64.0), 15_625);
    assert_eq!(to_time(1.0 / 128.0), 7_812);
    assert_eq!(to_time(3.0 / 128.0), 23_438);
    assert_eq!(to_time(-1.0 / 128.0), -7_812);
    assert_eq!(to_time(1e-300), 0);
    // 2^64 ms are 2^64 * 10^6 ns, of which nothing is left.
    assert_eq!(to_time(18_446_744_073_709_551_616.0), 0);
    assert_eq!(
        to_time(9_223_372_036_855.0),
        (9_223_372_036_855_000_000_i128 - (1 << 64)) as i64
    );
}

#[test]
fn binary_coded_decimals_read_back() {
    let from_bcd = |from, to, raw| {
        Conversion {
            from,
            to,
            rule: ConversionRule::FromBcd,
        }
        .apply(raw)
    };
    let to_bcd = |from, to, raw| {
        Conversion {
            from,
            to,
            rule: ConversionRule::ToBcd,
        }
        .apply(raw)
    };
    for number in 0..10_000 {
        let bits =
            u64::from_str_radix(&number.to_string(), 16).expect("decimal digits are hexadecimal digits");
        assert_eq!(to_bcd(Int, Word, number), bits);
        assert_eq!(from_bcd(Word, Int, bits), number);
    }
    assert_eq!(from_bcd(Byte, Int, 0x1A), 20);
    assert_eq!(
        from_bcd(Lword, Ulint, 0x9999_9999_9999_9999),
        9_999_999_999_999_999
    );
    assert_eq!(to_bcd(Int, Byte, 123), 0x23);
    assert_eq!(to_bcd(Int, Word, (-1_i64).cast_unsigned()), 0x9999);
    assert_eq!(to_bcd(Udint, Lword, 4_294_967_295), 0x42_9496_7295);
}
