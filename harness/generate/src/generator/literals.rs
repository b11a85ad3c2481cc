//! Generation of values for literals, biased towards boundaries.

use crate::random::Random;
use std::sync::LazyLock;
use stickler_types::{ElementaryType, Family, Value};

/// Returns the boundary values of a type; the default value first.
pub(super) fn boundaries(ty: ElementaryType) -> &'static [Value] {
    static TABLE: LazyLock<Vec<Vec<Value>>> =
        LazyLock::new(|| ElementaryType::ALL.into_iter().map(build).collect());
    &TABLE[ty as usize]
}

/// Generates a value of a type: a boundary value as often as a small one, sometimes any.
pub(super) fn value(ty: ElementaryType, random: &mut Random<'_, '_>) -> Value {
    match (random.weighted(&[3, 3, 2]), ty.integer_range().is_some()) {
        (0, true) => Value::plain(ty, ty.wrap(i128::from(small(ty, random)))),
        (2, true) => Value::plain(ty, ty.wrap(i128::from(random.bits()))),
        _ => random
            .pick(boundaries(ty))
            .cloned()
            .unwrap_or(Value::plain(ty, 0)),
    }
}

/// Generates a small number of an integer type, a bit string or BOOL, so that sums and products stay in range for a while.
fn small(ty: ElementaryType, random: &mut Random<'_, '_>) -> i64 {
    match ty.family() {
        Family::Boolean => random.between(0, 1),
        Family::Signed => match random.between(0, 15) {
            number @ 0..=11 => number,
            number => 11 - number,
        },
        _ => random.between(0, 15),
    }
}

fn build(ty: ElementaryType) -> Vec<Value> {
    const MILLISECOND: i64 = 1_000_000;
    const DAY: i64 = 86_400_000 * MILLISECOND;
    let of = |numbers: &[i64], unit: i64| -> Vec<Value> {
        let values = numbers
            .iter()
            .map(|number| Value::plain(ty, (number * unit).cast_unsigned()));
        values.collect()
    };
    // Leap days, the turn of a century, the day on which 32 bits of signed seconds end.
    const DAYS: [i64; 7] = [0, 1, 59, 10_956, 11_016, 19_782, 24_855];
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => integers(ty),
        Family::Real => reals(ty),
        // Whole milliseconds, which a conversion to a number keeps, within the 32 bits that some systems give a duration.
        Family::Duration => of(
            &[
                0, 1, 5, 100, 127, 128, 999, 1000, 1500, 60_000, 65_536, 3_600_000, 86_400_000, -1,
            ],
            MILLISECOND,
        ),
        Family::Date => of(&DAYS, DAY),
        Family::TimeOfDay => of(
            &[0, 1, 999, 1000, 43_200_000, 45_296_789, 86_399_000, 86_399_999],
            MILLISECOND,
        ),
        Family::DateAndTime => {
            let seconds =
                DAYS.map(|day| day * 86_400)
                    .into_iter()
                    .chain([86_399, 951_827_696, 1_709_210_096]);
            of(&seconds.collect::<Vec<_>>(), 1000 * MILLISECOND)
        }
        Family::Text => ["", "a", "abc", "it's", "$", "0", "-12", "a b", "\"", "xyz!"]
            .iter()
            .map(|text| Value::text(ty, text.encode_utf16().collect()))
            .collect(),
        Family::Character => "\u{20}aZ0~'\"$"
            .bytes()
            .map(|unit| Value::plain(ty, unit.into()))
            .collect(),
    }
}

/// Lists 0, 1, -1, the limits and their inner neighbours, and each power of two with its neighbours.
fn integers(ty: ElementaryType) -> Vec<Value> {
    let Some((least, greatest)) = ty.integer_range() else {
        return Vec::new();
    };
    let mut numbers = vec![0, 1, -1, greatest, least, greatest - 1, least + 1];
    for power in (0..ty.bits()).map(|bit| 1_i128 << bit) {
        numbers.extend([power, power - 1, power + 1, -power, -power - 1]);
    }
    let mut seen = Vec::new();
    for number in numbers {
        if (least..=greatest).contains(&number) && !seen.contains(&number) {
            seen.push(number);
        }
    }
    seen.into_iter()
        .map(|number| Value::plain(ty, ty.wrap(number)))
        .collect()
}

/// Lists numbers with and without fractions, halves, both zeros, the limits of the integers, the bound up to which REAL
/// holds every integer, and subnormal numbers. Huge numbers are omitted: a few products of them overflow.
fn reals(ty: ElementaryType) -> Vec<Value> {
    let numbers = include_str!("reals.txt")
        .lines()
        .filter_map(|line| line.parse().ok());
    let mut values: Vec<Value> = numbers.map(|number| Value::of_real(ty, number)).collect();
    values.extend(tiny(ty).iter().map(|&raw| Value::plain(ty, raw)));
    values
}

/// Lists the least and the greatest subnormal number, the least normal one, numbers whose products are subnormal, and for
/// LREAL the least number that REAL holds and one that must round to an even neighbour in one step.
///
/// Basis: iec-61131-3: Table 10 (IEC 60559).
pub(super) fn tiny(ty: ElementaryType) -> &'static [u64] {
    const POWER: i64 = 1 << 52;
    const SINGLE: [u64; 5] = [
        1,
        0x007F_FFFF,
        0x0080_0000,
        1.0e-20_f32.to_bits() as u64,
        (-1.0e-25_f32).to_bits() as u64,
    ];
    const DOUBLE: [u64; 7] = [
        1,
        0x000F_FFFF_FFFF_FFFF,
        0x0010_0000_0000_0000,
        1.0e-160_f64.to_bits(),
        (-1.0e-170_f64).to_bits(),
        // 2 to the power of -149 and of -150.
        (POWER * (1023 - 149)).cast_unsigned(),
        (POWER * (1023 - 150)).cast_unsigned(),
    ];
    match ty {
        ElementaryType::Real => &SINGLE,
        _ => &DOUBLE,
    }
}
