//! Binary-coded decimal: four bits a digit, the lowest digit in the lowest bits.

use stickler_types::ElementaryType;

/// The number that the digits spell. A digit above 9 counts with its value, so `16#1A` is 20; no source says
/// what it means.
///
/// Neighbours are joined two by two: digits to bytes below 166, bytes to 16 bits, and so on; sixteen digits of
/// 15 stay below 2^64.
#[inline]
#[must_use]
pub const fn decode(raw: u64) -> u64 {
    const DIGITS: u64 = 0x0F0F_0F0F_0F0F_0F0F;
    const PAIRS: u64 = 0x00FF_00FF_00FF_00FF;
    const FOURS: u64 = 0x0000_FFFF_0000_FFFF;
    let pairs = (raw & DIGITS) + 10 * ((raw >> 4) & DIGITS);
    let fours = (pairs & PAIRS) + 100 * ((pairs >> 8) & PAIRS);
    let eights = (fours & FOURS) + 10_000 * ((fours >> 16) & FOURS);
    (eights & 0xFFFF_FFFF) + 100_000_000 * (eights >> 32)
}

/// The digits of a number, as many as `to` holds: the number modulo 10^n, so that what does not fit loses its
/// leading digits, and -1 becomes 99, as two's complement has it in its own base. No source says what happens.
#[inline]
#[must_use]
pub const fn encode(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    // Spelled out so that every division is by a constant.
    let number = match to {
        ElementaryType::Byte => modulo::<100>(raw, from),
        ElementaryType::Word => modulo::<10_000>(raw, from),
        ElementaryType::Dword => modulo::<100_000_000>(raw, from),
        _ => modulo::<10_000_000_000_000_000>(raw, from),
    };
    let (high, low) = (number / 100_000_000, number % 100_000_000);
    eight_digits(low) | eight_digits(high) << 32
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

/// The digits of a number below 10^8. Each step divides all parts of the word at once, by multiplication with
/// a reciprocal that is exact for parts of that size.
#[inline]
const fn eight_digits(number: u64) -> u64 {
    // Two parts below 10 000, of 32 bits each.
    let fours = (number % 10_000) | ((number / 10_000) << 32);
    // Four parts below 100, of 16 bits each.
    let hundreds = ((fours * 5_243) >> 19) & 0x0000_007F_0000_007F;
    let pairs = (fours - 100 * hundreds) | hundreds << 16;
    // Six more for each ten carries from one digit into the next.
    let tens = ((pairs * 103) >> 10) & 0x000F_000F_000F_000F;
    let bytes = pairs + 6 * tens;
    // The parts of 16 bits hold 8 each; they move together.
    let joined = (bytes | bytes >> 8) & 0x0000_FFFF_0000_FFFF;
    (joined | joined >> 16) & 0xFFFF_FFFF
}

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
            assert_eq!(decode(eight_digits(number)), number);
        }
    }

    #[test]
    fn a_number_loses_the_digits_that_do_not_fit() {
        use ElementaryType::{Byte, Dint, Dword, Lint, Lword, Ulint, Word};
        assert_eq!(
            [Byte, Word, Dword].map(|to| encode(123_456_789, Dint, to)),
            [0x89, 0x6789, 0x2345_6789]
        );
        assert_eq!(encode(u64::MAX, Ulint, Lword), 0x6744_0737_0955_1615);
        assert_eq!(
            encode((-1_i64).cast_unsigned(), Lint, Lword),
            0x9999_9999_9999_9999
        );
        assert_eq!(encode(i64::MIN.cast_unsigned(), Lint, Byte), 0x92);
    }

    #[test]
    fn a_digit_above_nine_counts_with_its_value() {
        assert_eq!(decode(0xFFFF_FFFF_FFFF_FFFF), 16_666_666_666_666_665);
        assert_eq!(decode(0x1A), 20);
    }
}
