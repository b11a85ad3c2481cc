//! Durations, dates and times of day: whole units and what lies between, limits, midnight, leap days, the epoch.

use super::integers::limits;
use crate::operand::Operand;
use stickler_types::{ElementaryType, Value};

/// Nanoseconds in a millisecond.
pub const MILLISECOND: i128 = 1_000_000;

/// The dates of the tables that the ForgeIEC page's functions are first held to.
pub const DATES: [&str; 9] = [
    "1970-01-01",
    "1972-02-29",
    "1999-12-31",
    "2000-02-29",
    "2000-03-01",
    "2024-02-29",
    "2024-12-31",
    "2038-01-19",
    "2100-02-28",
];

/// The times of day that go with them.
pub const TIMES_OF_DAY: [&str; 6] = [
    "00:00:00",
    "00:00:01",
    "12:34:56",
    "12:34:56.789",
    "23:59:59",
    "23:59:59.999",
];

/// Days at which a calendar goes wrong: the first and the last that 64 bits of nanoseconds reach, beside the epoch, centuries
/// that are no leap years, days beside a leap day, the day on which 32 bits of seconds end.
pub const FAR_DATES: [&str; 17] = [
    "1677-09-22",
    "1700-02-28",
    "1700-03-01",
    "1899-12-31",
    "1900-02-28",
    "1900-03-01",
    "1968-02-29",
    "1969-12-31",
    "1970-01-02",
    "1972-03-01",
    "1996-02-29",
    "2024-02-28",
    "2024-03-01",
    "2100-03-01",
    "2106-02-07",
    "2200-02-28",
    "2262-04-11",
];

/// Times of day beside midnight and with the least fraction.
pub const FINE_TIMES: [&str; 4] = [
    "00:00:00.000000001",
    "11:59:59.999999999",
    "12:00:00",
    "23:59:59.999999999",
];

/// A duration, date or time of day with these nanoseconds; `None` where 64 bits do not hold them.
#[must_use]
pub fn nanoseconds(ty: ElementaryType, nanoseconds: i128) -> Option<Operand> {
    let raw = i64::try_from(nanoseconds).ok()?;
    Some(Operand::of(Value::plain(ty, raw.cast_unsigned())))
}

/// Durations of whole milliseconds with these numbers, where 64 bits hold them, in this order.
#[must_use]
pub fn milliseconds(ty: ElementaryType, numbers: &[i128]) -> Vec<Operand> {
    let durations = numbers
        .iter()
        .filter_map(|number| nanoseconds(ty, number * MILLISECOND));
    durations.collect()
}

/// Whole milliseconds at the limits of an integer or bit string and one past them, what is no whole millisecond, and the ends of
/// the type.
#[must_use]
pub fn durations_for(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    let (least, greatest) = limits(to);
    let mut whole = vec![
        0,
        1,
        -1,
        1000,
        least,
        least - 1,
        greatest,
        greatest + 1,
        greatest + 2,
    ];
    whole.sort_unstable();
    whole.dedup();
    let mut durations = milliseconds(from, &whole);
    durations.extend(fractions_of_a_millisecond(from));
    durations.extend(ends(from));
    durations
}

/// Durations that are no whole milliseconds.
#[must_use]
pub fn fractions_of_a_millisecond(ty: ElementaryType) -> Vec<Operand> {
    let fractions = [
        1, -1, 499_999, 500_000, -500_000, 999_999, -999_999, 1_000_001, -1_500_000, 2_500_000,
    ];
    let durations = fractions.into_iter().filter_map(|number| nanoseconds(ty, number));
    durations.collect()
}

/// The least and the greatest of all values that 64 bits of nanoseconds hold.
#[must_use]
pub fn ends(ty: ElementaryType) -> Vec<Operand> {
    let ends = [i64::MIN.into(), i64::MAX.into()].into_iter();
    ends.filter_map(|number| nanoseconds(ty, number)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Date, Dt, Sint, Time, Tod};

    #[test]
    fn the_lists_are_dates_and_times_of_day() {
        for date in DATES.into_iter().chain(FAR_DATES) {
            assert_eq!(Operand::read(Date, date).literal, format!("DATE#{date}"));
        }
        for time in TIMES_OF_DAY.into_iter().chain(FINE_TIMES) {
            assert_eq!(Operand::read(Tod, time).literal, format!("TOD#{time}"));
        }
    }

    #[test]
    fn durations_go_to_the_limits_of_their_target() {
        let literals: Vec<String> = durations_for(Time, Sint)
            .into_iter()
            .map(|operand| operand.literal)
            .collect();
        for literal in [
            "TIME#-129ms",
            "TIME#-128ms",
            "TIME#127ms",
            "TIME#128ms",
            "TIME#-0.5ms",
        ] {
            assert!(literals.iter().any(|l| l == literal), "{literal}: {literals:?}");
        }
    }

    #[test]
    fn what_64_bits_do_not_hold_is_left_out() {
        assert_eq!(milliseconds(Time, &[1, 1 << 62]).len(), 1);
        assert_eq!(ends(Dt)[1].literal, "DT#2262-04-11-23:47:16.854775807");
    }
}
