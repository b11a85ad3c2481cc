//! Values read from texts.
//!
//! No source says which form a text must have. Here it is any literal of the type, with spaces around it and
//! with or without its prefix; a real number may lack its point; an integer outside the type's range wraps. A
//! dialect chooses whether what follows a number spoils it.
//!
//! Basis: forgeiec-conversion-functions: matiec conformance ("returns 0 on parse failure rather than raising").

use std::borrow::Cow;
use stickler_types::{ElementaryType, Family, LiteralError, TextReading, Value, literal};

/// Reads a text, in code units, as a value of the type; gives the raw form of zero where it cannot, or `None` by [`TextReading::LooseDigits`].
///
/// Takes time in proportion to the length of the text.
pub fn spelled(units: &[u16], to: ElementaryType, reading: TextReading) -> Option<u64> {
    // Every literal is ASCII, so another character spoils a text that is read as a whole.
    let letters = units
        .iter()
        .map_while(|&unit| u8::try_from(unit).ok().filter(u8::is_ascii));
    let ascii: String = letters.map(char::from).collect();
    let whole = ascii.len() == units.len();
    if reading == TextReading::LeadingDigits && to.integer_range().is_some() | to.is_real() {
        return Some(read_digits(ascii.trim_start_matches([' ', '\t']), to));
    }
    if reading == TextReading::LeadingFixedPoint && to.is_integer() | to.is_real() {
        return Some(read_fixed_point(ascii.trim_start_matches(' '), to));
    }
    let bare: Cow<'_, str> = match reading {
        TextReading::LooseDigits => {
            let (before, digits) = ascii.split_at(ascii.find(|c: char| c.is_ascii_digit()).unwrap_or(0));
            (before.replace([' ', '_'], "") + &digits.replace('_', "")).into()
        }
        _ => ascii.as_str().into(),
    };
    let text = match reading {
        TextReading::WholeLiteral => bare.trim_matches(['\t', '\n', '\x0B', '\x0C', '\r', ' ']),
        _ => bare.trim_matches(' '),
    };
    let number = |beginning: fn(&str) -> &str| match reading {
        TextReading::LeadingNumber | TextReading::LeadingDigits => beginning(text),
        _ if whole => text,
        _ => "",
    };
    let is_loose = reading == TextReading::LooseDigits;
    Some(match to.family() {
        Family::Signed | Family::Unsigned | Family::BitString => {
            let text = number(leading_integer);
            match reading {
                TextReading::LooseDigits if !is_in_range(text, to) => return None,
                TextReading::WholeTextInRange if !is_in_range(text, to) => 0,
                _ => read_integer(text, to),
            }
        }
        Family::Real => match number(leading_real) {
            text if is_loose && (text.is_empty() || text != leading_real(text)) => return None,
            text => read_real(text, to),
        },
        _ if !whole => 0,
        Family::Boolean => read_boolean(text),
        Family::Duration if reading == TextReading::WholeLiteral && !text.contains('#') => 0,
        _ => read_moment(text, to),
    })
}

/// An integer or a real number as [`TextReading::LeadingFixedPoint`] describes it.
fn read_fixed_point(text: &str, to: ElementaryType) -> u64 {
    let is_other = |character: char| !character.is_ascii_digit() && !",.+-".contains(character);
    let text = &text[..text.find(is_other).unwrap_or(text.len())];
    let (whole, fraction) = text.split_at(text.find('.').unwrap_or(text.len()));
    let number = whole.replace(',', "") + fraction;
    let is_outside = to.is_integer() && !is_in_range(leading_integer(&number), to);
    if is_outside { 0 } else { read_digits(&number, to) }
}

/// A number or BOOL as [`TextReading::LeadingDigits`] describes it.
fn read_digits(text: &str, to: ElementaryType) -> u64 {
    let sign = sign_length(text);
    let whole = &text[sign..sign + digits_length(&text[sign..], 10)];
    if to == ElementaryType::Bool {
        return u64::from(["TRUE", "true"].iter().any(|word| text.starts_with(word)));
    }
    if !to.is_real() {
        return read_integer(&text[..sign + whole.len()], to);
    }
    let behind = &text[sign + whole.len()..];
    let (fraction, behind) = match behind.strip_prefix('.') {
        Some(rest) => rest.split_at(digits_length(rest, 10)),
        None => ("", behind),
    };
    if whole.is_empty() && fraction.is_empty() {
        return 0;
    }
    let exponent = Some(behind).filter(|behind| behind.starts_with(['e', 'E']));
    let exponent = exponent.unwrap_or_default();
    // The zeros change no number, and stand where there are no digits.
    let number = format!("{}0{whole}.{fraction}0{exponent}", &text[..sign]);
    read_real(leading_real(&number), to)
}

/// The longest beginning that is an integer literal, perhaps with a sign; empty where there is none.
fn leading_integer(text: &str) -> &str {
    for (base, prefix) in [(16, "16#"), (8, "8#"), (2, "2#")] {
        if let Some(digits) = text.strip_prefix(prefix)
            && let length @ 1.. = digits_length(digits, base)
        {
            return &text[..prefix.len() + length];
        }
    }
    let sign = sign_length(text);
    match digits_length(&text[sign..], 10) {
        0 => "",
        length => &text[..sign + length],
    }
}

