//! The conversion functions of two arguments, which join a date and a time of day.

use stickler_types::{Dialect, ElementaryType};

/// A function that joins a date and a time of day.
///
/// Basis: iec-61131-3: third edition, additional functions of time data types and CONCAT (the names);
/// forgeiec-conversion-functions does not list them, so what they give is open.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Concatenation {
    /// The types of its two parameters in order: a date and a time of day.
    pub operands: [ElementaryType; 2],
    /// The type of its result.
    pub result: ElementaryType,
}

/// The names of the two parameters.
pub const PARAMETERS: [&str; 2] = ["IN1", "IN2"];

/// Their names.
pub const CONCATENATIONS: [(&str, Concatenation); 3] = {
    use ElementaryType::{Date, Dt, Ldate, Ldt, Ltod, Tod};
    [
        ("CONCAT_DATE_TOD", joining(Date, Tod, Dt)),
        ("CONCAT_DATE_LTOD", joining(Date, Ltod, Ldt)),
        ("CONCAT_LDATE_LTOD", joining(Ldate, Ltod, Ldt)),
    ]
};

const fn joining(date: ElementaryType, time: ElementaryType, result: ElementaryType) -> Concatenation {
    Concatenation {
        operands: [date, time],
        result,
    }
}

/// The conversion function of two arguments of this name, in any ASCII case; `None` where the dialect has none,
/// which is so of the long forms where it lacks the types of the third edition.
///
/// | name | takes | gives |
/// |---|---|---|
/// | `CONCAT_DATE_TOD` | DATE, TOD | DT |
/// | `CONCAT_DATE_LTOD` | DATE, LTOD | LDT |
/// | `CONCAT_LDATE_LTOD` | LDATE, LTOD | LDT |
pub fn concatenation(name: &str, dialect: &Dialect) -> Option<Concatenation> {
    CONCATENATIONS
        .into_iter()
        .find(|(known, _)| known.eq_ignore_ascii_case(name))
        .map(|(_, function)| function)
        .filter(|function| function.operands.iter().all(|&ty| dialect.may_name(ty)))
}

impl Concatenation {
    /// The raw form of the result for the raw forms of the date and the time of day: the sum of their
    /// nanoseconds, modulo 2^64. Only a time of day on one of the last days that 64 bits reach, or on the first,
    /// makes it wrap.
    #[inline]
    pub const fn apply_two(self, date: u64, time: u64) -> u64 {
        date.wrapping_add(time)
    }
}
