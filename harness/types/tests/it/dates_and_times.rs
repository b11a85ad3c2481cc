//! Literals of dates and times, against a calendar that is walked day by day.

use stickler_types::literal::{date, write_date};

/// Nanoseconds in a day.
const DAY: i64 = 86_400_000_000_000;

/// Returns the day after a date, by the rules of the Gregorian calendar.
fn next((year, month, day): (i64, usize, i64)) -> (i64, usize, i64) {
    let leap = if year % 100 == 0 {
        year % 400 == 0
    } else {
        year % 4 == 0
    };
    let february = if leap { 29 } else { 28 };
    let lengths = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
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
        let mut written = String::new();
        write_date(&mut written, expected).unwrap();
        assert_eq!(written, text);
        if text == "2262-04-11" {
            break;
        }
        today = next(today);
        expected += DAY;
    }
    assert_eq!(date("1970-01-01"), Ok(0));
}
