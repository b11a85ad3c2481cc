//! Values as literals that every dialect reads.

use stickler_types::{ElementaryType, Value};

/// The literal of a value as a program writes it; `None` for a NaN and the infinities, which have none.
///
/// TRUE, FALSE and texts stand without their type, since older systems know no prefix for them. A REAL has the digits of
/// the LREAL of the same value, so that a compiler which reads it by way of an LREAL gets it too.
#[must_use]
pub fn literal(value: &Value) -> Option<String> {
    use ElementaryType::{Bool, Lreal, Real};
    match value {
        Value::Plain { ty: Bool, raw } => Some(if *raw == 0 { "FALSE" } else { "TRUE" }.to_owned()),
        Value::Plain { ty: Real, raw } => {
            // A REAL's raw form has 32 bits.
            let number = f64::from(f32::from_bits(*raw as u32));
            finite(number).map(|digits| format!("REAL#{digits}"))
        }
        Value::Plain { ty: Lreal, raw } => {
            finite(f64::from_bits(*raw)).map(|digits| format!("LREAL#{digits}"))
        }
        Value::Text { .. } => Some(value.without_type()),
        Value::Plain { .. } | Value::Enumerated { .. } => Some(value.to_string()),
    }
}

/// The literal of a power of two as an LREAL.
#[must_use]
pub fn power_of_two(exponent: i32) -> String {
    // Every exponent that is asked for is one of a REAL, so the sum is positive and has 11 bits.
    let biased = (1023 + i64::from(exponent)).cast_unsigned();
    Value::plain(ElementaryType::Lreal, biased << 52).to_string()
}

fn finite(number: f64) -> Option<String> {
    let value = Value::plain(ElementaryType::Lreal, number.to_bits());
    number.is_finite().then(|| value.without_type())
}

#[cfg(test)]
mod tests {
    use super::{literal, power_of_two};
    use stickler_types::Value;

    #[test]
    fn literals_are_those_that_old_compilers_read_too() {
        for (value, written) in [
            ("BOOL#TRUE", Some("TRUE")),
            ("SINT#-128", Some("SINT#-128")),
            ("WORD#16#00FF", Some("WORD#16#00FF")),
            ("STRING#'a$'b#c'", Some("'a$'b#c'")),
            ("REAL#0.1", Some("REAL#0.10000000149011612")),
            ("REAL#-0.0", Some("REAL#-0.0")),
            ("LREAL#0.1", Some("LREAL#0.1")),
            ("REAL#NaN", None),
            ("LREAL#-Infinity", None),
        ] {
            let value = Value::parse(value).expect("a value");
            assert_eq!(literal(&value).as_deref(), written);
        }
    }

    #[test]
    fn powers_of_two_are_exact() {
        for exponent in [-149, -1, 0, 1, 52, 128] {
            let value = Value::parse(&power_of_two(exponent)).expect("a literal");
            let Value::Plain { raw, .. } = value else {
                panic!("{value}")
            };
            assert_eq!(f64::from_bits(raw), 2_f64.powi(exponent));
        }
    }
}
