//! Conversions of texts to values.

use super::literal::{Decimal, Digits, Integer, LiteralScanner};
use crate::calendar;
use crate::{integer, quotient, real};
use num_bigint::BigUint;
use stickler_types::{ConversionChoices, ElementaryType, Family, TextReading};

/// Returns the raw form of the value that a text spells in a type that is neither a text nor a character; 0 if it spells
/// none.
///
/// Blanks around the text are ignored. The rest may be:
///
/// | type | text |
/// |---|---|
/// | integers, bit strings | an integer in base 2, 8, 10 or 16, a decimal one perhaps behind a sign; taken modulo 2^n |
/// | BOOL | `TRUE` in any case, or an integer that is not 0 |
/// | REAL, LREAL | a decimal number, its fraction and its exponent at will, rounded once; `NaN`, `Infinity`, `-Infinity` in any case |
/// | durations, dates | a literal of the type that its 64 bits hold, the prefix of the type at will |
///
/// Single underscores may stand between digits. A number has no prefix: `INT#5` spells none.
///
/// Basis: forgeiec-conversion-functions: matiec conformance ("returns 0 on parse failure rather than raising"); which texts can
/// be read, beyond plain decimal numbers, no source says.
pub(crate) fn read(units: &[u16], to: ElementaryType, choices: &ConversionChoices) -> u64 {
    // No literal has a character that is not ASCII; 16#FF stands for all of those.
    let mut bytes: Vec<u8> = units
        .iter()
        .map(|&unit| u8::try_from(unit).unwrap_or(0xFF))
        .collect();
    let leading = match choices.text_reading {
        TextReading::LeadingDigits => leading_digits(&bytes, to),
        TextReading::LeadingFixedPoint => leading_fixed_point(&bytes, to),
        _ => None,
    };
    if let Some(value) = leading {
        return value;
    }
    if choices.text_reading == TextReading::LooseDigits {
        let first = bytes.iter().position(u8::is_ascii_digit).unwrap_or(0);
        let mut digits = bytes.split_off(first);
        bytes.retain(|&byte| byte != b' ');
        bytes.append(&mut digits);
        bytes.retain(|&byte| byte != b'_');
    }
    let text = trimmed(&bytes, choices.text_reading);
    let mut scanner = LiteralScanner::new(text);
    let value = match to.family() {
        Family::Boolean => whole(&mut scanner, |scanner| boolean(scanner).map(u64::from)),
        Family::Signed | Family::Unsigned | Family::BitString => number(&mut scanner, choices, |scanner| {
            let integer = Integer::read(scanner)?;
            let holds_all = [TextReading::WholeTextInRange, TextReading::LooseDigits];
            let is_outside = holds_all.contains(&choices.text_reading) && !is_held(&integer, to);
            (!is_outside).then(|| residue(integer, to))
        }),
        Family::Real => number(&mut scanner, choices, |scanner| real_number(scanner, to)),
        Family::Duration if choices.text_reading == TextReading::WholeLiteral && !text.contains(&b'#') => {
            None
        }
        Family::Duration => whole(behind_prefix(&mut scanner, text, to), duration),
        Family::Date => whole(behind_prefix(&mut scanner, text, to), |scanner| {
            nanoseconds(date(scanner)?, 0)
        }),
        Family::TimeOfDay => whole(behind_prefix(&mut scanner, text, to), |scanner| {
            nanoseconds(0, time_of_day(scanner)?)
        }),
        Family::DateAndTime => whole(behind_prefix(&mut scanner, text, to), date_and_time),
        Family::Text | Family::Character => None,
    };
    value.unwrap_or(0)
}

