//! The encoding of values as numbers in an array of `DINT`, for each type, and its decoding.
//!
//! `DINT` is the type that every compiler has and every watch list shows. The numbers are made by comparison, addition and
//! subtraction within the value's own type, never by a conversion: conversions are what is tested. What cannot be taken
//! apart in this way (a text, a character, a date, a time of day, the value of an enumeration) is only compared with the
//! value that it must have.
//!
//! | types | numbers |
//! |---|---|
//! | `BOOL` | 0 or 1 |
//! | `SINT`, `INT`, `DINT`, `USINT`, `UINT`, `BYTE`, `WORD` | the value |
//! | `UDINT`, `DWORD` | value div 2^24, value mod 2^24 |
//! | `LINT`, `ULINT`, `LWORD` | value div 2^48, value div 2^24 mod 2^24, value mod 2^24; each rounded down |
//! | `REAL` | exponent, significand: significand · 2^(exponent − 23); an exponent of 9999 is no number, one of 9998 infinite |
//! | `LREAL` | exponent, significand div 2^24, its magnitude mod 2^24: significand · 2^(exponent − 52) |
//! | `TIME`, `LTIME` | sign (and 2 where there was a rest), units div 2^48, div 2^24 mod 2^24, mod 2^24; a unit is 1 ms, 1 ns |
//!
//! The sign of a zero is not seen: a case that expects -0.0 is not exported, and -0.0 counts as 0.0 where that is expected.

use stickler_types::{ElementaryType, Family, Value};

/// The exponent that stands for NaN.
pub(crate) const NAN_EXPONENT: i32 = 9999;
/// The exponent that stands for the infinities.
pub(crate) const INFINITE_EXPONENT: i32 = 9998;
/// The number in place of the sign of a duration that has a part smaller than its unit, or that could not be taken apart.
pub(crate) const REST_SIGN: i32 = 2;

/// Returns the elementary type of which the numbers of a value are; `None` where there are none, since the page only compares the value
/// with the expected one.
pub(crate) fn encoded(type_name: &str) -> Option<ElementaryType> {
    ElementaryType::from_name(type_name).filter(|ty| pieces(*ty) > 0)
}

/// Returns the number of elements of the array that the numbers of a value take.
pub(crate) fn pieces(ty: ElementaryType) -> usize {
    match (ty.family(), ty.bits()) {
        (Family::Boolean, _) => 1,
        (Family::Signed, 64) | (Family::Unsigned | Family::BitString, 64) => 3,
        (Family::Unsigned | Family::BitString, 32) => 2,
        (Family::Signed | Family::Unsigned | Family::BitString, _) => 1,
        (Family::Real, 32) => 2,
        (Family::Real, _) => 3,
        (Family::Duration, _) => 4,
        _ => 0,
    }
}

/// A value decoded from the numbers in an array of results.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum DecodedValue {
    /// The numbers stand for this value.
    Value(Value),
    /// The numbers do not determine the value.
    Unknown,
    /// No page writes such numbers.
    Invalid,
}

/// Decodes the numbers of a value, which are as many as [`pieces`] returns.
pub(crate) fn decode(ty: ElementaryType, numbers: &[i32]) -> DecodedValue {
    let found = match ty.family() {
        Family::Real => real(ty, numbers),
        Family::Duration => return duration(ty, numbers),
        _ => whole(numbers)
            .filter(|number| ty.holds(*number))
            .map(|number| ty.wrap(number)),
    };
    found.map_or(DecodedValue::Invalid, |raw| {
        DecodedValue::Value(Value::plain(ty, raw))
    })
}

/// Combines digits to the base of 2^24, the first with the sign, into an integer; `None` where one is out of range.
fn whole(numbers: &[i32]) -> Option<i128> {
    let (first, rest) = numbers.split_first()?;
    rest.iter().try_fold(i128::from(*first), |sum, &number| {
        (0..1 << 24)
            .contains(&number)
            .then(|| (sum << 24) + i128::from(number))
    })
}

fn real(ty: ElementaryType, numbers: &[i32]) -> Option<u64> {
    let (&exponent, significand) = numbers.split_first()?;
    let negative = *significand.first()? < 0;
    let magnitudes: Vec<i32> = significand.iter().map(|number| number.saturating_abs()).collect();
    let magnitude = whole(&magnitudes)?;
    let digits = if ty == ElementaryType::Real { 24 } else { 53 };
    let sign = if negative { -1.0 } else { 1.0 };
    let value = match exponent {
        NAN_EXPONENT => f64::NAN,
        INFINITE_EXPONENT => sign * f64::INFINITY,
        _ if magnitude == 0 => 0.0,
        // The loops of a page leave significands whose highest bit is in one place.
        -1100..=1100 if magnitude >> (digits - 1) == 1 => sign * scaled(magnitude, exponent - (digits - 1)),
        _ => return None,
    };
    match ty {
        ElementaryType::Real => {
            #[expect(clippy::cast_possible_truncation, reason = "it is checked to lose nothing")]
            let single = value as f32;
            (value.is_nan() || f64::from(single) == value).then(|| u64::from(single.to_bits()))
        }
        _ => Some(value.to_bits()),
    }
}

/// Returns a number below 2^53 times a power of two, exactly where an `f64` holds the product.
fn scaled(magnitude: i128, exponent: i32) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "it has no more than 53 bits")]
    let mut value = magnitude as f64;
    // One step at a time never rounds twice: all of them but the last few are exact, and those that round lose bits of which a
    // significand that came from a value has none.
    for _ in 0..exponent.abs() {
        value = if exponent < 0 { value / 2.0 } else { value * 2.0 };
    }
    value
}

fn duration(ty: ElementaryType, numbers: &[i32]) -> DecodedValue {
    let Some((&sign, units)) = numbers.split_first() else {
        return DecodedValue::Invalid;
    };
    let sign = match sign {
        REST_SIGN => return DecodedValue::Unknown,
        -1 | 1 => i128::from(sign),
        _ => return DecodedValue::Invalid,
    };
    let unit = if ty == ElementaryType::Time { 1_000_000 } else { 1 };
    let nanoseconds = whole(units).map(|units| sign * units * unit);
    match nanoseconds.and_then(|number| i64::try_from(number).ok()) {
        Some(nanoseconds) => DecodedValue::Value(Value::plain(ty, nanoseconds.cast_unsigned())),
        None => DecodedValue::Invalid,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_for_values() {
        for row in include_str!("encoding.txt").lines().skip(1) {
            let (encoded, expected) = row.split_once(": ").expect("a colon");
            let (ty, numbers) = encoded.split_once(' ').expect("a type and numbers");
            let ty = ElementaryType::from_name(ty).expect("a type");
            let numbers: Vec<i32> = numbers
                .split(' ')
                .map(|number| number.parse().expect("a DINT"))
                .collect();
            assert_eq!(numbers.len(), pieces(ty), "{row}");
            let found = match decode(ty, &numbers) {
                DecodedValue::Value(value) => value.to_string(),
                other => format!("{other:?}"),
            };
            assert_eq!(found, expected, "{row}");
        }
    }
}
