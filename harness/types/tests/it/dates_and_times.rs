//! Literals of dates and times, against a calendar that is walked day by day.

use std::fmt;
use stickler_types::LiteralError;
use stickler_types::literal::{
    date, date_and_time, time_of_day, write_date, write_date_and_time, write_time_of_day,
};

/// Nanoseconds in a day.
const DAY: i64 = 86_400_000_000_000;

fn written(write: impl Fn(&mut String, i64) -> fmt::Result, nanoseconds: i64) -> String {
    let mut out = String::new();
    write(&mut out, nanoseconds).unwrap();
    out
}

/// Returns the day after a date, by the rules of the Gregorian calendar.
fn next((year, month, day): (i64, usize, i64)) -> (i64, usize, i64) {
    let leap = if year % 100 == 0 {
        year % 400 == 0
    } else {
        year % 4 == 0
    };
    let lengths = [
        31,
        if leap { 29 } else { 28 },
        31,
        30,
        31,
        30,
        31,
        31,
        30,
        31,
        30,
        31,
    ];
    if day < lengths[month - 1] {
        (year, month, day + 1)
    } else if month < 12 {
        (year, month + 1, 1)
    } else {
        (year + 1, 1, 1)
    }
}

#[test]
fn every_day_that_64_bits_reach_follows_the_one_before() {
    let mut today = (1677, 9, 22);
    let mut expected = -106_751 * DAY;
    loop {
        let (year, month, day) = today;
        let text = format!("{year:04}-{month:02}-{day:02}");
        assert_eq!(date(&text), Ok(expected), "{text}");
        assert_eq!(written(write_date, expected), text);
        if text == "2262-04-11" {
            break;
        }
        today = next(today);
        expected += DAY;
    }
    assert_eq!(date("1970-01-01"), Ok(0));
}

#[test]
fn days_that_the_calendar_or_the_range_does_not_have_overflow() {
    for (text, at) in [
        ("2023-02-29", 8),
        ("1900-02-29", 8),
        ("2024-04-31", 8),
        ("2024-13-01", 5),
        ("2024-00-01", 5),
        ("2024-01-00", 8),
        ("1677-09-21", 0),
        ("2262-04-12", 0),
        ("0000-01-01", 0),
        ("99999-01-01", 0),
        ("100000-01-01", 0),
    ] {
        let error = date(text).unwrap_err();
        assert!(matches!(error, LiteralError::Overflow { .. }), "{text}: {error}");
        assert_eq!(error.offset(), at, "{text}");
    }
    assert!(matches!(
        date(&format!("{}-01-01", "9".repeat(100_000))),
        Err(LiteralError::Overflow { .. })
    ));
    assert_eq!(date("2024-2-9"), date("2024-02-09"));
}

#[test]
fn times_of_day_end_before_midnight() {
    assert_eq!(time_of_day("00:00:00"), Ok(0));
    assert_eq!(time_of_day("15:36:55.36"), Ok(56_215_360_000_000));
    assert_eq!(
        time_of_day("23:59:59.9999999999"),
        Ok(DAY - 1),
        "the tenth digit is cut off"
    );
    for (text, at) in [("24:00:00", 0), ("23:60:00", 3), ("23:59:60", 6)] {
        let error = time_of_day(text).unwrap_err();
        assert!(matches!(error, LiteralError::Overflow { .. }), "{text}: {error}");
        assert_eq!(error.offset(), at, "{text}");
    }
}

#[test]
fn what_is_no_date_or_time_is_rejected_where_it_goes_wrong() {
    let date_faults = [
        ("", 0),
        ("2024", 4),
        ("2024-01", 7),
        ("2024-01-", 8),
        ("-2024-01-01", 0),
        ("2024-01-01-", 10),
    ];
    let time_faults = [
        ("", 0),
        ("12:00", 5),
        ("12:00:", 6),
        ("12:00:00.", 9),
        ("-1:00:00", 0),
        ("12:00:00Z", 8),
    ];
    let both_faults = [
        ("2024-01-01", 10),
        ("2024-01-01 12:00:00", 10),
        ("2024-01-01-12:00", 16),
    ];
    let results = date_faults.map(|(text, at)| (text, at, date(text))).into_iter();
    let results = results.chain(time_faults.map(|(text, at)| (text, at, time_of_day(text))));
    let results = results.chain(both_faults.map(|(text, at)| (text, at, date_and_time(text))));
    for (text, at, result) in results {
        let error = result.unwrap_err();
        assert!(matches!(error, LiteralError::Malformed { .. }), "{text}: {error}");
        assert_eq!(error.offset(), at, "{text}");
    }
}

#[test]
fn dates_and_times_reach_exactly_as_far_as_64_bits() {
    for (text, nanoseconds) in [
        ("1677-09-21-00:12:43.145224192", i64::MIN),
        ("1969-12-31-23:59:59.999999999", -1),
        ("1970-01-01-00:00:00", 0),
        ("2024-02-29-12:34:56.5", 1_709_210_096_500_000_000),
        ("2262-04-11-23:47:16.854775807", i64::MAX),
    ] {
        assert_eq!(date_and_time(text), Ok(nanoseconds), "{text}");
        assert_eq!(written(write_date_and_time, nanoseconds), text);
    }
    for text in ["1677-09-21-00:12:43.145224191", "2262-04-11-23:47:16.854775808"] {
        assert!(
            matches!(date_and_time(text), Err(LiteralError::Overflow { .. })),
            "{text}"
        );
    }
}

#[test]
fn canonical_times_of_day_have_a_fraction_only_where_it_is_not_zero() {
    assert_eq!(written(write_time_of_day, 45_296_789_000_000), "12:34:56.789");
    assert_eq!(written(write_time_of_day, 45_296_000_000_000), "12:34:56");
    assert_eq!(written(write_time_of_day, DAY - 1), "23:59:59.999999999");
    assert_eq!(written(write_time_of_day, 1), "00:00:00.000000001");
}
