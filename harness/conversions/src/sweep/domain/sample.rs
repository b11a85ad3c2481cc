//! Turns random bits into values of a type, so that no magnitude is rare.

use stickler_types::{ElementaryType, Family, SplitMix64};

const MILLISECOND: i64 = 1_000_000;
const SECOND: i64 = 1_000 * MILLISECOND;
const DAY: i64 = 86_400 * SECOND;

/// Returns the raw form of the sampled value of a type at a place; the same source of random numbers gives the same value.
pub fn sampled(ty: ElementaryType, random: SplitMix64, place: u64) -> u64 {
    raw(ty, random.at(2 * place), random.at(2 * place + 1))
}

/// Returns the raw form of a value made from two random numbers, the first of which decides its kind and the other its digits;
/// 0 for a text. Random bits alone would seldom give a small integer or a real number near the integers.
fn raw(ty: ElementaryType, kind: u64, digits: u64) -> u64 {
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Character => {
            ty.wrap(any_length(kind, digits).into())
        }
        Family::Real => real(ty, kind, digits),
        Family::Duration | Family::DateAndTime => moment(kind, digits).cast_unsigned(),
        Family::Date => (moment(kind, digits) / DAY * DAY).cast_unsigned(),
        Family::TimeOfDay => moment(kind, digits).rem_euclid(DAY).cast_unsigned(),
        Family::Text => 0,
    }
}

/// Returns a random number of either sign and of any magnitude, each number of bits being equally likely.
fn any_length(kind: u64, digits: u64) -> i64 {
    let magnitude = (digits >> (kind % 64)).cast_signed();
    if kind & 64 == 0 {
        magnitude
    } else {
        magnitude.wrapping_neg()
    }
}

/// Returns the raw form of a random real number: a fourth of them are any bits at all, a fourth halves of integers, the rest
/// numbers that round to an integer of up to 70 bits.
fn real(ty: ElementaryType, kind: u64, digits: u64) -> u64 {
    let (fraction_bits, bias, sign) = match ty {
        ElementaryType::Real => (23, 127, 31),
        _ => (52, 1023, 63),
    };
    let all = if sign == 63 { u64::MAX } else { u32::MAX.into() };
    let choice = kind >> 8;
    let exponent = bias - 4 + choice % 74;
    let fraction = digits & ((1 << fraction_bits) - 1);
    match kind & 3 {
        0 => digits & all,
        1 => {
            // So many low bits of the fraction are cleared that the last one left stands for a half.
            let below_half = (fraction_bits + bias)
                .saturating_sub(exponent + 1)
                .min(fraction_bits);
            let cleared = fraction >> below_half << below_half;
            (kind >> 2 & 1) << sign | exponent << fraction_bits | cleared
        }
        _ => (kind >> 2 & 1) << sign | exponent << fraction_bits | fraction,
    }
}

/// Returns a random number of nanoseconds, whole milliseconds or whole seconds, of any magnitude.
fn moment(kind: u64, digits: u64) -> i64 {
    let any = any_length(kind >> 2, digits);
    match kind & 3 {
        0 => any,
        1 => any / SECOND * SECOND,
        _ => any / MILLISECOND * MILLISECOND,
    }
}