/// The longest beginning that is a real number as [`read_real`] takes it; empty where there is none.
fn leading_real(text: &str) -> &str {
    for word in ["NaN", "Infinity", "-Infinity"] {
        let beginning = text.get(..word.len());
        if let Some(found) = beginning.filter(|found| found.eq_ignore_ascii_case(word)) {
            return found;
        }
    }
    let sign = sign_length(text);
    let mut end = match digits_length(&text[sign..], 10) {
        0 => return "",
        length => sign + length,
    };
    if let Some(fraction) = text[end..].strip_prefix('.')
        && let length @ 1.. = digits_length(fraction, 10)
    {
        end += 1 + length;
    }
    if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
        let sign = sign_length(exponent);
        if let length @ 1.. = digits_length(&exponent[sign..], 10) {
            end += 1 + sign + length;
        }
    }
    &text[..end]
}

fn sign_length(text: &str) -> usize {
    usize::from(text.starts_with(['+', '-']))
}

/// Counts the bytes at the beginning that are digits of a base, single underscores between them counted.
fn digits_length(text: &str, base: u32) -> usize {
    let digit = |byte: Option<&u8>| byte.is_some_and(|&byte| char::from(byte).is_digit(base));
    let bytes = text.as_bytes();
    let mut end = 0;
    while digit(bytes.get(end)) || (end > 0 && bytes.get(end) == Some(&b'_') && digit(bytes.get(end + 1))) {
        end += 1;
    }
    end
}

/// Returns whether the target holds an integer literal.
fn is_in_range(text: &str, to: ElementaryType) -> bool {
    literal::integer(text).is_ok_and(|number| to.holds(number))
}

/// An integer literal modulo 2^n of the target, however many digits it has.
fn read_integer(text: &str, to: ElementaryType) -> u64 {
    match literal::integer(text) {
        Ok(value) => to.wrap(value),
        Err(LiteralError::Overflow { .. }) => to.wrap(low_bits(text).into()),
        Err(_) => 0,
    }
}

/// The number of an integer literal modulo 2^64.
fn low_bits(text: &str) -> u64 {
    let based = [(16, "16#"), (8, "8#"), (2, "2#")]
        .into_iter()
        .find_map(|(base, prefix)| Some((base, text.strip_prefix(prefix)?)));
    let (base, digits) = based.unwrap_or((10, text));
    let digits = digits.chars().filter_map(|digit| digit.to_digit(base));
    let magnitude = digits.fold(0_u64, |value, digit| {
        value.wrapping_mul(base.into()).wrapping_add(digit.into())
    });
    if text.starts_with('-') {
        magnitude.wrapping_neg()
    } else {
        magnitude
    }
}

/// TRUE in any case, or a number that is not 0.
fn read_boolean(text: &str) -> u64 {
    let is_not_zero = match literal::integer(text) {
        Ok(value) => value != 0,
        // Beyond 128 bits lies no 0.
        Err(error) => matches!(error, LiteralError::Overflow { .. }),
    };
    u64::from(is_not_zero || text.eq_ignore_ascii_case("TRUE"))
}

/// A real literal; `5` and `5E3` too, which are none in a program; the words that are no numbers; and what is
/// too big, as the infinity that it rounds to.
fn read_real(text: &str, to: ElementaryType) -> u64 {
    let text = with_point(text);
    match literal::real(&text, to) {
        Ok(raw) => raw,
        Err(LiteralError::Overflow { .. }) if text.starts_with('-') => plain("-Infinity", to),
        Err(LiteralError::Overflow { .. }) => plain("Infinity", to),
        Err(_) => plain(&text, to),
    }
}

fn with_point(text: &str) -> Cow<'_, str> {
    let digits = text.find(['e', 'E']).unwrap_or(text.len());
    let (mantissa, exponent) = text.split_at(digits);
    if mantissa.ends_with(|last: char| last.is_ascii_digit()) && !mantissa.contains('.') {
        Cow::Owned(format!("{mantissa}.0{exponent}"))
    } else {
        Cow::Borrowed(text)
    }
}

/// A duration, date or time of day, its prefix at will.
fn read_moment(text: &str, to: ElementaryType) -> u64 {
    let behind_prefix = match text.split_once('#') {
        Some((prefix, rest)) if ElementaryType::from_literal_prefix(prefix) == Some(to) => rest,
        Some(_) => return 0,
        None => text,
    };
    let nanoseconds = match to.family() {
        Family::Duration => literal::duration(behind_prefix),
        Family::Date => literal::date(behind_prefix),
        Family::TimeOfDay => literal::time_of_day(behind_prefix),
        _ => literal::date_and_time(behind_prefix),
    };
    nanoseconds.map_or(0, i64::cast_unsigned)
}

/// Reads the text behind a type's prefix with the one reader of typed literals.
fn plain(text: &str, to: ElementaryType) -> u64 {
    match Value::parse(&format!("{}#{text}", to.name())) {
        Ok(Value::Plain { raw, .. }) => raw,
        _ => 0,
    }
}
