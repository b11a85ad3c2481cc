//! Values as text and back.
//!
//! No source says which form a text has. Here it is the form that the wire protocol gives the value, without
//! the type's name where a program could not read it back with it: `-5`, `16#00FF`, `0.1`, `TRUE`, `T#1500ms`,
//! `D#2024-02-29`, `TOD#12:34:56`, `DT#2024-02-29-12:34:56`. Reading takes any literal of the type, with
//! spaces around it and with or without its prefix; an integer outside the type's range wraps.
//!
//! Basis: forgeiec-conversion-functions: matiec conformance ("returns 0 on parse failure rather than raising").

use std::borrow::Cow;
use std::fmt;
use stickler_types::{ElementaryType, Family, LiteralError, Value, literal};

/// Stands for a character that STRING and CHAR do not have.
const REPLACEMENT: u16 = b'?' as u16;

/// Reads a text, in code units, as a value of the type; gives the raw form of zero where it cannot.
#[must_use]
pub fn read(units: &[u16], to: ElementaryType) -> u64 {
    let Some(text) = ascii(units) else { return 0 };
    let text = text.trim_matches(' ');
    match to.family() {
        Family::Boolean => read_boolean(text),
        Family::Signed | Family::Unsigned | Family::BitString => {
            literal::integer(text).map_or(0, |value| to.wrap(value))
        }
        Family::Real => read_real(text, to),
        _ => read_moment(text, to),
    }
}

/// The text where all its characters are ASCII, as those of every literal are.
fn ascii(units: &[u16]) -> Option<String> {
    units
        .iter()
        .map(|&unit| u8::try_from(unit).ok().filter(u8::is_ascii).map(char::from))
        .collect()
}

/// TRUE in any case, or a number that is not 0.
fn read_boolean(text: &str) -> u64 {
    u64::from(text.eq_ignore_ascii_case("TRUE") || literal::integer(text).is_ok_and(|value| value != 0))
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
    plain(behind_prefix, to)
}

/// What stands behind a type's prefix, read by the one reader of typed literals.
fn plain(text: &str, to: ElementaryType) -> u64 {
    match Value::parse(&format!("{}#{text}", to.name())) {
        Ok(Value::Plain { raw, .. }) => raw,
        _ => 0,
    }
}

/// Writes a value as text, in code units.
#[must_use]
pub fn write(raw: u64, from: ElementaryType) -> Vec<u16> {
    let mut text = Units(Vec::new());
    let written = fmt::write(&mut text, format_args!("{}", Value::plain(from, raw)));
    debug_assert!(written.is_ok(), "a vector takes everything");
    let behind_prefix = text
        .0
        .iter()
        .position(|&unit| unit == u16::from(b'#'))
        .map_or(0, |at| at + 1);
    text.0
        .splice(..behind_prefix, prefix(from).bytes().map(u16::from));
    text.0
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

/// Code units to be written to; all that is written is ASCII.
struct Units(Vec<u16>);

impl fmt::Write for Units {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.extend(text.bytes().map(u16::from));
        Ok(())
    }
}

/// A character of either width as CHAR, where it may have to be replaced, or as WCHAR.
#[must_use]
pub fn character(raw: u64, to: ElementaryType) -> u64 {
    let narrow = matches!(to, ElementaryType::Char | ElementaryType::String);
    if narrow && raw > 0xFF {
        REPLACEMENT.into()
    } else {
        raw
    }
}

/// The text that consists of one character.
#[must_use]
pub fn of_character(raw: u64, to: ElementaryType) -> Vec<u16> {
    // A character's raw form has 16 bits at most.
    vec![character(raw, to) as u16]
}

