//! Values as engines give them: durations and dates that 64 bits of nanoseconds do not hold, and texts that are too long.

use crate::elementary::ElementaryType;
use crate::literal::{LiteralError, wide_duration};
use crate::value::Value;

/// The maximum number of bytes of a value that an engine gives, so that reports stay small whatever it prints. A `STRING` of 5000
/// characters that are all written as escapes fits.
const MAX_OBSERVED_LEN: usize = 16 << 10;

impl Value {
    /// Returns the duration, date or time of day with this number of nanoseconds, which a compiler may keep in more than 64 bits.
    #[must_use]
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

fn out_of_range(literal: &str) -> Option<Value> {
    let (prefix, rest) = literal.split_once('#')?;
    let ty = ElementaryType::from_literal_prefix(prefix)?;
    let is_counted = ty.is_duration() || ty.is_date_or_time();
    let nanoseconds = wide_duration(rest).ok().filter(|_| is_counted)?;
    let value = Value::of_nanoseconds(ty, nanoseconds);
    matches!(value, Value::OutOfRange { .. }).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType as E;

    #[test]
    fn what_64_bits_do_not_hold_is_another_value_and_spelled_in_nanoseconds() {
        const BEYOND: i128 = 1 << 63;
        for (ty, nanoseconds, spelled) in [
            (E::Time, BEYOND - 1, "TIME#9223372036854.775807ms"),
            (E::Time, BEYOND, "TIME#9223372036854775808ns"),
            (E::Ltime, -BEYOND - 1, "LTIME#-9223372036854775809ns"),
            (E::Dt, BEYOND * 1_000_000_000, "DT#9223372036854775808000000000ns"),
            (E::Date, BEYOND + 1, "DATE#9223372036854775809ns"),
            (E::Tod, -BEYOND * 2, "TOD#-18446744073709551616ns"),
        ] {
            let value = Value::of_nanoseconds(ty, nanoseconds);
            assert_eq!(value.to_string(), spelled);
            assert_eq!(Value::parse_observed(spelled), Ok(value));
            assert_eq!(
                Value::parse(spelled).is_ok(),
                nanoseconds < BEYOND && ty == E::Time
            );
        }
        let ms = Value::parse_observed("TIME#-9223372036854775808ms").unwrap();
        assert_eq!(ms.to_string(), "TIME#-9223372036854775808000000ns");
        assert_ne!(ms, Value::parse_observed("TIME#-9223372036854775807ms").unwrap());
    }

    #[test]
    fn nothing_else_is_read_than_what_is_out_of_range() {
        for literal in [
            "DATE#5ns",
            "INT#9223372036854775808ns",
            "TIME#9223372036854775808",
            "TIME#",
            "DT#999999999999999999999999999999999999999999999999999999s",
        ] {
            assert!(Value::parse_observed(literal).is_err(), "{literal}");
        }
        assert_eq!(Value::parse_observed("INT#5"), Value::parse("INT#5"));
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
