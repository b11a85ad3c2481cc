//! Binary-coded decimal: four bits a digit, the lowest digit in the lowest bits.
//!
//! Basis: forgeiec-conversion-functions: BCD encoding. No source says what a digit above 9 means, nor what becomes of a number
//! with too many digits.

use crate::integer;
use stickler_types::ElementaryType;

/// Returns the digits of a bit string, the highest first.
fn digits(raw: u64, ty: ElementaryType) -> impl Iterator<Item = u64> {
    let count = ty.bits() / 4;
    (0..count).rev().map(move |place| raw >> (4 * place) & 0xF)
}

/// Returns the number that the digits spell; a digit above 9 counts with its value: `16#1A` is 20.
pub(crate) fn number(raw: u64, from: ElementaryType) -> i128 {
    digits(raw, from).fold(0, |number, digit| number * 10 + i128::from(digit))
}

/// Returns whether every digit is at most 9.
pub(crate) fn is_decimal(raw: u64, ty: ElementaryType) -> bool {
    digits(raw, ty).all(|digit| digit <= 9)
}

/// Returns the greatest number that a bit string has digits for.
pub(crate) const fn greatest(ty: ElementaryType) -> i128 {
    10_i128.pow(ty.bits() / 4) - 1
}

/// Returns a number in binary-coded decimal, modulo 10^n for the n digits of the bit string, so that -1 becomes `16#99`.
pub(crate) fn encoded(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    let mut rest = integer::number(raw, from).rem_euclid(greatest(to) + 1);
    let mut bits = 0;
    for place in 0..to.bits() / 4 {
        // A remainder of division by ten, and so a digit.
        bits |= ((rest % 10) as u64) << (4 * place);
        rest /= 10;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::*;

    #[test]
    fn digits_are_those_that_a_person_writes() {
        for written in 0..10_000_i128 {
            let raw = u64::from_str_radix(&written.to_string(), 16).unwrap();
            assert_eq!(number(raw, Word), written);
            assert_eq!(encoded(written as u64, Uint, Word), raw);
            assert!(is_decimal(raw, Word));
        }
        assert_eq!(number(0x9999_9999_9999_9999, Lword), greatest(Lword));
        assert_eq!(encoded(u64::MAX, Ulint, Lword), 0x6744_0737_0955_1615);
    }
}
