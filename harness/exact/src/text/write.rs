//! Conversions of values to texts.

use super::digits::{self, RoundedDecimal};
use super::read::UNITS;
use crate::calendar;
use crate::integer;
use crate::real::{self, Real};
use stickler_types::{BitStringText, ConversionChoices, ElementaryType, Family, MomentText, RealText};

/// Returns the text of a value that is neither a text nor a character, in ASCII characters.
///
/// | type | text |
/// |---|---|
/// | integers | decimal digits, behind a minus where it is negative |
/// | bit strings | `16#` and hexadecimal digits as chosen |
/// | BOOL | `TRUE`, `FALSE` |
/// | REAL, LREAL | digits as chosen; `NaN`, `Infinity`, `-Infinity` by any choice |
/// | TIME, LTIME | `T#1500ms`, `LTIME#1500000000ns` |
/// | DATE … LDT | `D#2024-02-29`, `TOD#12:34:56.5`, `DT#2024-02-29-12:34:56.5`; the long forms behind `LDATE#`, `LTOD#`, `LDT#` |
///
/// Basis: harness/engines/README.md (how values are written); for integers forgeiec-conversion-functions: The naming pattern.
pub(crate) fn write(raw: u64, from: ElementaryType, choices: &ConversionChoices) -> String {
    let nanoseconds = i128::from(raw.cast_signed());
    if choices.moment_text == MomentText::Components && from.is_moment() {
        return moment(raw, from);
    }
    match from.family() {
        Family::Boolean => if raw == 0 { "FALSE" } else { "TRUE" }.to_owned(),
        Family::Signed | Family::Unsigned => integer::number(raw, from).to_string(),
        Family::BitString => bit_string(raw, from, choices.bit_string_text),
        Family::Real => real(raw, from, choices.real_text),
        Family::Duration if from == ElementaryType::Time => format!("T#{}", milliseconds(nanoseconds)),
        Family::Duration => format!("LTIME#{nanoseconds}ns"),
        Family::Date => format!("{}{}", prefix(from), date(nanoseconds)),
        Family::TimeOfDay => format!("{}{}", prefix(from), time_of_day(nanoseconds)),
        Family::DateAndTime => {
            let (date, time) = (date(nanoseconds), time_of_day(nanoseconds));
            format!("{}{date}-{time}", prefix(from))
        }
        Family::Text | Family::Character => String::new(),
    }
}

fn bit_string(raw: u64, from: ElementaryType, form: BitStringText) -> String {
    match form {
        BitStringText::FullWidth => format!("16#{raw:0width$X}", width = from.bits() as usize / 4),
        BitStringText::Shortest => format!("16#{raw:x}"),
        BitStringText::Decimal => raw.to_string(),
    }
}

/// Returns the prefix of a date or time of day, such as `D#`.
const fn prefix(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Date => "D#",
        ElementaryType::Ldate => "LDATE#",
        ElementaryType::Tod => "TOD#",
        ElementaryType::Ltod => "LTOD#",
        ElementaryType::Dt => "DT#",
        _ => "LDT#",
    }
}

/// Formats milliseconds: `1500ms`, `-1.5ms`, `0.000001ms`.
fn milliseconds(nanoseconds: i128) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let magnitude = nanoseconds.unsigned_abs();
    let fraction = fraction(magnitude % 1_000_000, 6);
    format!("{sign}{}{fraction}ms", magnitude / 1_000_000)
}

