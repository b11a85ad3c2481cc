//! Properties of conversions to texts and back.

use super::draw::{conversion, dialects, each, number, one_of, raw, same};
use arbitrary::Unstructured;
use stickler_types::ElementaryType::{self, Lreal, Real, String, Wstring};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ConversionChoices, MomentText, RealText, TextReading};
use stickler_types::{Dialect, DialectName};

/// Writes a value as a text and reads it again; returns the code units and the raw form.
fn written_and_read(
    dialect: &Dialect,
    ty: ElementaryType,
    text: ElementaryType,
    raw: u64,
) -> (std::string::String, u64) {
    let write = conversion(ty, text, dialect).expect("every type is written");
    let read = conversion(text, ty, dialect).expect("every type is read");
    let units = write.apply_to_text(raw);
    (
        std::string::String::from_utf16_lossy(&units),
        read.apply_from_text(&units),
    )
}

#[test]
fn what_is_written_is_read_back() {
    for dialect in dialects() {
        // One reading knows no exponents.
        let shortest = dialect.conversions.real_text == RealText::Shortest
            && dialect.conversions.text_reading != TextReading::LeadingFixedPoint;
        // Other forms drop what is finer than the unit of the type.
        let literal = dialect.conversions.moment_text == MomentText::Literal;
        let types: Vec<_> = ElementaryType::ALL
            .into_iter()
            .filter(|&ty| dialect.has(ty) && !ty.is_text() && (shortest || !ty.is_real()))
            .filter(|&ty| literal || !ty.is_moment())
            .collect();
        each(11, 40_000, |draw| {
            let ty = one_of(draw, &types)?;
            let text = match ty {
                // A STRING holds no wide character.
                ElementaryType::Wchar => Wstring,
                _ => one_of(draw, &[String, Wstring])?,
            };
            let value = raw(draw, ty)?;
            let (written, read) = written_and_read(dialect, ty, text, value);
            assert!(
                same(read, value, ty),
                "{}: {value:#x} of {ty}, written {written:?}, is read as {read:#x}",
                dialect.name
            );
            Ok(())
        });
    }
}

#[test]
fn seventeen_digits_are_enough_for_every_real() {
    let dialect = Dialect {
        conversions: ConversionChoices {
            real_text: RealText::SignificantDigits(17),
            ..COMMON_CHOICES
        },
        ..Dialect::of(DialectName::MATIEC).clone()
    };
    each(12, 20_000, |draw| {
        let ty = one_of(draw, &[Real, Lreal])?;
        let value = raw(draw, ty)?;
        let (written, read) = written_and_read(&dialect, ty, String, value);
        assert!(
            same(read, value, ty),
            "{value:#x} of {ty}, written {written:?}, is read as {read:#x}"
        );
        Ok(())
    });
}

#[test]
fn fewer_digits_are_off_by_half_of_the_last_at_most() {
    each(13, 20_000, |draw| {
        let digits = draw.int_in_range(1..=16)?;
        let dialect = Dialect {
            conversions: ConversionChoices {
                real_text: RealText::SignificantDigits(digits),
                ..COMMON_CHOICES
            },
            ..Dialect::of(DialectName::MATIEC).clone()
        };
        let value = raw(draw, Lreal)?;
        let exact = number(value, Lreal);
        // Subnormal numbers have fewer digits of their own, and the greatest ones are rounded to infinity.
        if !(1e-290..1e300).contains(&exact.abs()) {
            return Ok(());
        }
        let (written, read) = written_and_read(&dialect, Lreal, String, value);
        let error = ((number(read, Lreal) - exact) / exact).abs();
        let allowed = 0.5 * 10_f64.powi(1 - i32::from(digits)) * (1.0 + 1e-9) + f64::EPSILON;
        assert!(error <= allowed, "{exact:?} with {digits} digits is {written}");
        let significant = written.split(['e', 'E']).next().unwrap_or_default();
        let significant = significant.trim_start_matches(['-', '0', '.']).replace('.', "");
        assert!(
            significant.trim_end_matches('0').len() <= digits.into(),
            "{written} has more than {digits} digits"
        );
        Ok(())
    });
}

/// A text that looks more or less like a number, without a digit 0, so that a number in it is not 0.
fn number_like(draw: &mut Unstructured<'_>) -> arbitrary::Result<std::string::String> {
    const PARTS: [&str; 19] = [
        "1", "7", "12", "9", "_", ".", "-", "+", "e", "E5", "16#", "2#", "F", " ", "x", "#", "Infinity", "é",
        "3.5",
    ];
    let count = draw.int_in_range(0..=8)?;
    (0..count).map(|_| one_of(draw, &PARTS)).collect()
}

#[test]
fn a_leading_number_is_the_longest_beginning_that_is_one() {
    let reading = |text_reading| Dialect {
        conversions: ConversionChoices {
            text_reading,
            ..COMMON_CHOICES
        },
        ..Dialect::of(DialectName::IRONPLC_ED3).clone()
    };
    let (whole, leading) = (
        reading(TextReading::WholeText),
        reading(TextReading::LeadingNumber),
    );
    each(14, 60_000, |draw| {
        let text = number_like(draw)?;
        let to = one_of(draw, &[ElementaryType::Lint, ElementaryType::Lword, Lreal])?;
        let read = |dialect: &Dialect, units: &[u16]| {
            let conversion = conversion(String, to, dialect).expect("a function");
            conversion.apply_from_text(units)
        };
        let units: Vec<u16> = text.encode_utf16().collect();
        let mut beginnings = (0..=units.len()).rev().map(|end| read(&whole, &units[..end]));
        let expected = beginnings.find(|&value| value != 0).unwrap_or(0);
        let too_small = to == Lreal && text.to_lowercase().contains("e-");
        assert!(
            too_small || read(&leading, &units) == expected,
            "{text:?} as {to}: {:#x}, not {expected:#x}",
            read(&leading, &units)
        );
        Ok(())
    });
}
