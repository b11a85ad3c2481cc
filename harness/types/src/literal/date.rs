//! Dates and times of day: `2024-02-29`, `12:34:56.789`, `2024-02-29-12:34:56.5`.

use super::LiteralError;
use super::duration::{digits_at, fraction_of, write_fraction};
use std::borrow::Cow;
use std::fmt;

/// Nanoseconds in a second.
const SECOND: i64 = 1_000_000_000;
/// Nanoseconds in a day.
const DAY: i64 = 86_400 * SECOND;

/// Reads a date, such as `2024-02-29`, into nanoseconds from 1970-01-01 to the start of that day.
///
/// The calendar is the Gregorian one throughout. Year, month and day are unsigned integers with any number of digits.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` for a day that the calendar does not have (2023-02-29) and for a day
/// whose start 64 bits do not reach: the first is 1677-09-22, the last 2262-04-11.
///
/// Basis: iec-61131-3: Table 9 (date literals); the raw form of a date is that of [`Value`](crate::Value).
pub fn date(text: &str) -> Result<i64, LiteralError> {
    let mut fields = Fields::new(text);
    let day = fields.date()?;
    fields.end()?;
    instant(day, 0)
}

/// Reads a time of day, such as `12:34:56.789`, into nanoseconds since midnight.
///
/// Hours to 23, minutes and seconds to 59: neither `24:00:00` nor a leap second is a time of day. What is left of the fraction
/// below one nanosecond is cut off.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where a field is too great.
///
/// Basis: iec-61131-3: Table 9 (time of day literals).
pub fn time_of_day(text: &str) -> Result<i64, LiteralError> {
    let mut fields = Fields::new(text);
    let time = fields.time()?;
    fields.end()?;
    Ok(time)
}

/// Reads a date and time of day, such as `2024-02-29-12:34:56.5`, into nanoseconds from 1970-01-01-00:00:00.
///
/// # Errors
/// Fails as [`date`] and [`time_of_day`] do; the range is 1677-09-21-00:12:43.145224192 to 2262-04-11-23:47:16.854775807.
///
/// Basis: iec-61131-3: Table 9 (date and time literals); the raw form is that of [`Value`](crate::Value).
pub fn date_and_time(text: &str) -> Result<i64, LiteralError> {
    let mut fields = Fields::new(text);
    let day = fields.date()?;
    fields.mark(b'-', "`-` and a time of day")?;
    let time = fields.time()?;
    fields.end()?;
    instant(day, time)
}

/// Returns the days from 1970-01-01 to a date; `None` where the calendar has no such day, or the year is not from 0 to 99 999.
pub fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    let is_month = (0..=99_999).contains(&year) && (1..=12).contains(&month);
    let is_day = is_month && (1..=days_in_month(year, month)).contains(&day);
    is_day.then(|| days_from_civil(year, month, day))
}

/// Returns the nanoseconds from 1970-01-01 to a time on a day that is counted from there.
///
/// # Errors
/// `Overflow` where 64 bits do not hold them.
pub fn instant(day: i64, time: i64) -> Result<i64, LiteralError> {
    i64::try_from(i128::from(day) * i128::from(DAY) + i128::from(time))
        .map_err(|_| LiteralError::overflow(0, "a date"))
}

/// Adds the second 0 to a time of day that ends with its minute, for dialects where it may.
pub fn with_seconds(text: &str) -> Cow<'_, str> {
    match text.matches(':').count() {
        1 => Cow::Owned(format!("{text}:00")),
        _ => Cow::Borrowed(text),
    }
}

/// A text that is parsed field by field.
struct Fields<'t> {
    bytes: &'t [u8],
    at: usize,
}

