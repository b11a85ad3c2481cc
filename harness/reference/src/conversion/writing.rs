//! Values written as texts.
//!
//! No source says which form a text has. Where a dialect does not choose another it is the form that the wire
//! protocol gives the value, without the type's name where a program could not read it back with it: `-5`,
//! `16#00FF`, `0.1`, `TRUE`, `T#1500ms`, `D#2024-02-29`, `TOD#12:34:56`, `DT#2024-02-29-12:34:56`.
//!
//! Basis: forgeiec-conversion-functions: The naming pattern (`<num>_TO_STRING`); the form is open.

use super::real;
use std::fmt::{self, Write as _};
use stickler_types::literal::DURATION_UNITS;
use stickler_types::{BitStringText, ElementaryType, Family, MomentText, RealText, Value};

/// Writes a value as text, in ASCII characters; `reals` and `bits` say in which form REAL and LREAL, BYTE … LWORD, and
/// durations and dates are written.
pub fn write(
    raw: u64,
    from: ElementaryType,
    reals: RealText,
    bits: BitStringText,
    moments: MomentText,
) -> String {
    let mut text = String::new();
    let written = match (from.family(), reals, bits) {
        (Family::Real, RealText::ByWidth, _) => by_width(&mut text, raw, from),
        (Family::Duration, ..) if moments == MomentText::Components => duration(&mut text, raw, from),
        (Family::Date | Family::TimeOfDay | Family::DateAndTime, ..) if moments == MomentText::Components => {
            date_or_time(&mut text, raw, from)
        }
        (Family::Real, RealText::SignificantDigits(digits), _) if real::decode(raw, from).is_finite() => {
            rounded_digits(&mut text, real::decode(raw, from), digits)
        }
        (Family::BitString, _, BitStringText::Shortest) => write!(text, "16#{raw:x}"),
        (Family::BitString, _, BitStringText::Decimal) => write!(text, "{raw}"),
        _ => literal(&mut text, raw, from),
    };
    debug_assert!(written.is_ok(), "a text takes everything");
    text
}

/// The value's literal, with no more of a prefix than it needs.
fn literal(text: &mut String, raw: u64, from: ElementaryType) -> fmt::Result {
    write!(text, "{}", Value::plain(from, raw))?;
    let behind_prefix = text.find('#').map_or(0, |at| at + 1);
    text.replace_range(..behind_prefix, prefix(from));
    Ok(())
}

/// The prefix without which a duration or date would not be a literal.
const fn prefix(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Time => "T#",
        ElementaryType::Ltime => "LTIME#",
        ElementaryType::Date => "D#",
        ElementaryType::Ldate => "LDATE#",
        ElementaryType::Tod => "TOD#",
        ElementaryType::Ltod => "LTOD#",
        ElementaryType::Dt => "DT#",
        ElementaryType::Ldt => "LDT#",
        _ => "",
    }
}

/// A finite number with so many significant digits, as [`RealText::SignificantDigits`] describes it.
fn rounded_digits(out: &mut impl fmt::Write, value: f64, digits: u8) -> fmt::Result {
    let digits = usize::from(digits.max(1));
    // The library rounds the exact decimal expansion, once: `d.ddd` and the exponent that this rounding leads to.
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let places = i32::try_from(digits - 1).unwrap_or(0) - exponent;
    if exponent >= -4
        && let Ok(decimals) = usize::try_from(places)
    {
        out.write_str(without_trailing_zeros(&format!("{value:.decimals$}")))
    } else {
        let sign = if exponent < 0 { '-' } else { '+' };
        let mantissa = without_trailing_zeros(mantissa);
        write!(out, "{mantissa}e{sign}{:02}", exponent.unsigned_abs())
    }
}

/// A real number as [`RealText::ByWidth`] describes it.
fn by_width(out: &mut impl fmt::Write, raw: u64, from: ElementaryType) -> fmt::Result {
    let value = real::decode(raw, from);
    let sign = if value < 0.0 { "-" } else { "" };
    if value.is_nan() {
        return out.write_str("#NaN");
    }
    if value.is_infinite() {
        return write!(out, "{sign}#Inf");
    }
    let single = from == ElementaryType::Real;
    let (digits, exponent) = scaled_digits(value.abs(), single);
    let fixed = if single { -4..8 } else { 0..14 };
    if value == 0.0 || fixed.contains(&exponent) {
        return write!(out, "{sign}{}", with_point(&digits, exponent));
    }
    let (first, rest) = digits.split_at(1);
    match (single, rest) {
        (true, "") => write!(out, "{sign}{first}E")?,
        (true, rest) => write!(out, "{sign}{first}.{rest}E")?,
        (false, "") => return write!(out, "{sign}{first}.0e{exponent}"),
        (false, rest) => return write!(out, "{sign}{first}.{rest}e{exponent}"),
    }
    let minus = if exponent < 0 { "-" } else { "" };
    write!(out, "{minus}{:02}", exponent.unsigned_abs())
}