/// Formats the day on which a moment lies: `2024-02-29`.
fn date(nanoseconds: i128) -> String {
    // Some hundred thousand days.
    let days = nanoseconds.div_euclid(86_400_000_000_000) as i64;
    let (year, month, day) = calendar::date(days);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Formats the time since midnight: `12:34:56`, `12:34:56.789`.
fn time_of_day(nanoseconds: i128) -> String {
    let time = nanoseconds.rem_euclid(86_400_000_000_000).unsigned_abs();
    let seconds = time / 1_000_000_000;
    let (hours, minutes) = (seconds / 3600, seconds / 60 % 60);
    let fraction = fraction(time % 1_000_000_000, 9);
    format!("{hours:02}:{minutes:02}:{:02}{fraction}", seconds % 60)
}

/// Formats a fraction of `digits` digits behind a point, without the zeros at the end; returns an empty text for zero.
fn fraction(number: u128, digits: usize) -> String {
    if number == 0 {
        return String::new();
    }
    format!(".{number:0digits$}").trim_end_matches('0').to_owned()
}

fn real(raw: u64, from: ElementaryType, form: RealText) -> String {
    let number = match real::decode(raw, from) {
        Real::NotANumber if form == RealText::ByWidth => return "#NaN".to_owned(),
        Real::Infinite { negative } if form == RealText::ByWidth => {
            return if negative { "-#Inf" } else { "#Inf" }.to_owned();
        }
        Real::NotANumber => return "NaN".to_owned(),
        Real::Infinite { negative: false } => return "Infinity".to_owned(),
        Real::Infinite { negative: true } => return "-Infinity".to_owned(),
        Real::Finite(number) => number,
    };
    let is_zero = number.significand == 0;
    let magnitude = match form {
        RealText::ByWidth if is_zero => return "0.0".to_owned(),
        RealText::ByWidth => by_width(&digits::scaled(number, raw, from), from),
        RealText::Shortest if is_zero => "0.0".to_owned(),
        RealText::Shortest => canonical(&digits::shortest(raw, from)),
        RealText::SignificantDigits(_) if is_zero => "0".to_owned(),
        RealText::SignificantDigits(count) => as_printf_does(&digits::significant(raw, from, count), count),
    };
    if number.negative {
        format!("-{magnitude}")
    } else {
        magnitude
    }
}

/// Formats a REAL with an exponent below 1E-4 and from 1E8, and an LREAL below 1 and from 1E14.
fn by_width(decimal: &RoundedDecimal, ty: ElementaryType) -> String {
    let (is_real, exponent) = (ty == ElementaryType::Real, decimal.exponent);
    let fixed = if is_real { -4..8 } else { 0..14 };
    if fixed.contains(&exponent) {
        let plain = plain(decimal);
        return if plain.contains('.') { plain } else { plain + ".0" };
    }
    let (first, rest) = decimal.digits.split_at(1);
    match (is_real, rest) {
        (true, "") if exponent < 0 => format!("{first}E-{:02}", -exponent),
        (true, "") => format!("{first}E{exponent:02}"),
        (true, rest) if exponent < 0 => format!("{first}.{rest}E-{:02}", -exponent),
        (true, rest) => format!("{first}.{rest}E{exponent:02}"),
        (false, "") => format!("{first}.0e{exponent}"),
        (false, rest) => format!("{first}.{rest}e{exponent}"),
    }
}

/// Formats a duration in its units, or a date or time of day with three or nine digits of a fraction that is not zero.
fn moment(raw: u64, from: ElementaryType) -> String {
    use ElementaryType::{Date, Dt, Ldate, Ldt, Ltime, Ltod, Time, Tod};
    let nanoseconds = i128::from(raw.cast_signed());
    let time = time_of_day(nanoseconds);
    let (seconds, fraction) = time.split_once('.').unwrap_or((&time, ""));
    let clock = |places: usize| match fraction {
        "" => seconds.to_owned(),
        fraction => format!("{seconds}.{}", &format!("{fraction:0<9}")[..places]),
    };
    match from {
        Time => format!("T#{}", components(raw, &UNITS[..5])),
        Ltime => format!("LTIME#{}", components(raw, &UNITS)),
        Date => format!("D#{}", date(nanoseconds)),
        Ldate => format!("LD#{}", date(nanoseconds)),
        Tod => format!("TOD#{}", clock(3)),
        Ltod => format!("LTOD#{}", clock(9)),
        Dt => format!("DT#{}-{}", date(nanoseconds), clock(3)),
        Ldt => format!("LDT#{}-{}", date(nanoseconds), clock(9)),
        _ => String::new(),
    }
}

/// Formats nanoseconds in these units, as far as the least of them tells, without those of which there are none: `1d2h`, `0ms`.
fn components(nanoseconds: u64, units: &[(&str, u64)]) -> String {
    let mut rest = nanoseconds;
    let mut written = String::new();
    for (name, unit) in units {
        if rest >= *unit {
            written += &format!("{}{name}", rest / unit);
        }
        rest %= unit;
    }
    match units.last() {
        Some((name, _)) if written.is_empty() => format!("0{name}"),
        _ => written,
    }
}

/// Formats a number in the canonical spelling: always with a point, and with an exponent below 1E-4 and from 1E16.
fn canonical(decimal: &RoundedDecimal) -> String {
    if (-4..16).contains(&decimal.exponent) {
        let plain = plain(decimal);
        if plain.contains('.') { plain } else { plain + ".0" }
    } else {
        let (first, rest) = decimal.digits.split_at(1);
        let fraction = if rest.is_empty() { "0" } else { rest };
        format!("{first}.{fraction}E{}", decimal.exponent)
    }
}

/// Formats a number as `%.{count}g` of C does: with an exponent below 1E-4 and from 10^count.
fn as_printf_does(decimal: &RoundedDecimal, count: u8) -> String {
    if (-4..i32::from(count.max(1))).contains(&decimal.exponent) {
        return plain(decimal);
    }
    let (first, rest) = decimal.digits.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    let sign = if decimal.exponent < 0 { '-' } else { '+' };
    format!(
        "{first}{point}{rest}e{sign}{:02}",
        decimal.exponent.unsigned_abs()
    )
}

/// Formats all digits without an exponent, and with a point only where digits follow it.
fn plain(decimal: &RoundedDecimal) -> String {
    let digits = &decimal.digits;
    let Ok(whole) = usize::try_from(decimal.exponent + 1) else {
        let zeros = "0".repeat((-decimal.exponent - 1).unsigned_abs() as usize);
        return format!("0.{zeros}{digits}");
    };
    if digits.len() <= whole {
        let zeros = "0".repeat(whole - digits.len());
        return format!("{digits}{zeros}");
    }
    match digits.split_at(whole) {
        ("", fraction) => format!("0.{fraction}"),
        (whole, fraction) => format!("{whole}.{fraction}"),
    }
}
