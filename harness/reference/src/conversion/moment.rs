//! Durations, dates and times of day as numbers, and back.
//!
//! A duration counts in milliseconds. Basis: forgeiec-conversion-functions: The naming pattern (`TIME_TO_DINT`
//! "returns ms"). In what the other types count is a choice of the dialect. STruC++ documents it in its tests, and CODESYS was
//! recorded; where no source says, dates and dates with a time count seconds, and the others milliseconds.

use super::real::{self, Exact};
use crate::raw::narrow;
use stickler_types::{ElementaryType, Family, MomentUnits, Rounding};

const DAY: i64 = 86_400_000_000_000;

/// Nanoseconds in the unit that a type is counted in. Inlined, so that it is the same for all operands of a loop.
#[inline(always)]
const fn unit(ty: ElementaryType, units: MomentUnits) -> i64 {
    match (ty.family(), units) {
        (_, MomentUnits::Counts) if ty.is_third_edition() => 1,
        (Family::Date, MomentUnits::DaysAndMilliseconds | MomentUnits::DaysSince1990) => DAY,
        (
            Family::Date | Family::DateAndTime,
            MomentUnits::Seconds | MomentUnits::ShortTime | MomentUnits::Counts,
        ) => 1_000_000_000,
        _ => 1_000_000,
    }
}

/// Nanoseconds from 1970-01-01 to the moment from which a type is counted.
#[inline(always)]
const fn origin(ty: ElementaryType, units: MomentUnits) -> i64 {
    match (ty.family(), units) {
        (Family::Date, MomentUnits::DaysSince1990) => 7_305 * DAY,
        _ => 0,
    }
}

/// The integer type that counts the units of a type, where each type counts its own.
pub const fn counter(ty: ElementaryType) -> ElementaryType {
    match (ty.family(), ty.is_third_edition()) {
        (_, false) => ElementaryType::Udint,
        (Family::Date | Family::DateAndTime, true) => ElementaryType::Lint,
        (_, true) => ElementaryType::Ulint,
    }
}

/// The nanoseconds of a raw form, where each type counts its own units.
fn nanoseconds(raw: u64, from: ElementaryType) -> i128 {
    let count = to_units(raw, from, MomentUnits::Counts);
    let number = match counter(from) {
        ElementaryType::Lint => count.cast_signed().into(),
        _ => i128::from(count),
    };
    number * i128::from(unit(from, MomentUnits::Counts))
}

/// Converts between types that count their own units: what is finer is dropped, and the count taken modulo 2^n.
///
/// A TOD gives LTIME its count, as if the milliseconds were nanoseconds.
pub fn between_counts(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    let units = MomentUnits::Counts;
    if (from, to) == (ElementaryType::Tod, ElementaryType::Ltime) {
        return to_units(raw, from, units);
    }
    let nanoseconds = match to.family() {
        Family::TimeOfDay => nanoseconds(raw, from).rem_euclid(DAY.into()),
        _ => nanoseconds(raw, from),
    };
    // The low bits are the count modulo 2^n.
    from_units(nanoseconds.div_euclid(unit(to, units).into()) as u64, to, units)
}

/// The number of whole units, the fraction dropped.
#[inline]
pub fn to_units(raw: u64, from: ElementaryType, units: MomentUnits) -> u64 {
    // A date is a whole number of days, as its origin is, so that dividing first is exact and cannot overflow.
    let unit = unit(from, units);
    let whole = (raw.cast_signed() / unit - origin(from, units) / unit).cast_unsigned();
    match units {
        MomentUnits::Counts => narrow(whole, counter(from)),
        _ => whole,
    }
}

/// The number of units as REAL or LREAL, rounded once.
pub fn to_real_units(raw: u64, from: ElementaryType, to: ElementaryType, units: MomentUnits) -> u64 {
    if units == MomentUnits::Counts {
        return real::from_integer(to_units(raw, from, units), counter(from), to);
    }
    let nanoseconds = i128::from(raw.cast_signed()) - i128::from(origin(from, units));
    let magnitude = nanoseconds.unsigned_abs();
    Exact::quotient(nanoseconds < 0, magnitude, unit(from, units).unsigned_abs(), 0).to_real(to)
}

