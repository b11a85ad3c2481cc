//! Conversions of values to texts.

use super::digits::{self, RoundedDecimal};
use crate::calendar;
use crate::integer;
use crate::real::{self, Real};
use stickler_types::{BitStringText, ConversionChoices, ElementaryType, Family, RealText};

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
    let (negative, significand, exponent) = match real::decode(raw, from) {
        Real::NotANumber => return "NaN".to_owned(),
        Real::Infinite { negative: false } => return "Infinity".to_owned(),
        Real::Infinite { negative: true } => return "-Infinity".to_owned(),
        Real::Finite {
            negative,
            significand,
            exponent,
        } => (negative, significand, exponent),
    };
    let magnitude = match form {
        RealText::Shortest if significand == 0 => "0.0".to_owned(),
        RealText::Shortest => {
            let lowest = real::is_lowest_of_binade(raw, from);
            canonical(&digits::shortest(significand, exponent, lowest, from))
        }
        RealText::SignificantDigits(_) if significand == 0 => "0".to_owned(),
        RealText::SignificantDigits(count) => {
            as_printf_does(&digits::significant(significand, exponent, count), count)
        }
    };
    if negative {
        format!("-{magnitude}")
    } else {
        magnitude
    }
}

/// Formats a number in the canonical spelling: always with a point, and with an exponent below 1E-4 and from 1E16.
fn canonical(decimal: &RoundedDecimal) -> String {
    if (-4..16).contains(&decimal.exponent) {
        let plain = plain(decimal);
        if plain.contains('.') { plain } else { plain + ".0" }
    } else {
        let fraction = match &decimal.digits[1..] {
            [] => "0".to_owned(),
            digits => written(digits),
        };
        format!("{}.{fraction}E{}", decimal.digits[0], decimal.exponent)
    }
}

/// Formats a number as `%.{count}g` of C does: with an exponent below 1E-4 and from 10^count.
fn as_printf_does(decimal: &RoundedDecimal, count: u8) -> String {
    if (-4..i32::from(count.max(1))).contains(&decimal.exponent) {
        return plain(decimal);
    }
    let point = if decimal.digits.len() > 1 { "." } else { "" };
    let (first, rest) = (decimal.digits[0], written(&decimal.digits[1..]));
    let sign = if decimal.exponent < 0 { '-' } else { '+' };
    format!(
        "{first}{point}{rest}e{sign}{:02}",
        decimal.exponent.unsigned_abs()
    )
}

/// Formats all digits without an exponent, and with a point only where digits follow it.
fn plain(decimal: &RoundedDecimal) -> String {
    let digits = written(&decimal.digits);
    let Ok(whole) = usize::try_from(decimal.exponent + 1) else {
        let zeros = "0".repeat((-decimal.exponent - 1).unsigned_abs() as usize);
        return format!("0.{zeros}{digits}");
    };
    if digits.len() <= whole {
        let zeros = "0".repeat(whole - digits.len());
        return digits + &zeros;
    }
    match digits.split_at(whole) {
        ("", fraction) => format!("0.{fraction}"),
        (whole, fraction) => format!("{whole}.{fraction}"),
    }
}

fn written(digits: &[u8]) -> String {
    digits.iter().map(|digit| char::from(b'0' + digit)).collect()
}
