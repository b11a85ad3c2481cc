//! Integers, bit strings, BOOL and characters: whole numbers of at most 64 bits.

use stickler_types::{ElementaryType, Family};

/// Returns the number that a raw form represents; a bit string, a BOOL and a character count as unsigned, durations and
/// dates as their nanoseconds.
pub(crate) const fn number(raw: u64, ty: ElementaryType) -> i128 {
    ty.integer_value(raw)
}

/// Returns the raw form of a number modulo 2^n of its type.
///
/// Basis: rule: integer-overflow-wraps; forgeiec-conversion-functions: Range and precision ("wraps").
pub(crate) fn wrapped(number: i128, to: ElementaryType) -> u64 {
    let modulus = 1_i128 << to.bits();
    let rest = number.rem_euclid(modulus);
    // The upper half of the residues stands for the negative numbers.
    let signed = matches!(to.family(), Family::Signed);
    let value = if signed && rest >= modulus / 2 {
        rest - modulus
    } else {
        rest
    };
    raw(value)
}

/// Returns the 64-bit two's complement of a number that fits 64 bits with or without a sign.
const fn raw(value: i128) -> u64 {
    value as u64
}

/// Returns whether an integer, bit string or BOOL of this type holds the number; `false` for any other type.
pub(crate) fn holds(to: ElementaryType, number: i128) -> bool {
    to.integer_range()
        .is_some_and(|(least, greatest)| (least..=greatest).contains(&number))
}

/// Returns the raw form of the number, or of the nearest limit of the type; 0 for a type without limits.
pub(crate) fn saturated(number: i128, to: ElementaryType) -> u64 {
    to.integer_range()
        .map_or(0, |(least, greatest)| raw(number.clamp(least, greatest)))
}