/// The significant digits of a number, none of the last ones zero, and the power of ten of the first.
fn scaled_digits(magnitude: f64, single: bool) -> (String, i32) {
    // More digits than any of the two types has: the exact number.
    let exact = format!("{magnitude:.800e}");
    let (mantissa, power) = exact.split_once('e').unwrap_or((&exact, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    let places = if single {
        // The logarithm to base 2, whole, and 10 / 33, about that of 2 to base 10.
        let binary = (magnitude.to_bits() >> 52).cast_signed() as i32 - 1023;
        6 - (binary * 10).div_euclid(33)
    } else {
        14 - power
    };
    let scaled = format!("{mantissa}e{}", power + places);
    let rounded = if single {
        f64::from(scaled.parse::<f32>().unwrap_or(0.0)).round()
    } else {
        scaled.parse::<f64>().unwrap_or(0.0).round()
    };
    let digits = format!("{rounded:.0}");
    let exponent = i32::try_from(digits.len()).unwrap_or(0) - 1 - places;
    match digits.trim_end_matches('0') {
        "" => ("0".to_owned(), 0),
        kept => (kept.to_owned(), exponent),
    }
}

/// Digits with a point and at least one digit on either side of it.
fn with_point(digits: &str, exponent: i32) -> String {
    let zeros = |count: i32| "0".repeat(count.max(0).unsigned_abs() as usize);
    let digits = zeros(-exponent) + digits;
    let whole = exponent.max(0).unsigned_abs() as usize + 1;
    let digits = format!("{digits:0<whole$}");
    match digits.split_at(whole) {
        (whole, "") => format!("{whole}.0"),
        (whole, fraction) => format!("{whole}.{fraction}"),
    }
}

/// A duration in its units, an LTIME without a sign: `T#1d2h`, `T#0ms`.
fn duration(out: &mut impl fmt::Write, raw: u64, from: ElementaryType) -> fmt::Result {
    let units = if from == ElementaryType::Time {
        &DURATION_UNITS[..5]
    } else {
        &DURATION_UNITS
    };
    out.write_str(prefix(from))?;
    let mut rest = raw;
    for (name, length) in units {
        if rest >= *length {
            write!(out, "{}{name}", rest / length)?;
            rest %= length;
        }
    }
    let (finest, length) = units[units.len() - 1];
    if raw < length {
        write!(out, "0{finest}")
    } else {
        Ok(())
    }
}

/// A date or time of day, with all digits of a fraction that is not zero.
fn date_or_time(out: &mut impl fmt::Write, raw: u64, from: ElementaryType) -> fmt::Result {
    let literal = Value::plain(from, raw).to_string();
    let (_, text) = literal.split_once('#').unwrap_or(("", &literal));
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    out.write_str(if from == ElementaryType::Ldate {
        "LD#"
    } else {
        prefix(from)
    })?;
    out.write_str(whole)?;
    match (fraction, from.is_third_edition()) {
        ("", _) => Ok(()),
        (fraction, true) => write!(out, ".{fraction:0<9}"),
        (fraction, false) => write!(out, ".{fraction:0<3.3}"),
    }
}

fn without_trailing_zeros(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

/// Returns a format, in code units, with the value in place of its first `{0[:specifier][precision]}`; the value itself where the format is
/// empty, and nothing in its place where the specifier is not of its type.
pub fn formatted(raw: u64, from: ElementaryType, format: &[u16]) -> Vec<u16> {
    let format = match format {
        [] => "{0}".to_owned(),
        _ => String::from_utf16_lossy(format),
    };
    let behind = format
        .split_once('{')
        .and_then(|(before, rest)| Some((before, rest.split_once('}')?)));
    let Some((before, (specification, after))) = behind else {
        return format.encode_utf16().collect();
    };
    let value = specified(raw, from, specification).unwrap_or_default();
    [before, &value, after].concat().encode_utf16().collect()
}

/// Returns a value by what stands in braces: I or nothing is its literal, D an integer or bit string in as many decimal digits, E or e a real
/// number with so many digits, or 6, behind its point. `None` where that is no specification, not of this type, or of more than 99 digits.
fn specified(raw: u64, from: ElementaryType, specification: &str) -> Option<String> {
    let specification = specification.strip_prefix('0')?;
    let mut letters = specification.trim_start_matches(':').chars();
    let specifier = letters.next().unwrap_or('I');
    let precision: Option<usize> = letters.as_str().parse().ok();
    let is_read = letters.as_str().is_empty() || precision.is_some_and(|digits| digits <= 99);
    match specifier.to_ascii_uppercase() {
        _ if !is_read => None,
        'I' => {
            let reals = RealText::SignificantDigits(if from == ElementaryType::Real { 7 } else { 15 });
            let text = write(raw, from, reals, BitStringText::FullWidth, MomentText::Literal);
            Some(text.replace("e+", "E+").replace("e-", "E-"))
        }
        'D' if from.is_whole() => {
            let number = from.integer_value(raw);
            let (sign, width) = (if number < 0 { "-" } else { "" }, precision.unwrap_or(1));
            Some(format!("{sign}{:0width$}", number.unsigned_abs()))
        }
        'E' if from.is_real() => {
            let number = format!("{:.*e}", precision.unwrap_or(6), real::decode(raw, from));
            let (mantissa, exponent) = number.split_once('e')?;
            let exponent: i32 = exponent.parse().ok()?;
            let sign = if exponent < 0 { '-' } else { '+' };
            Some(format!(
                "{mantissa}{specifier}{sign}{:02}",
                exponent.unsigned_abs()
            ))
        }
        _ => None,
    }
}
