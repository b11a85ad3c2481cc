//! The Gregorian calendar, also for the days before it was introduced.

/// Returns the number of days before the first day of a year, counted from the first day of year 1.
const fn days_before_year(year: i64) -> i64 {
    let years = year - 1;
    years * 365 + years.div_euclid(4) - years.div_euclid(100) + years.div_euclid(400)
}

const fn is_leap_year(year: i64) -> bool {
    days_before_year(year + 1) - days_before_year(year) == 366
}

/// Returns the number of days of a month from 1 to 12.
pub(crate) const fn days_of_month(year: i64, month: i64) -> i64 {
    match month {
        4 | 6 | 9 | 11 => 30,
        2 if is_leap_year(year) => 29,
        2 => 28,
        _ => 31,
    }
}

/// Returns the number of days from 1970-01-01 to a valid date.
pub(crate) fn days_since_1970(year: i64, month: i64, day: i64) -> i64 {
    let months: i64 = (1..month).map(|month| days_of_month(year, month)).sum();
    days_before_year(year) - days_before_year(1970) + months + day - 1
}

/// Returns year, month and day of the date that lies `days` days after 1970-01-01.
pub(crate) fn date(days: i64) -> (i64, i64, i64) {
    let days = days + days_before_year(1970);
    // A year has from 365 to 366 days, so that this is off by a year now and then.
    let mut year = days.div_euclid(366) + 1;
    while days_before_year(year + 1) <= days {
        year += 1;
    }
    while days_before_year(year) > days {
        year -= 1;
    }
    let mut rest = days - days_before_year(year);
    let mut month = 1;
    while rest >= days_of_month(year, month) {
        rest -= days_of_month(year, month);
        month += 1;
    }
    (year, month, rest + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_follow_each_other_as_on_a_wall_calendar() {
        let (mut year, mut month, mut day) = (1677, 1, 1);
        // 1677-01-01 lies 293 years before 1970, of which 70 have a leap day: 1680 to 1968 but 1700, 1800 and 1900.
        let mut number = -(293 * 365 + 70);
        while year < 2263 {
            assert_eq!(days_since_1970(year, month, day), number, "{year}-{month}-{day}");
            assert_eq!(date(number), (year, month, day));
            let leap = year % 4 == 0 && !matches!(year, 1700 | 1800 | 1900 | 2100 | 2200);
            let length = match month {
                2 if leap => 29,
                2 => 28,
                4 | 6 | 9 | 11 => 30,
                _ => 31,
            };
            (year, month, day) = match (month, day) {
                (12, 31) => (year + 1, 1, 1),
                (_, day) if day == length => (year, month + 1, 1),
                (_, day) => (year, month, day + 1),
            };
            number += 1;
        }
    }
}