impl<'t> Fields<'t> {
    fn new(text: &'t str) -> Fields<'t> {
        Fields {
            bytes: text.as_bytes(),
            at: 0,
        }
    }

    /// Parses a date; returns the days since the epoch.
    fn date(&mut self) -> Result<i64, LiteralError> {
        // Any greater year is far outside the range; this bound keeps the arithmetic on days small.
        let year = self.number(0, 99_999, "a date")?;
        self.mark(b'-', "`-` and the month")?;
        let month = self.number(1, 12, "the months of a year")?;
        self.mark(b'-', "`-` and the day")?;
        let day = self.number(1, days_in_month(year, month), "the days of the month")?;
        Ok(days_from_civil(year, month, day))
    }

    /// Parses a time of day; returns the nanoseconds since midnight.
    fn time(&mut self) -> Result<i64, LiteralError> {
        let hour = self.number(0, 23, "the hours of a day")?;
        self.mark(b':', "`:` and the minute")?;
        let minute = self.number(0, 59, "the minutes of an hour")?;
        self.mark(b':', "`:` and the second")?;
        let second = self.number(0, 59, "the seconds of a minute")?;
        let whole = ((hour * 60 + minute) * 60 + second) * SECOND;
        if self.bytes.get(self.at) != Some(&b'.') {
            return Ok(whole);
        }
        let digits = digits_at(self.bytes, self.at + 1)?;
        self.at += 1 + digits.len();
        // Less than a second, so it always fits.
        Ok(whole + fraction_of(digits, SECOND.unsigned_abs()).cast_signed())
    }

    /// Parses a whole number from `least` to `greatest`, which is less than a million.
    fn number(&mut self, least: i64, greatest: i64, range: &'static str) -> Result<i64, LiteralError> {
        let digits = digits_at(self.bytes, self.at)?;
        let value = digits
            .iter()
            .filter(|byte| byte.is_ascii_digit())
            .fold(0, |value, digit| {
                (value * 10 + i64::from(digit - b'0')).min(1_000_000)
            });
        if !(least..=greatest).contains(&value) {
            return Err(LiteralError::overflow(self.at, range));
        }
        self.at += digits.len();
        Ok(value)
    }

    fn mark(&mut self, mark: u8, expected: &'static str) -> Result<(), LiteralError> {
        if self.bytes.get(self.at) != Some(&mark) {
            return Err(LiteralError::malformed(self.at, expected));
        }
        self.at += 1;
        Ok(())
    }

    fn end(&self) -> Result<(), LiteralError> {
        if self.at < self.bytes.len() {
            return Err(LiteralError::malformed(self.at, "the end of the date or time"));
        }
        Ok(())
    }
}

fn days_in_month(year: i64, month: i64) -> i64 {
    match month {
        2 if year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Returns the days from 1970-01-01 to a date.
///
/// The year is taken to begin in March, so that the leap day is its last, and 400 years, which are always 146 097 days, are one
/// era. Day 719 468 of the count from 0000-03-01 is the epoch.
fn days_from_civil(year: i64, month: i64, day: i64) -> i64 {
    let year = if month > 2 { year } else { year - 1 };
    let (era, year_of_era) = (year.div_euclid(400), year.rem_euclid(400));
    let month_from_march = (month + 9) % 12;
    let day_of_year = (153 * month_from_march + 2) / 5 + day - 1;
    let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
    era * 146_097 + day_of_era - 719_468
}

/// Returns year, month and day of the date that lies `days` days after 1970-01-01: the inverse of [`days_from_civil`].
fn civil_from_days(days: i64) -> (i64, i64, i64) {
    let days = days + 719_468;
    let (era, day_of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = (month_from_march + 2) % 12 + 1;
    (era * 400 + year_of_era + i64::from(month <= 2), month, day)
}

/// Writes the day on which a date, or a date and time, lies: `2024-02-29`.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_date(out: &mut impl fmt::Write, nanoseconds: i64) -> fmt::Result {
    let (year, month, day) = civil_from_days(nanoseconds.div_euclid(DAY));
    write!(out, "{year:04}-{month:02}-{day:02}")
}

/// Writes the nanoseconds since midnight as a time of day: `12:34:56`, `12:34:56.789`.
///
/// A number outside the range of a time of day is taken modulo a day.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_time_of_day(out: &mut impl fmt::Write, nanoseconds: i64) -> fmt::Result {
    let time = nanoseconds.rem_euclid(DAY);
    let seconds = time / SECOND;
    write!(
        out,
        "{:02}:{:02}:{:02}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60
    )?;
    write_fraction(out, (time % SECOND).unsigned_abs(), 9)
}

/// Writes a date and time: `2024-02-29-12:34:56.5`.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_date_and_time(out: &mut impl fmt::Write, nanoseconds: i64) -> fmt::Result {
    write_date(out, nanoseconds)?;
    out.write_char('-')?;
    write_time_of_day(out, nanoseconds)
}