/// Returns the BOOL or number that decimal digits at the beginning spell, behind blanks and tabs; 0 if there are none, and `None` for other
/// types.
fn leading_digits(bytes: &[u8], to: ElementaryType) -> Option<u64> {
    let blanks = bytes
        .iter()
        .take_while(|byte| matches!(byte, b' ' | b'\t'))
        .count();
    let text = &bytes[blanks..];
    let mut scanner = LiteralScanner::new(text);
    match to.family() {
        Family::Boolean => Some(u64::from(text.starts_with(b"TRUE") || text.starts_with(b"true"))),
        Family::Signed | Family::Unsigned | Family::BitString => {
            let integer = Integer::read_decimal(&mut scanner);
            Some(integer.map_or(0, |integer| residue(integer, to)))
        }
        Family::Real => {
            let decimal = Decimal::read(&mut scanner, true);
            Some(decimal.map_or(0, |decimal| rounded(decimal, to)))
        }
        _ => None,
    }
}

/// Returns the number that a decimal number without an exponent at the beginning spells, behind blanks, and with commas before its point; an
/// integer is cut at the point, and 0 if the type does not hold it. `None` for types that are no numbers.
fn leading_fixed_point(bytes: &[u8], to: ElementaryType) -> Option<u64> {
    let blanks = bytes.iter().take_while(|&&byte| byte == b' ').count();
    let is_of_number = |byte: &&u8| byte.is_ascii_digit() || b",.+-".contains(byte);
    let text: Vec<u8> = bytes[blanks..].iter().take_while(is_of_number).copied().collect();
    let point = text.iter().position(|&byte| byte == b'.').unwrap_or(text.len());
    let commas = |(at, byte): &(usize, u8)| *byte != b',' || *at > point;
    let text: Vec<u8> = (0..).zip(text).filter(commas).map(|(_, byte)| byte).collect();
    if to.is_real() {
        return leading_digits(&text, to);
    }
    let integer =
        Integer::read_decimal(&mut LiteralScanner::new(&text)).filter(|integer| is_held(integer, to));
    to.is_integer()
        .then(|| integer.map_or(0, |integer| residue(integer, to)))
}

/// Returns the text without the blanks at either end, and without all that counts as white space where the choice is a literal.
fn trimmed(text: &[u8], reading: TextReading) -> &[u8] {
    let is_kept =
        |byte: &u8| *byte != b' ' && !(reading == TextReading::WholeLiteral && (9..=13).contains(byte));
    let start = text.iter().position(is_kept).unwrap_or(text.len());
    let end = text.iter().rposition(is_kept).map_or(start, |last| last + 1);
    &text[start..end]
}

/// Returns the value that `read` reads, if it consumes the text to its end.
fn whole<'t>(
    scanner: &mut LiteralScanner<'t>,
    read: impl Fn(&mut LiteralScanner<'t>) -> Option<u64>,
) -> Option<u64> {
    let value = read(scanner)?;
    scanner.is_at_end().then_some(value)
}

/// Returns the number that `read` reads: from the whole text, or from its beginning where the choices allow that.
fn number<'t>(
    scanner: &mut LiteralScanner<'t>,
    choices: &ConversionChoices,
    read: impl Fn(&mut LiteralScanner<'t>) -> Option<u64>,
) -> Option<u64> {
    match choices.text_reading {
        TextReading::WholeText
        | TextReading::WholeTextInRange
        | TextReading::WholeLiteral
        | TextReading::LooseDigits
        | TextReading::LeadingFixedPoint => whole(scanner, read),
        TextReading::LeadingNumber | TextReading::LeadingDigits => read(scanner),
    }
}

/// Skips the prefix of the type, if there is one.
fn behind_prefix<'s, 't>(
    scanner: &'s mut LiteralScanner<'t>,
    text: &'t [u8],
    to: ElementaryType,
) -> &'s mut LiteralScanner<'t> {
    if let Some(at) = text.iter().position(|&byte| byte == b'#')
        && let Ok(prefix) = str::from_utf8(&text[..at])
        && ElementaryType::from_literal_prefix(prefix) == Some(to)
    {
        *scanner = LiteralScanner::new(&text[at + 1..]);
    }
    scanner
}

