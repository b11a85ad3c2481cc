//! Conversions of durations, dates and times of day: to numbers, from numbers, and among each other.
//!
//! In what numbers count them is a choice.
//!
//! Basis: forgeiec-conversion-functions: The naming pattern (`TIME_TO_DINT` "returns ms", `DINT_TO_TIME` "interprets as ms");
//! strucpp-tests: tests/st-validation/data_types/test_time_types.st (TIME, TOD and DT in ms, DATE in days); codesys-recording:
//! fixtures/conversions/explicit-pairs.ts; elsewhere no source says what the others count.

use crate::real::{self, Real};
use crate::{integer, quotient};
use num_bigint::BigUint;
use stickler_types::{ElementaryType, Family, MomentUnits, Rounding};

/// The nanoseconds of a day.
const DAY: i128 = 86_400_000_000_000;

/// Returns the nanoseconds of the unit in which numbers count values of a type.
const fn unit(ty: ElementaryType, units: MomentUnits) -> u64 {
    use ElementaryType::{Date, Dt, Ldate, Ldt, Ltime, Ltod};
    match (units, ty) {
        (MomentUnits::Counts, Ltime | Ltod | Ldate | Ldt) => 1,
        (MomentUnits::DaysAndMilliseconds | MomentUnits::DaysSince1990, Date | Ldate) => 86_400_000_000_000,
        (MomentUnits::Seconds | MomentUnits::ShortTime, Date | Ldate | Dt | Ldt)
        | (MomentUnits::Counts, Date | Dt) => 1_000_000_000,
        _ => 1_000_000,
    }
}

/// Returns the nanoseconds since 1970-01-01 of the moment that the number 0 stands for.
///
/// Basis: siemens-manual-2011: 89 ("the number of days added to the base date 01/01/1990").
fn zero(ty: ElementaryType, units: MomentUnits) -> i128 {
    let is_date = matches!(ty, ElementaryType::Date | ElementaryType::Ldate);
    match units {
        MomentUnits::DaysSince1990 if is_date => 631_152_000 * 1_000_000_000,
        _ => 0,
    }
}

/// Returns the number modulo 2^n as the integer that a type is, where each type counts its own units.
fn count(number: i128, ty: ElementaryType) -> i128 {
    let counter = counter(ty);
    integer::of_bits(number, counter.bits(), counter)
}

/// Returns the nanoseconds that a raw form represents.
pub(crate) const fn nanoseconds(raw: u64) -> i128 {
    raw.cast_signed() as i128
}

/// Returns the number of whole units, without the fraction.
pub(crate) fn units(raw: u64, from: ElementaryType, units: MomentUnits) -> i128 {
    let whole = (nanoseconds(raw) - zero(from, units)) / i128::from(unit(from, units));
    match units {
        MomentUnits::Counts => count(whole, from),
        _ => whole,
    }
}

/// Returns whether the raw form is a whole number of units.
pub(crate) fn has_whole_units(raw: u64, from: ElementaryType, units: MomentUnits) -> bool {
    nanoseconds(raw) % i128::from(unit(from, units)) == 0
}

/// Returns the number of units, including the fraction, as REAL or LREAL.
pub(crate) fn real_units(raw: u64, from: ElementaryType, to: ElementaryType, units: MomentUnits) -> u64 {
    if units == MomentUnits::Counts {
        return real::from_integer(self::units(raw, from, units), to);
    }
    let nanoseconds = nanoseconds(raw) - zero(from, units);
    let magnitude = BigUint::from(nanoseconds.unsigned_abs());
    quotient::nearest(nanoseconds < 0, &magnitude, &unit(from, units).into(), to)
}

/// Returns the nanoseconds of a number of units.
pub(crate) fn of_units(number: i128, to: ElementaryType, units: MomentUnits) -> i128 {
    // Less than 2^64 units of less than 2^47 nanoseconds.
    number * i128::from(unit(to, units)) + zero(to, units)
}

/// Returns the raw form of a whole number of units, modulo 2^64 nanoseconds.
pub(crate) fn from_units(number: i128, to: ElementaryType, units: MomentUnits) -> u64 {
    match units {
        // A time of day without a sign is one before it has the width of a moment.
        MomentUnits::Counts if to.family() == Family::TimeOfDay => {
            let time = of_units(count(number, to), to, units).rem_euclid(DAY);
            wrapped(time).cast_unsigned()
        }
        MomentUnits::ShortTime if to == ElementaryType::Time => {
            let milliseconds = integer::of_bits(number, 32, ElementaryType::Dint);
            wrapped(of_units(milliseconds, to, units)).cast_unsigned()
        }
        MomentUnits::Counts => stored(wrapped(of_units(count(number, to), to, units)), to),
        _ => stored(wrapped(of_units(number, to, units)), to),
    }
}

/// Returns the integer type that a type is, where each counts its own units.
pub(crate) const fn counter(ty: ElementaryType) -> ElementaryType {
    use ElementaryType::{Date, Dt, Ltime, Ltod, Time, Tod};
    match ty {
        Time | Tod | Date | Dt => ElementaryType::Udint,
        Ltime | Ltod => ElementaryType::Ulint,
        _ => ElementaryType::Lint,
    }
}

