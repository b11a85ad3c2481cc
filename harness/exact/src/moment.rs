//! Conversions of durations, dates and times of day: to numbers, from numbers, and among each other.
//!
//! Numbers count a duration and a time of day in milliseconds; in what they count a date and a date and time since 1970-01-01
//! is a choice.
//!
//! Basis: forgeiec-conversion-functions: The naming pattern (`TIME_TO_DINT` "returns ms", `DINT_TO_TIME` "interprets as ms");
//! strucpp-tests: tests/st-validation/data_types/test_time_types.st (TIME, TOD and DT in ms, DATE in days); elsewhere no source
//! says what the others count.

use crate::quotient;
use crate::real::{self, Real};
use num_bigint::BigUint;
use stickler_types::{CalendarUnits, ElementaryType, Family, Rounding};

/// The nanoseconds of a day.
const DAY: i128 = 86_400_000_000_000;

/// Returns the nanoseconds of the unit in which numbers count values of a type.
const fn unit(ty: ElementaryType, calendar: CalendarUnits) -> u64 {
    match ty.family() {
        Family::Date => match calendar {
            CalendarUnits::Seconds => 1_000_000_000,
            CalendarUnits::DaysAndMilliseconds => 86_400_000_000_000,
        },
        Family::DateAndTime => match calendar {
            CalendarUnits::Seconds => 1_000_000_000,
            CalendarUnits::DaysAndMilliseconds => 1_000_000,
        },
        _ => 1_000_000,
    }
}

/// Returns the nanoseconds that a raw form represents.
pub(crate) const fn nanoseconds(raw: u64) -> i128 {
    raw.cast_signed() as i128
}

/// Returns the number of whole units, without the fraction.
pub(crate) fn units(raw: u64, from: ElementaryType, calendar: CalendarUnits) -> i128 {
    nanoseconds(raw) / i128::from(unit(from, calendar))
}

/// Returns whether the raw form is a whole number of units.
pub(crate) fn has_whole_units(raw: u64, from: ElementaryType, calendar: CalendarUnits) -> bool {
    nanoseconds(raw) % i128::from(unit(from, calendar)) == 0
}

/// Returns the number of units, including the fraction, as REAL or LREAL.
pub(crate) fn real_units(raw: u64, from: ElementaryType, to: ElementaryType, calendar: CalendarUnits) -> u64 {
    let nanoseconds = nanoseconds(raw);
    let magnitude = BigUint::from(nanoseconds.unsigned_abs());
    quotient::nearest(nanoseconds < 0, &magnitude, &unit(from, calendar).into(), to)
}

/// Returns the nanoseconds of a number of units.
pub(crate) fn of_units(number: i128, to: ElementaryType, calendar: CalendarUnits) -> i128 {
    // Less than 2^64 units of less than 2^47 nanoseconds.
    number * i128::from(unit(to, calendar))
}

/// Returns the raw form of a whole number of units, modulo 2^64 nanoseconds.
pub(crate) fn from_units(number: i128, to: ElementaryType, calendar: CalendarUnits) -> u64 {
    stored(wrapped(of_units(number, to, calendar)), to)
}

/// Returns the raw form of a real number of units, rounded to the nearest nanosecond, ties to even, modulo 2^64; NaN and
/// the infinities give 0.
pub(crate) fn from_real_units(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    calendar: CalendarUnits,
) -> u64 {
    let Real::Finite {
        negative,
        significand,
        exponent,
    } = real::decode(raw, from)
    else {
        return stored(0, to);
    };
    let nanoseconds = BigUint::from(significand) * unit(to, calendar);
    let magnitude = if exponent < 0 {
        let divisor = BigUint::from(1_u32) << exponent.unsigned_abs();
        quotient::half_to_even(&nanoseconds, &divisor)
    } else {
        nanoseconds << exponent.unsigned_abs()
    };
    let low = magnitude.iter_u64_digits().next().unwrap_or(0);
    let bits = if negative { low.wrapping_neg() } else { low };
    stored(bits.cast_signed(), to)
}

/// Returns whether a real number is a whole number of units that a value of this type holds.
pub(crate) fn is_whole_moment(
    raw: u64,
    from: ElementaryType,
    to: ElementaryType,
    calendar: CalendarUnits,
) -> bool {
    let Real::Finite {
        negative,
        significand,
        exponent,
    } = real::decode(raw, from)
    else {
        return false;
    };
    // A whole number has no bits below the point, and no duration has 64 of them above it.
    let whole = exponent >= 0 || significand.trailing_zeros() >= exponent.unsigned_abs() || significand == 0;
    match real::to_whole(negative, significand, exponent, Rounding::Truncate) {
        real::Whole::Number(number) if whole && number.unsigned_abs() < 1 << 64 => {
            fits(of_units(number, to, calendar))
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
        Family::TimeOfDay => time_of_day(nanoseconds),
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

/// Returns the time that has passed since midnight, also before 1970.
fn time_of_day(moment: i64) -> u64 {
    wrapped(i128::from(moment).rem_euclid(DAY)).cast_unsigned()
}

/// Converts a duration, date or time of day to another such type: DATE to DT gives midnight, DT to DATE the day, and DT to
/// TOD the time since midnight; a duration to TOD is taken modulo 24 hours.
pub(crate) fn between(raw: u64, to: ElementaryType) -> u64 {
    stored(raw.cast_signed(), to)
}

/// Returns the moment of a date and a time of day, modulo 2^64 nanoseconds.
pub(crate) fn concatenated(date: u64, time: u64) -> u64 {
    wrapped(nanoseconds(date) + nanoseconds(time)).cast_unsigned()
}
