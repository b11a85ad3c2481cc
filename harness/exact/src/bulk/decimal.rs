//! Binary-coded decimal, by tables that are filled by counting digit by digit, like an odometer.

use super::each;
use super::integer::Narrow;
use std::sync::LazyLock;
use stickler_types::ElementaryType;

/// The number of values that four decimal digits can spell.
const FOUR_DIGITS: usize = 10_000;

/// The binary-coded decimal digits of each number below 10 000.
static DIGITS: LazyLock<Box<[u16; FOUR_DIGITS]>> = LazyLock::new(|| {
    let mut table = Box::new([0; FOUR_DIGITS]);
    let mut odometer = 0_u16;
    for digits in table.iter_mut() {
        *digits = odometer;
        odometer = turned(odometer);
    }
    table
});

/// Returns the odometer increased by one: a digit that is 9 becomes 0 and carries into the next.
fn turned(odometer: u16) -> u16 {
    let (mut next, mut wheel) = (odometer, 0);
    while wheel < 16 && (next >> wheel) & 0xF == 9 {
        next &= !(0xF << wheel);
        wheel += 4;
    }
    if wheel < 16 { next + (1 << wheel) } else { 0 }
}

/// Computes the number that the digits spell, modulo 2^n; a digit above 9 counts with its value.
///
/// Basis: forgeiec-conversion-functions: BCD encoding.
pub fn number(operands: &[u64], results: &mut [u64], to: ElementaryType) {
    let narrow = Narrow::to(to);
    let table = &**NUMBERS;
    let four = |digits: u64| u64::from(table.get(digits as usize & 0xFFFF).copied().unwrap_or(0));
    each(operands, results, |operand| {
        // Eight digits, the sources here having no more.
        narrow.of(four(operand) + four(operand >> 16) * FOUR_DIGITS as u64)
    });
}

/// The number that each combination of four binary-coded digits spells.
static NUMBERS: LazyLock<Box<[u32]>> = LazyLock::new(|| {
    (0..=u16::MAX)
        .map(|digits| {
            let digit = |place: u32| u32::from(digits >> (4 * place)) & 0xF;
            digit(3) * 1000 + digit(2) * 100 + digit(1) * 10 + digit(0)
        })
        .collect()
});

/// Computes the decimal digits of each number modulo 10^n, where n is the number of digits of the target; -1 gives 99.
pub fn digits(operands: &[u64], results: &mut [u64], from: ElementaryType, to: ElementaryType) {
    // The number of groups is a constant in each of these loops.
    match to.bits() {
        8 => grouped::<1>(operands, results, from, 0xFF),
        16 => grouped::<1>(operands, results, from, 0xFFFF),
        32 => grouped::<2>(operands, results, from, 0xFFFF_FFFF),
        _ => grouped::<4>(operands, results, from, u64::MAX),
    }
}

/// Computes the digits in `GROUPS` groups of four; `mask` keeps those that the target holds.
fn grouped<const GROUPS: u32>(operands: &[u64], results: &mut [u64], from: ElementaryType, mask: u64) {
    let table = &**DIGITS;
    if !from.is_signed() {
        // A source of 32 bits at most, whose divisions are quicker than those of 64.
        return each(operands, results, |operand| {
            let mut rest = operand as u32;
            let mut digits = 0;
            for group in 0..GROUPS {
                digits |= u64::from(table[(rest % FOUR_DIGITS as u32) as usize]) << (16 * group);
                rest /= FOUR_DIGITS as u32;
            }
            digits & mask
        });
    }
    // A multiple of all that is taken away at the front, above the least number of a 32-bit source, makes every
    // number positive and changes no digit that is kept.
    let lift = if GROUPS == 1 {
        10_u64.pow(10)
    } else {
        10_u64.pow(16)
    };
    each(operands, results, |operand| {
        let mut rest = operand.wrapping_add(lift);
        let mut digits = 0;
        for group in 0..GROUPS {
            // The remainder of a division by the length of the table is an index into it.
            digits |= u64::from(table[(rest % FOUR_DIGITS as u64) as usize]) << (16 * group);
            rest /= FOUR_DIGITS as u64;
        }
        digits & mask
    });
}
