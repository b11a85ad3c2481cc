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
    // Fits 64 bits with or without a sign.
    of_bits(number, to.bits(), to) as u64
}

/// Returns the number that the lowest bits of another number are in a type, as if it had no more bits than these.
pub(crate) fn of_bits(number: i128, bits: u32, to: ElementaryType) -> i128 {
    let modulus = 1_i128 << bits;
    let rest = number.rem_euclid(modulus);
    // The upper half of the residues stands for the negative numbers.
    let is_negative = to.family() == Family::Signed && rest >= modulus / 2;
    rest - if is_negative { modulus } else { 0 }
}

/// Returns the raw form of the number, or of the nearest limit of the type; 0 for a type without limits.
pub(crate) fn saturated(number: i128, to: ElementaryType) -> u64 {
    to.integer_range()
        .map_or(0, |(least, greatest)| number.clamp(least, greatest) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::*;

    #[test]
    fn a_number_wraps_as_if_2_to_the_n_were_taken_off_or_added_until_it_fits() {
        for ty in [Bool, Sint, Usint, Byte, Int, Uint, Word] {
            let (least, greatest) = ty.integer_range().unwrap();
            for start in -(3_i128 << ty.bits())..3 << ty.bits() {
                let mut value = start;
                while value < least {
                    value += 1 << ty.bits();
                }
                while value > greatest {
                    value -= 1 << ty.bits();
                }
                assert_eq!(number(wrapped(start, ty), ty), value, "{start} as {ty}");
            }
        }
    }

    #[test]
    fn the_widest_types_wrap_at_64_bits() {
        assert_eq!(wrapped(1 << 63, Lint), i64::MIN.cast_unsigned());
        assert_eq!(wrapped(-1, Ulint), u64::MAX);
        assert_eq!(wrapped((1 << 64) + 5, Lword), 5);
        assert_eq!(wrapped(-(1 << 63) - 1, Lint), i64::MAX.cast_unsigned());
    }

    #[test]
    fn a_number_saturates_at_the_limits_of_its_type() {
        let signed = |number| saturated(number, Sint).cast_signed();
        assert_eq!([-129, -128, 127, 128].map(signed), [-128, -128, 127, 127]);
        assert_eq!(
            [-1, 0, 65_535, 65_536].map(|n| saturated(n, Word)),
            [0, 0, 65_535, 65_535]
        );
        assert_eq!(saturated(1 << 100, Ulint), u64::MAX);
        assert!(Ulint.holds((1 << 64) - 1) && !Ulint.holds(1 << 64) && !Real.holds(0));
    }
}