/// A text of either width as STRING, where characters may have to be replaced, or as WSTRING.
#[must_use]
pub fn between(units: &[u16], to: ElementaryType) -> Vec<u16> {
    units
        .iter()
        .map(|&unit| character(unit.into(), to) as u16)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Bool, Byte, Date, Dt, Int, Lreal, Ltime, Lword, Real, Sint, Time, Tod, Udint};

    fn units(text: &str) -> Vec<u16> {
        text.encode_utf16().collect()
    }

    fn text(raw: u64, ty: ElementaryType) -> String {
        String::from_utf16_lossy(&write(raw, ty))
    }

    #[test]
    fn integers_are_read_with_spaces_sign_underscores_and_base() {
        assert_eq!(read(&units("  -1_000 "), Int), (-1000_i64).cast_unsigned());
        assert_eq!(read(&units("+5"), Int), 5);
        assert_eq!(read(&units("16#FF"), Byte), 255);
    }

    #[test]
    fn integers_outside_the_range_wrap() {
        assert_eq!(read(&units("200"), Sint), (-56_i64).cast_unsigned());
        assert_eq!(read(&units("-1"), Udint), 0xFFFF_FFFF);
    }

    #[test]
    fn what_is_no_number_gives_zero() {
        for unreadable in [
            "", " ", "abc", "12abc", "1 2", "--1", "1.5", "0x10", "16#", "5é", "\u{0}",
        ] {
            assert_eq!(read(&units(unreadable), Int), 0, "{unreadable:?}");
            assert_eq!(read(&units(unreadable), Time), 0, "{unreadable:?}");
        }
        assert_eq!(read(&units("abc"), Lreal), 0);
    }

    #[test]
    fn reals_are_rounded_once_to_their_own_width() {
        // Half a unit above 1.0 in REAL, and a little more: by way of LREAL it would round to even, down.
        let above_half = "1.000000059604644775390626";
        assert_eq!(
            read(&units(above_half), Real),
            (1.0_f32 + f32::EPSILON).to_bits().into()
        );
        assert_eq!(read(&units("5"), Lreal), 5.0_f64.to_bits());
        assert_eq!(read(&units("1e3"), Lreal), 1000.0_f64.to_bits());
        assert_eq!(read(&units("-0.0"), Lreal), (-0.0_f64).to_bits());
        assert_eq!(read(&units("-1E999"), Lreal), f64::NEG_INFINITY.to_bits());
    }

    #[test]
    fn booleans_are_read_as_word_or_number() {
        assert_eq!(
            [1, 1, 1, 0, 0, 0],
            ["TRUE", "true", "2", "FALSE", "0", "yes"].map(|t| read(&units(t), Bool))
        );
    }

    #[test]
    fn values_are_written_as_literals() {
        assert_eq!(text((-5_i64).cast_unsigned(), Int), "-5");
        assert_eq!(text(255, Lword), "16#00000000000000FF");
        assert_eq!(text(1, Bool), "TRUE");
        assert_eq!(text(0.1_f32.to_bits().into(), Real), "0.1");
        assert_eq!(text(1_500_000_000, Time), "T#1500ms");
        assert_eq!(text(1_500_000_000, Ltime), "LTIME#1500000000ns");
        assert_eq!(text(19_782 * 86_400_000_000_000, Date), "D#2024-02-29");
    }

    #[test]
    fn what_is_written_is_read_back() {
        let raws = [0, 1, 5_000_000_000, 86_399_999_000_000];
        for ty in [Bool, Byte, Int, Udint, Time, Ltime, Tod, Dt] {
            for raw in raws.map(|raw| crate::raw::narrow(raw, ty)) {
                assert_eq!(read(&write(raw, ty), ty), raw, "{raw} as {}", ty.name());
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
            assert_eq!(read(&write(value.to_bits(), Lreal), Lreal), value.to_bits());
        }
    }

    #[test]
    fn a_character_that_string_lacks_is_replaced() {
        assert_eq!(between(&units("aé€"), ElementaryType::String), units("aé?"));
        assert_eq!(between(&units("aé€"), ElementaryType::Wstring), units("aé€"));
    }
}
