//! Binary-coded decimal: four bits a digit, the lowest digit in the lowest bits.

use stickler_types::ElementaryType;

/// The number that the digits spell. A digit above 9 counts with its value, so `16#1A` is 20; no source says
/// what it means.
#[must_use]
pub fn decode(raw: u64) -> u64 {
    // Sixteen digits of 15 stay below 2^64.
    (0..16)
        .rev()
        .fold(0, |number, digit| number * 10 + ((raw >> (4 * digit)) & 0xF))
}

/// The digits of a number, as many as `to` holds: the number modulo 10^n, so that what does not fit loses its
/// leading digits, and -1 becomes 99, as two's complement has it in its own base. No source says what happens.
#[must_use]
pub fn encode(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    let digits = to.bits() / 4;
    let rest = from.integer_value(raw).rem_euclid(10_i128.pow(digits));
    let mut rest = rest.unsigned_abs() as u64;
    let mut bits = 0;
    for digit in 0..digits {
        bits |= (rest % 10) << (4 * digit);
        rest /= 10;
    }
    bits
}
