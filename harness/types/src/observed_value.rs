//! Values as engines give them: durations and dates that 64 bits of nanoseconds do not hold, and texts that are too long.

use crate::elementary::ElementaryType;
use crate::literal::{LiteralError, wide_duration};
use crate::value::Value;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::borrow::Cow;

/// The maximum number of bytes of a value that an engine gives, so that reports stay small whatever it prints. A `STRING` of 5000
/// characters that are all written as escapes fits.
const MAX_OBSERVED_LEN: usize = 16 << 10;

impl Value {
    /// Returns the duration, date or time of day with this number of nanoseconds, which a compiler may keep in more than 64 bits.
    pub fn of_nanoseconds(ty: ElementaryType, nanoseconds: i128) -> Value {
        match i64::try_from(nanoseconds) {
            Ok(within) => Value::plain(ty, within.cast_unsigned()),
            Err(_) => Value::OutOfRange { ty, nanoseconds },
        }
    }

    /// Parses the spelling of a value that an engine observed: what [`Value::parse`] reads, and a duration, date or time of day
    /// out of the range of 64 bits, `TIME#9223372036854775808000ns`. No program and no expectation has such a value.
    ///
    /// # Errors
    /// As [`Value::parse`]; and [`LiteralError::Malformed`] for a text of more than 16 KiB.
    pub fn parse_observed(literal: &str) -> Result<Value, LiteralError> {
        if literal.len() > MAX_OBSERVED_LEN {
            return Err(LiteralError::malformed(
                MAX_OBSERVED_LEN,
                "the end of the value, which has at most 16 KiB,",
            ));
        }
        Value::parse(literal).or_else(|error| out_of_range(literal).ok_or(error))
    }
}

/// A value is written as its typed literal.
impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// A value is read as an engine gives it; no engine answers by a number with its units.
impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Value, D::Error> {
        deserialized(deserializer, Value::parse_observed)
    }
}

/// Deserializes a value that an engine gave or that an expectation states: what [`Value::parse_observed`] or [`Value::parse_expected`] reads. For
/// `#[serde(deserialize_with)]`.
///
/// # Errors
/// An error of the deserializer for anything else.
pub fn deserialize_expected<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Value, D::Error> {
    let parse = |literal: &str| Value::parse_expected(literal).or_else(|_| Value::parse_observed(literal));
    deserialized(deserializer, parse)
}

fn deserialized<'de, D: Deserializer<'de>>(
    deserializer: D,
    parse: impl Fn(&str) -> Result<Value, LiteralError>,
) -> Result<Value, D::Error> {
    let literal = Cow::<'de, str>::deserialize(deserializer)?;
    let wrong = |error| de::Error::custom(format!("`{literal}` is no typed literal: {error}"));
    parse(&literal).map_err(wrong)
}

fn out_of_range(literal: &str) -> Option<Value> {
    let (prefix, rest) = literal.split_once('#')?;
    let ty = ElementaryType::from_literal_prefix(prefix)?;
    let nanoseconds = wide_duration(rest).ok().filter(|_| ty.is_moment())?;
    let value = Value::of_nanoseconds(ty, nanoseconds);
    matches!(value, Value::OutOfRange { .. }).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_64_bits_do_not_hold_is_another_value() {
        for (nanoseconds, is_literal) in [((1 << 63) - 1, true), (1 << 63, false), (-(1 << 63) - 1, false)] {
            let value = Value::of_nanoseconds(ElementaryType::Time, nanoseconds);
            assert_eq!(Value::parse(&value.to_string()).is_ok(), is_literal);
            assert_eq!(Value::parse_observed(&value.to_string()), Ok(value));
        }
    }

    #[test]
    fn only_an_expectation_is_near_a_number() {
        let text = || de::value::StrDeserializer::<de::value::Error>::new("REAL#1.0 within 2");
        assert!(Value::deserialize(text()).is_err());
        assert!(matches!(deserialize_expected(text()), Ok(Value::Near { .. })));
    }

    #[test]
    fn a_text_that_no_case_can_expect_is_refused() {
        let text = |length: usize| format!("STRING#'{}'", "x".repeat(length));
        let value = Value::parse(&text(5000)).unwrap();
        assert_eq!(Value::parse_observed(&text(5000)), Ok(value));
        let error = Value::parse_observed(&text(1 << 20)).unwrap_err();
        assert_eq!(
            error.to_string(),
            "expected the end of the value, which has at most 16 KiB, at byte 16384"
        );
    }
}
