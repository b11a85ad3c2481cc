//! Conversions of numbers to durations, dates and times of day.
//!
//! The unit is a choice.
//! Basis: forgeiec-conversion-functions: The naming pattern (`DINT_TO_TIME` "interprets as ms"); all but TIME is
//! open, and is as the documentation of the reference has it.

use super::each;
use super::real::Parts;
use stickler_types::{ElementaryType, Family, MomentUnits, Rounding};

/// The nanoseconds of a day.
const DAY: i64 = 86_400_000_000_000;

/// Returns the nanoseconds of the unit in which numbers count values of a type.
const fn unit(ty: ElementaryType, units: MomentUnits) -> u64 {
    match (ty.family(), units) {
        (_, MomentUnits::Counts) if ty.is_third_edition() => 1,
        (Family::Date, MomentUnits::DaysAndMilliseconds | MomentUnits::DaysSince1990) => DAY.unsigned_abs(),
        (
            Family::Date | Family::DateAndTime,
            MomentUnits::Seconds | MomentUnits::ShortTime | MomentUnits::Counts,
        ) => 1_000_000_000,
        _ => 1_000_000,
    }
}

/// Returns whether REAL numbers of units have a fast form: the nanoseconds of a REAL number of days need more than 64 bits, and a
/// count is rounded like an integer.
pub const fn has_real_units(to: ElementaryType, units: MomentUnits) -> bool {
    !matches!(units, MomentUnits::Counts) && unit(to, units) < DAY.unsigned_abs()
}

/// Converts numbers of whole units, modulo 2^64 nanoseconds.
pub fn units(operands: &[u64], results: &mut [u64], to: ElementaryType, units: MomentUnits) {
    let unit = unit(to, units);
    match to.family() {
        _ if units == MomentUnits::Counts && !to.is_third_edition() => each(operands, results, |operand| {
            held((operand & 0xFFFF_FFFF).wrapping_mul(unit), to)
        }),
        Family::TimeOfDay if units == MomentUnits::Counts => {
            each(operands, results, |operand| operand % DAY.unsigned_abs());
        }
        // A product modulo 2^64 is the same whether its factors are signed or not.
        Family::Duration | Family::DateAndTime => {
            each(operands, results, |operand| operand.wrapping_mul(unit));
        }
        _ => each(operands, results, |operand| held(operand.wrapping_mul(unit), to)),
    }
}

/// Converts REAL numbers of units, rounded to the nearest nanosecond, ties to even; NaN and the infinities give 0.
pub fn real_units(operands: &[u64], results: &mut [u64], to: ElementaryType, units: MomentUnits) {
    let unit = unit(to, units);
    each(operands, results, |operand| {
        let parts = Parts::of(operand);
        if parts.finite {
            held(parts.signed(parts.magnitude(unit, Rounding::HalfToEven)), to)
        } else {
            0
        }
    });
}

/// Returns nanoseconds as the type holds them: only the day for a date, only the time since midnight for a time of day.
#[inline(always)]
fn held(nanoseconds: u64, to: ElementaryType) -> u64 {
    let number = nanoseconds.cast_signed();
    let kept = match to.family() {
        Family::Date => {
            let behind_midnight = number.rem_euclid(DAY);
            // The first day that 64 bits reach begins before them; the next one stands for it.
            number
                .checked_sub(behind_midnight)
                .unwrap_or_else(|| number + (DAY - behind_midnight))
        }
        Family::TimeOfDay => number.rem_euclid(DAY),
        _ => number,
    };
    kept.cast_unsigned()
}