/// Returns so many units, modulo 2^64 nanoseconds. A bit string, BOOL and an unsigned integer count as such: their
/// product modulo 2^64 is the same. Inlined, so that a loop over operands chooses the unit once.
#[inline(always)]
pub fn from_units(raw: u64, to: ElementaryType, units: MomentUnits) -> u64 {
    match (units, to) {
        // Without a sign.
        (MomentUnits::Counts, ElementaryType::Ltod) => raw % DAY.unsigned_abs(),
        (MomentUnits::Counts, _) => {
            let count = narrow(raw, counter(to)).cast_signed();
            whole(count.wrapping_mul(unit(to, units)), to)
        }
        (MomentUnits::ShortTime, ElementaryType::Time) => {
            let count = narrow(raw, ElementaryType::Dint).cast_signed();
            (count * unit(to, units)).cast_unsigned()
        }
        _ => {
            let nanoseconds = raw.cast_signed().wrapping_mul(unit(to, units));
            whole(nanoseconds.wrapping_add(origin(to, units)), to)
        }
    }
}

/// Returns so many units, rounded to the nearest nanosecond, ties to even, modulo 2^64 nanoseconds; NaN and the
/// infinities give 0. Inlined as [`from_units`] is.
#[inline(always)]
pub fn from_real_units(raw: u64, from: ElementaryType, to: ElementaryType, units: MomentUnits) -> u64 {
    let value = real::decode(raw, from);
    let origin = origin(to, units);
    let unit = unit(to, units);
    let nanoseconds = if from == ElementaryType::Real && unit != DAY {
        // A REAL has 24 binary digits, and the units but for the day have at most 21 before their zeros: the product is exact.
        real::to_integer(value * unit as f64, Rounding::HalfToEven)
    } else {
        from_long_real_units(value, unit)
    };
    whole(nanoseconds.cast_signed().wrapping_add(origin), to)
}

/// Returns so many units of any number; not inlined, so that the loop for REAL stays small.
#[inline(never)]
fn from_long_real_units(value: f64, unit: i64) -> u64 {
    if !value.is_finite() {
        return 0;
    }
    let (significand, exponent) = real::parts(value);
    let magnitude = u128::from(significand) * u128::from(unit.unsigned_abs());
    let exact = Exact {
        negative: value.is_sign_negative(),
        magnitude,
        inexact: false,
        exponent,
    };
    exact.to_integer()
}

/// Nanoseconds as the type holds them: a date is a whole day, a time of day less than one.
fn whole(nanoseconds: i64, to: ElementaryType) -> u64 {
    let bits = nanoseconds.cast_unsigned();
    match to.family() {
        Family::Date => day(bits),
        Family::TimeOfDay => time_of_day(bits),
        _ => bits,
    }
}

/// The day on which a moment lies. The first moments that 64 bits reach belong to a day that began before
/// them; they give the day after it, the first that can be written.
pub fn day(raw: u64) -> u64 {
    let moment = raw.cast_signed();
    let days = moment.div_euclid(DAY);
    days.checked_mul(DAY)
        .or_else(|| (days + 1).checked_mul(DAY))
        .unwrap_or(moment)
        .cast_unsigned()
}

/// The time since midnight of a moment.
#[inline]
pub const fn time_of_day(raw: u64) -> u64 {
    raw.cast_signed().rem_euclid(DAY).cast_unsigned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_moment_has_a_whole_day() {
        for moment in [i64::MIN, i64::MIN + 1, -1, 0, i64::MAX] {
            assert_eq!(day(moment.cast_unsigned()).cast_signed() % DAY, 0, "{moment}");
        }
        for limit in [i64::MIN, i64::MAX] {
            assert_eq!(day(limit.cast_unsigned()).cast_signed(), limit / DAY * DAY);
        }
    }
}