/// Returns the raw form of a real number of units, rounded to the nearest nanosecond, ties to even, modulo 2^64; NaN and
/// the infinities give 0.
pub(crate) fn from_real_units(raw: u64, from: ElementaryType, to: ElementaryType, units: MomentUnits) -> u64 {
    let Real::Finite(number) = real::decode(raw, from) else {
        return stored(wrapped(zero(to, units)), to);
    };
    let exponent = number.exponent;
    let nanoseconds = BigUint::from(number.significand) * unit(to, units);
    let magnitude = if exponent < 0 {
        let divisor = BigUint::from(1_u32) << exponent.unsigned_abs();
        quotient::half_to_even(&nanoseconds, &divisor)
    } else {
        nanoseconds << exponent.unsigned_abs()
    };
    let low = magnitude.iter_u64_digits().next().unwrap_or(0);
    let bits = if number.negative { low.wrapping_neg() } else { low };
    stored(wrapped(i128::from(bits.cast_signed()) + zero(to, units)), to)
}

/// Returns whether a real number is a whole number of units that a value of this type holds.
pub(crate) fn is_whole_moment(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    units: MomentUnits,
) -> bool {
    let Real::Finite(finite) = real::decode(raw, from) else {
        return false;
    };
    // A whole number has no bits below the point, and no duration has 64 of them above it.
    let zeros = finite.significand.trailing_zeros();
    let whole = finite.exponent >= 0 || zeros >= finite.exponent.unsigned_abs() || finite.significand == 0;
    match real::to_whole(finite, Rounding::Truncate) {
        real::Whole::Number(number) if whole && number.unsigned_abs() < 1 << 64 => {
            fits(of_units(number, to, units))
        }
        _ => false,
    }
}

/// Returns whether the nanoseconds fit 64 bits.
pub(crate) fn fits(nanoseconds: i128) -> bool {
    i64::try_from(nanoseconds).is_ok()
}

/// Returns nanoseconds modulo 2^64.
fn wrapped(nanoseconds: i128) -> i64 {
    nanoseconds as i64
}

/// Returns the raw form of nanoseconds in a type: a whole day for a date, less than one day for a time of day.
fn stored(nanoseconds: i64, to: ElementaryType) -> u64 {
    match to.family() {
        Family::Date => day(nanoseconds),
        // The time that has passed since midnight, also before 1970.
        Family::TimeOfDay => nanoseconds.rem_euclid(DAY as i64).cast_unsigned(),
        _ => nanoseconds.cast_unsigned(),
    }
}

/// Returns the beginning of the day on which a moment lies, also before 1970.
///
/// The beginning of the first day that 64 bits reach does not fit them: moments on it give the next day.
fn day(moment: i64) -> u64 {
    let beginning = i128::from(moment).div_euclid(DAY) * DAY;
    let held = if fits(beginning) {
        beginning
    } else {
        beginning + DAY
    };
    wrapped(held).cast_unsigned()
}

/// Returns whether 64 bits hold the beginning of the day on which a moment lies.
pub(crate) fn has_day(raw: u64) -> bool {
    fits(nanoseconds(raw).div_euclid(DAY) * DAY)
}

/// Returns whether every system can be expected to hold a moment: whole milliseconds from 1970 on, before 32 bits of seconds
/// overflow in 2038.
pub(crate) fn is_in_every_range(raw: u64) -> bool {
    const MILLISECOND: i128 = 1_000_000;
    let nanoseconds = nanoseconds(raw);
    (0..(1 << 31) * 1_000 * MILLISECOND).contains(&nanoseconds) && nanoseconds % MILLISECOND == 0
}

/// Converts a duration, date or time of day to another such type: DATE to DT gives midnight, DT to DATE the day, and DT to
/// TOD the time since midnight; a duration to TOD is taken modulo 24 hours.
pub(crate) fn between(raw: u64, to: ElementaryType) -> u64 {
    stored(raw.cast_signed(), to)
}

/// Converts a duration, date or time of day to another such type, where each counts its own units: the time since midnight, or the
/// whole units since 1970-01-01 or of the duration, modulo 2^n. LTIME gets the number of a TOD, although that counts milliseconds.
pub(crate) fn between_counts(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    let number = units(raw, from, MomentUnits::Counts);
    if from == ElementaryType::Tod && to == ElementaryType::Ltime {
        return from_units(number, to, MomentUnits::Counts);
    }
    let nanoseconds = of_units(number, from, MomentUnits::Counts);
    let kept = match to.family() {
        Family::TimeOfDay => nanoseconds.rem_euclid(DAY),
        _ => nanoseconds,
    };
    let unit = i128::from(unit(to, MomentUnits::Counts));
    from_units(kept.div_euclid(unit), to, MomentUnits::Counts)
}

/// Returns the moment of a date and a time of day, modulo 2^64 nanoseconds.
pub(crate) fn concatenated(date: u64, time: u64) -> u64 {
    wrapped(nanoseconds(date) + nanoseconds(time)).cast_unsigned()
}
