//! Values read from texts.
//!
//! No source says which form a text must have. Here it is any literal of the type, with spaces around it and
//! with or without its prefix; a real number may lack its point; an integer outside the type's range wraps. A
//! dialect chooses whether what follows a number spoils it.
//!
//! Basis: forgeiec-conversion-functions: matiec conformance ("returns 0 on parse failure rather than raising").

use std::borrow::Cow;
use stickler_types::{ElementaryType, Family, LiteralError, TextReading, Value, literal};

/// Reads a text, in code units, as a value of the type; gives the raw form of zero where it cannot.
///
/// Takes time in proportion to the length of the text.
#[must_use]
pub fn read(units: &[u16], to: ElementaryType, reading: TextReading) -> u64 {
    let ascii = ascii_beginning(units);
    let whole = ascii.len() == units.len();
    if reading == TextReading::LeadingDigits && to.integer_range().is_some() | to.is_real() {
        return read_digits(ascii.trim_start_matches([' ', '\t']), to);
    }
    let text = ascii.trim_matches(' ');
    let number = |beginning: fn(&str) -> &str| match reading {
        TextReading::WholeText if whole => text,
        TextReading::WholeText => "",
        TextReading::LeadingNumber | TextReading::LeadingDigits => beginning(text),
    };
    match to.family() {
        Family::Signed | Family::Unsigned | Family::BitString => read_integer(number(leading_integer), to),
        Family::Real => read_real(number(leading_real), to),
        _ if !whole => 0,
        Family::Boolean => read_boolean(text),
        _ => read_moment(text, to),
    }
}

/// The text up to the first character that is not ASCII. Every literal is ASCII, so such a character spoils a
/// text that is read as a whole.
fn ascii_beginning(units: &[u16]) -> String {
    units
        .iter()
        .map_while(|&unit| u8::try_from(unit).ok().filter(u8::is_ascii).map(char::from))
        .collect()
}

