//! Binary-coded decimal: four bits a digit, the lowest digit in the lowest bits.

use crate::raw;
use stickler_types::ElementaryType;

/// The number that the digits spell, modulo 2^n of the target.
#[inline]
pub const fn number(digits: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    let number = decode(digits, from);
    // Eight digits spell at most 166 666 665, which every type of 32 bits holds as it is.
    if from.bits() <= 32 && to.bits() >= 32 {
        number
    } else {
        raw::narrow(number, to)
    }
}

/// The number that the digits spell. A digit above 9 counts with its value, so `16#1A` is 20; no source says
/// what it means.
///
/// A sixteenth of the raw form at a time would do; here neighbours are joined two by two, all at once.
#[inline]
const fn decode(raw: u64, from: ElementaryType) -> u64 {
    if from.bits() <= 32 {
        eight_joined(raw)
    } else {
        eight_joined(raw & 0xFFFF_FFFF) + 100_000_000 * eight_joined(raw >> 32)
    }
}

/// The number that eight digits spell: digits to bytes of at most 165, those to 16 bits, and so on.
#[inline]
const fn eight_joined(raw: u64) -> u64 {
    let pairs = (raw & 0x0F0F_0F0F) + 10 * ((raw >> 4) & 0x0F0F_0F0F);
    let fours = (pairs & 0x00FF_00FF) + 100 * ((pairs >> 8) & 0x00FF_00FF);
    (fours & 0xFFFF) + 10_000 * (fours >> 16)
}

/// The digits of a number, as many as `to` holds: the number modulo 10^n, so that what does not fit loses its
/// leading digits, and -1 becomes 99, as two's complement has it in its own base. No source says what happens.
#[inline]
pub fn encode(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    // Spelled out so that every division is by a constant.
    match to {
        ElementaryType::Byte => four_digits(modulo::<100>(raw, from)),
        ElementaryType::Word => four_digits(modulo::<10_000>(raw, from)),
        ElementaryType::Dword => eight_digits(modulo::<100_000_000>(raw, from)),
        _ => {
            let number = modulo::<10_000_000_000_000_000>(raw, from);
            eight_digits(number % 100_000_000) | eight_digits(number / 100_000_000) << 32
        }
    }
}

#[inline]
const fn modulo<const MODULUS: u64>(raw: u64, from: ElementaryType) -> u64 {
    if from.is_signed() {
        raw.cast_signed()
            .rem_euclid(MODULUS.cast_signed())
            .cast_unsigned()
    } else {
        raw % MODULUS
    }
}

/// The digits of a number below 10^8.
#[inline]
fn eight_digits(number: u64) -> u64 {
    // In 32 bits, where a division is quicker.
    let number = number as u32;
    four_digits((number % 10_000).into()) | four_digits((number / 10_000).into()) << 16
}

/// The digits of a number below 10^4.
#[inline]
fn four_digits(number: u64) -> u64 {
    DIGITS.get(number as usize).copied().unwrap_or(0).into()
}

/// The digits of each number below 10^4.
static DIGITS: [u16; 10_000] = {
    let mut table = [0; 10_000];
    let mut number = 0_u16;
    while number < 10_000 {
        let (thousands, hundreds) = (number / 1_000, number / 100 % 10);
        let (tens, ones) = (number / 10 % 10, number % 10);
        table[number as usize] = thousands << 12 | hundreds << 8 | tens << 4 | ones;
        number += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_digits_are_those_that_a_person_writes() {
        for number in (0..100_000_000)
            .step_by(997)
            .chain(99_990_000..100_000_000)
            .chain(0..10_001)
        {
            let written = u64::from_str_radix(&number.to_string(), 16);
            assert_eq!(written, Ok(eight_digits(number)), "{number}");
            assert_eq!(decode(eight_digits(number), ElementaryType::Dword), number);
        }
    }
}