/// Returns whether the type holds the integer.
fn is_held(integer: &Integer<'_>, to: ElementaryType) -> bool {
    let magnitude = integer.digits.values().fold(0_i128, |number, digit| {
        number
            .saturating_mul(integer.base.into())
            .saturating_add(digit.into())
    });
    to.holds(if integer.negative { -magnitude } else { magnitude })
}

/// Returns the integer modulo 2^n of the type.
fn residue(integer: Integer<'_>, to: ElementaryType) -> u64 {
    // What is left out by the overflow is a multiple of 2^64, and so of 2^n.
    let low = integer.digits.values().fold(0_u64, |number, digit| {
        number
            .wrapping_mul(integer.base.into())
            .wrapping_add(digit.into())
    });
    let value = i128::from(low);
    integer::wrapped(if integer.negative { -value } else { value }, to)
}

fn boolean(scanner: &mut LiteralScanner<'_>) -> Option<bool> {
    if scanner.word("TRUE").is_some() {
        return Some(true);
    }
    Integer::read(scanner).map(|integer| integer.digits.values().any(|digit| digit != 0))
}

fn real_number(scanner: &mut LiteralScanner<'_>, to: ElementaryType) -> Option<u64> {
    for (word, raw) in [
        ("NaN", real::not_a_number(to)),
        ("Infinity", real::infinite(false, to)),
        ("-Infinity", real::infinite(true, to)),
    ] {
        if scanner.word(word).is_some() {
            return Some(raw);
        }
    }
    Decimal::read(scanner, false).map(|decimal| rounded(decimal, to))
}

/// Returns the raw form nearest to a decimal number, ties to even, rounded once.
fn rounded(decimal: Decimal<'_>, to: ElementaryType) -> u64 {
    let mut digits: Vec<u8> = decimal.whole.values().collect();
    let mut exponent = decimal.exponent.map_or(0, |(negative, digits)| {
        if negative {
            -digits.saturated()
        } else {
            digits.saturated()
        }
    });
    if let Some(fraction) = decimal.fraction {
        let whole = digits.len();
        digits.extend(fraction.values());
        exponent = exponent.saturating_sub((digits.len() - whole) as i64);
    }
    nearest_decimal(decimal.negative, &digits, exponent, to)
}

/// Returns the raw form of the REAL or LREAL nearest to a decimal number or its negative, ties to even, rounded once: to the number that the
/// digits spell, times ten to the power of the exponent. Each digit is from 0 to 9. What is beyond the largest number becomes infinity.
pub fn nearest_decimal(negative: bool, digits: &[u8], exponent: i64, to: ElementaryType) -> u64 {
    // Beyond this power of ten all is infinity or zero.
    const FAR: i64 = 400;
    let zeros = digits.iter().take_while(|&&digit| digit == 0).count();
    let significant = &digits[zeros..];
    // The number is less than 10^point, and not less than a tenth of that.
    let point = exponent.saturating_add(significant.len() as i64);
    if significant.is_empty() || point < -FAR {
        return quotient::nearest(negative, &BigUint::ZERO, &BigUint::from(1_u32), to);
    }
    if point > FAR {
        return real::infinite(negative, to);
    }
    // Both within the length of the text and some hundred more.
    let magnitude = BigUint::from_radix_be(significant, 10).unwrap_or_default();
    let power = BigUint::from(10_u32).pow(exponent.unsigned_abs() as u32);
    if exponent < 0 {
        quotient::nearest(negative, &magnitude, &power, to)
    } else {
        quotient::nearest(negative, &(magnitude * power), &BigUint::from(1_u32), to)
    }
}

/// The units of time from the greatest to the least, with their nanoseconds.
pub(super) const UNITS: [(&str, u64); 7] = [
    ("d", 86_400_000_000_000),
    ("h", 3_600_000_000_000),
    ("m", 60_000_000_000),
    ("s", 1_000_000_000),
    ("ms", 1_000_000),
    ("us", 1_000),
    ("ns", 1),
];

