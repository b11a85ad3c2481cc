//! Writes values as literals that every dialect reads.

use stickler_types::{ElementaryType, Value};

/// Returns the literal of a value as a program writes it. A NaN or an infinity, which has none, gives its canonical spelling.
///
/// TRUE, FALSE and texts stand without their type, since older systems know no prefix for them. A REAL has the digits of
/// the LREAL of the same value, so that a compiler which reads it by way of an LREAL gets it too.
pub fn literal(value: &Value) -> String {
    if let Some(number) = value.real() {
        let digits = Value::plain(ElementaryType::Lreal, number.to_bits());
        return format!("{}#{}", value.type_name(), digits.without_type());
    }
    match value {
        Value::Plain {
            ty: ElementaryType::Bool,
            ..
        }
        | Value::Text { .. } => value.without_type(),
        Value::Plain { .. } | Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => {
            value.to_string()
        }
    }
}

/// Returns the literal of a value without its type where that is a number, for a variable of its type: some compilers read no sign behind
/// the type.
pub fn untyped_literal(value: &Value) -> String {
    let typed = literal(value);
    let is_number = ElementaryType::from_name(value.type_name()).is_some_and(ElementaryType::is_number);
    match typed.split_once('#') {
        Some((_, number)) if is_number => number.to_owned(),
        _ => typed,
    }
}

/// Returns whether a value has a literal; NaN and the infinities have none.
pub fn has_literal(value: &Value) -> bool {
    value.real().is_none_or(f64::is_finite)
}

/// Returns the literal of a power of two as an LREAL.
pub fn power_of_two(exponent: i32) -> String {
    // Every exponent that is asked for is one of a REAL, so the sum is positive and has 11 bits.
    let biased = (1023 + i64::from(exponent)).cast_unsigned();
    Value::plain(ElementaryType::Lreal, biased << 52).to_string()
}
