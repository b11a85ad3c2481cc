//! Writes values as literals that every dialect reads.

use stickler_types::{ElementaryType, Value};

/// Returns the literal of a value as a program writes it. A NaN or an infinity, which has none, gives its canonical spelling.
///
/// TRUE, FALSE and texts stand without their type, since older systems know no prefix for them. A REAL has the digits of
/// the LREAL of the same value, so that a compiler which reads it by way of an LREAL gets it too.
#[must_use]
pub fn literal(value: &Value) -> String {
    if let Some(number) = real(value) {
        let digits = Value::plain(ElementaryType::Lreal, number.to_bits());
        return format!("{}#{}", value.type_name(), digits.without_type());
    }
    match value {
        Value::Plain {
            ty: ElementaryType::Bool,
            ..
        }
        | Value::Text { .. } => value.without_type(),
        Value::Plain { .. } | Value::Enumerated { .. } | Value::OutOfRange { .. } => value.to_string(),
    }
}

/// Returns the literal of a value without its type where that is a number, for a variable of its type: some compilers read no sign behind
/// the type.
#[must_use]
pub fn untyped_literal(value: &Value) -> String {
    let typed = literal(value);
    let is_number =
        ElementaryType::from_name(value.type_name()).is_some_and(|ty| ty.is_integer() || ty.is_real());
    match typed.split_once('#') {
        Some((_, number)) if is_number => number.to_owned(),
        _ => typed,
    }
}

/// Returns whether a value has a literal; NaN and the infinities have none.
#[must_use]
pub fn has_literal(value: &Value) -> bool {
    real(value).is_none_or(f64::is_finite)
}

/// Returns a REAL or LREAL value as an `f64`, exactly; `None` for values of other types.
#[must_use]
pub fn real(value: &Value) -> Option<f64> {
    match value {
        Value::Plain {
            ty: ElementaryType::Real,
            raw,
        } => u32::try_from(*raw)
            .ok()
            .map(|bits| f64::from(f32::from_bits(bits))),
        Value::Plain {
            ty: ElementaryType::Lreal,
            raw,
        } => Some(f64::from_bits(*raw)),
        _ => None,
    }
}

/// Returns the literal of a power of two as an LREAL.
#[must_use]
pub fn power_of_two(exponent: i32) -> String {
    // Every exponent that is asked for is one of a REAL, so the sum is positive and has 11 bits.
    let biased = (1023 + i64::from(exponent)).cast_unsigned();
    Value::plain(ElementaryType::Lreal, biased << 52).to_string()
}

#[cfg(test)]
mod tests {
    use super::{has_literal, literal, power_of_two};
    use stickler_types::Value;

    #[test]
    fn literals_are_those_that_old_compilers_read_too() {
        for (value, written) in [
            ("BOOL#TRUE", "TRUE"),
            ("SINT#-128", "SINT#-128"),
            ("WORD#16#00FF", "WORD#16#00FF"),
            ("STRING#'a$'b#c'", "'a$'b#c'"),
            ("REAL#0.1", "REAL#0.10000000149011612"),
            ("REAL#-0.0", "REAL#-0.0"),
            ("LREAL#0.1", "LREAL#0.1"),
        ] {
            let value = Value::parse(value).expect("a value");
            assert!(has_literal(&value));
            assert_eq!(literal(&value), written);
        }
    }

    #[test]
    fn no_literal_says_nan_or_infinity() {
        for value in ["REAL#NaN", "LREAL#-Infinity"] {
            assert!(!has_literal(&Value::parse(value).expect("a value")));
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