/// Reads a duration literal without its prefix: `1d2h3.5s`, `-25h_15m`. Units go from the greatest to the least, and only
/// the last may have a fraction; fractions of a nanosecond are dropped.
fn duration(scanner: &mut LiteralScanner<'_>) -> Option<u64> {
    let negative = scanner.sign();
    let mut total = BigUint::ZERO;
    let mut units = &UNITS[..];
    loop {
        let whole = scanner.digits(10)?;
        let fraction = match scanner.any_of(b".") {
            Some(_) => Some(scanner.digits(10)?),
            None => None,
        };
        let letters = scanner.letters();
        let place = units
            .iter()
            .position(|(name, _)| name.as_bytes().eq_ignore_ascii_case(letters))?;
        let unit = units[place].1;
        units = &units[place + 1..];
        total += natural(whole) * unit;
        if let Some(fraction) = fraction {
            total += part(fraction, unit);
        }
        if fraction.is_some() || scanner.is_at_end() {
            break;
        }
        scanner.any_of(b"_");
    }
    let magnitude = i128::try_from(total).ok()?;
    let nanoseconds = i64::try_from(if negative { -magnitude } else { magnitude }).ok()?;
    Some(nanoseconds.cast_unsigned())
}

/// Returns the number that decimal digits spell.
fn natural(digits: Digits<'_>) -> BigUint {
    let values: Vec<u8> = digits.values().collect();
    BigUint::from_radix_be(&values, 10).unwrap_or_default()
}

/// Returns the whole part of `0.digits * unit`.
fn part(digits: Digits<'_>, unit: u64) -> BigUint {
    // No more than some thousands, or the text would not have fitted.
    let count = digits.values().count() as u32;
    natural(digits) * unit / BigUint::from(10_u32).pow(count)
}

/// Reads a date such as `2024-02-29`; returns the days since 1970.
fn date(scanner: &mut LiteralScanner<'_>) -> Option<i64> {
    let year = field(scanner, 0, 99_999)?;
    scanner.any_of(b"-")?;
    let month = field(scanner, 1, 12)?;
    scanner.any_of(b"-")?;
    let day = field(scanner, 1, calendar::days_of_month(year, month))?;
    Some(calendar::days_since_1970(year, month, day))
}

/// Reads a time of day such as `12:34:56.789`; returns the nanoseconds since midnight, without their fraction.
fn time_of_day(scanner: &mut LiteralScanner<'_>) -> Option<i64> {
    let hour = field(scanner, 0, 23)?;
    scanner.any_of(b":")?;
    let minute = field(scanner, 0, 59)?;
    scanner.any_of(b":")?;
    let second = field(scanner, 0, 59)?;
    let fraction = match scanner.any_of(b".") {
        Some(_) => i64::try_from(part(scanner.digits(10)?, 1_000_000_000)).ok()?,
        None => 0,
    };
    Some(((hour * 60 + minute) * 60 + second) * 1_000_000_000 + fraction)
}

fn date_and_time(scanner: &mut LiteralScanner<'_>) -> Option<u64> {
    let days = date(scanner)?;
    scanner.any_of(b"-")?;
    nanoseconds(days, time_of_day(scanner)?)
}

/// Reads a number from `least` to `greatest`, in any number of digits.
fn field(scanner: &mut LiteralScanner<'_>, least: i64, greatest: i64) -> Option<i64> {
    let number = scanner.digits(10)?.saturated();
    (least..=greatest).contains(&number).then_some(number)
}

/// Returns the raw form of a time on a day, if 64 bits hold it.
fn nanoseconds(days: i64, time: i64) -> Option<u64> {
    let nanoseconds = i128::from(days) * 86_400_000_000_000 + i128::from(time);
    i64::try_from(nanoseconds).ok().map(i64::cast_unsigned)
}