/// A number or BOOL as [`TextReading::LeadingDigits`] describes it.
fn read_digits(text: &str, to: ElementaryType) -> u64 {
    let sign = sign_length(text);
    let whole = &text[sign..sign + digits_length(&text[sign..], 10)];
    if to == ElementaryType::Bool {
        return u64::from(text.starts_with("TRUE"));
    }
    if !to.is_real() {
        return read_integer(&text[..sign + whole.len()], to);
    }
    let behind = &text[sign + whole.len()..];
    let fraction = behind.strip_prefix('.').unwrap_or("");
    let fraction = &fraction[..digits_length(fraction, 10)];
    if whole.is_empty() && fraction.is_empty() {
        return 0;
    }
    let point = usize::from(behind.starts_with('.'));
    let exponent = behind[point + fraction.len()..]
        .strip_prefix(['e', 'E'])
        .unwrap_or("");
    let power_sign = sign_length(exponent);
    let power = match digits_length(&exponent[power_sign..], 10) {
        0 => String::new(),
        length => format!("E{}", &exponent[..power_sign + length]),
    };
    let filled = |digits: &str| {
        if digits.is_empty() {
            "0".to_owned()
        } else {
            digits.to_owned()
        }
    };
    read_real(
        &format!("{}{}.{}{power}", &text[..sign], filled(whole), filled(fraction)),
        to,
    )
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

#[cfg(test)]
mod tests {
    use super::super::writing::write;
    use super::*;
    use ElementaryType::{
        Bool, Byte, Date, Dt, Dword, Int, Lreal, Ltime, Lword, Real, Sint, Time, Tod, Udint, Word,
    };
    use stickler_types::{BitStringText, MomentText, RealText};

    fn units(text: &str) -> Vec<u16> {
        text.encode_utf16().collect()
    }

    fn whole(text: &str, to: ElementaryType) -> u64 {
        read(&units(text), to, TextReading::WholeText)
    }

    fn leading(text: &str, to: ElementaryType) -> u64 {
        read(&units(text), to, TextReading::LeadingNumber)
    }

    fn read_back(raw: u64, ty: ElementaryType) -> u64 {
        let text = write(
            raw,
            ty,
            RealText::Shortest,
            BitStringText::FullWidth,
            MomentText::Literal,
        );
        read(&text, ty, TextReading::WholeText)
    }

    #[test]
    fn integers_are_read_with_spaces_sign_underscores_and_base() {
        assert_eq!(whole("  -1_000 ", Int), (-1000_i64).cast_unsigned());
        assert_eq!(whole("+5", Int), 5);
        assert_eq!(whole("16#FF", Byte), 255);
    }

    #[test]
    fn integers_outside_the_range_wrap() {
        assert_eq!(whole("200", Sint), (-56_i64).cast_unsigned());
        assert_eq!(whole("-1", Udint), 0xFFFF_FFFF);
        // 2^128 + 5, and its like in base 16, are beyond the numbers that a literal can have.
        assert_eq!(whole("340282366920938463463374607431768211461", Int), 5);
        assert_eq!(
            whole("-340282366920938463463374607431768211461", Sint),
            u64::MAX - 4
        );
        assert_eq!(whole(&format!("16#1{}A", "0".repeat(40)), Lword), 10);
        assert_eq!(whole(&"9".repeat(60), Bool), 1);
        assert_eq!(whole(&("9".repeat(60) + "x"), Bool), 0);
    }

    #[test]
    fn what_is_no_number_gives_zero() {
        for unreadable in [
            "", " ", "abc", "12abc", "1 2", "--1", "1.5", "0x10", "16#", "5é", "\u{0}",
        ] {
            assert_eq!(whole(unreadable, Int), 0, "{unreadable:?}");
            assert_eq!(whole(unreadable, Time), 0, "{unreadable:?}");
        }
        assert_eq!(whole("abc", Lreal), 0);
    }

    #[test]
    fn reals_are_rounded_once_to_their_own_width() {
        // Half a unit above 1.0 in REAL, and a little more: by way of LREAL it would round to even, down.
        let above_half = "1.000000059604644775390626";
        assert_eq!(
            whole(above_half, Real),
            u64::from((1.0_f32 + f32::EPSILON).to_bits())
        );
        assert_eq!(whole("5", Lreal), 5.0_f64.to_bits());
        assert_eq!(whole("1e3", Lreal), 1000.0_f64.to_bits());
        assert_eq!(whole("-0.0", Lreal), (-0.0_f64).to_bits());
        assert_eq!(whole("-1E999", Lreal), f64::NEG_INFINITY.to_bits());
    }

    #[test]
    fn booleans_are_read_as_word_or_number() {
        assert_eq!(
            [1, 1, 1, 0, 0, 0],
            ["TRUE", "true", "2", "FALSE", "0", "yes"].map(|t| whole(t, Bool))
        );
    }

    #[test]
    fn what_is_written_is_read_back() {
        let raws = [0, 1, 5_000_000_000, 86_399_999_000_000];
        for ty in [Bool, Byte, Int, Udint, Time, Ltime, Tod, Dt] {
            for raw in raws.map(|raw| crate::raw::narrow(raw, ty)) {
                assert_eq!(read_back(raw, ty), raw, "{raw} as {}", ty.name());
            }
        }
        for value in [
            0.1,
            -0.0,
            1e300,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MIN_POSITIVE,
        ] {
            assert_eq!(read_back(value.to_bits(), Lreal), value.to_bits());
        }
    }

    #[test]
    fn a_number_at_the_beginning_counts_where_that_is_chosen() {
        let minus = |value: i64| (-value).cast_unsigned();
        for (text, value) in [
            ("12abc", 12),
            ("  -7 ", minus(7)),
            ("+5+", 5),
            ("1_0_x", 10),
            ("1__0", 1),
            ("16#1Fg", 31),
            ("16#", 16),
            ("8#178", 15),
            ("2#12", 1),
            ("3.9", 3),
            ("5é6", 5),
            ("-16#5", minus(16)),
            ("", 0),
            ("x1", 0),
            ("- 1", 0),
            ("_1", 0),
        ] {
            assert_eq!(leading(text, Int), value, "{text:?}");
        }
        assert_eq!(leading("300 pieces", Byte), 44);
    }

    #[test]
    fn a_real_number_at_the_beginning_counts_where_that_is_chosen() {
        for (text, value) in [
            ("1.5V", 1.5),
            ("-2", -2.0),
            ("3.", 3.0),
            ("3.e5", 3.0),
            ("4e2x", 400.0),
            ("4e", 4.0),
            ("4e+", 4.0),
            ("4e-1-", 0.4),
            ("infinity!", f64::INFINITY),
            ("-Infinity", f64::NEG_INFINITY),
            ("1E999 much", f64::INFINITY),
            (".5", 0.0),
            ("e5", 0.0),
        ] {
            assert_eq!(f64::from_bits(leading(text, Lreal)), value, "{text:?}");
        }
        assert!(f64::from_bits(leading("NaNa", Lreal)).is_nan());
    }

    #[test]
    fn what_is_no_number_is_read_whole_whatever_is_chosen() {
        assert_eq!(
            [leading("TRUE", Bool), leading("TRUEx", Bool), leading("1x", Bool)],
            [1, 0, 0]
        );
        assert_eq!(
            [leading("T#1s", Time), leading("T#1s!", Time)],
            [1_000_000_000, 0]
        );
        assert_eq!([leading("D#1970-01-02x", Date), leading("T#1sé", Time)], [0, 0]);
    }

    #[test]
    fn long_texts_are_read() {
        let zeros = "0".repeat(65_534);
        let nines = "9".repeat(65_535);
        for reading in [whole, leading] {
            assert_eq!(reading(&format!("{zeros}7"), Dword), 7);
            assert_eq!(
                reading(&nines, Lword),
                u64::MAX,
                "no part of 10^65535 is left but -1"
            );
            assert_eq!(reading(&nines, Lreal), f64::INFINITY.to_bits());
            assert_eq!(reading(&format!("0.{}", &zeros[2..]), Real), 0);
            assert_eq!(reading(&"_".repeat(65_535), Word), 0);
            assert_eq!(reading(&" ".repeat(65_535), Time), 0);
        }
    }
}
