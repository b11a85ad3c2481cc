//! The plainest value of a type, and simplifications of values.

use crate::model::{Expression, ExpressionKind, LiteralForm, Program, Type};
use stickler_types::{ElementaryType, Family, Value};

/// Returns the plainest expression of a type: 0, FALSE, the empty text, the first value of an enumeration; `None` for a type
/// without literals, such as an array.
pub(super) fn plainest(program: &Program, ty: &Type) -> Option<Expression> {
    let ty = program.unaliased(ty);
    let kind = match ty {
        Type::Elementary(elementary) if elementary.is_text() => {
            literal_kind(Value::text(*elementary, Vec::new()))
        }
        Type::Elementary(elementary) => literal_kind(Value::plain(*elementary, 0)),
        other => {
            program.enumerated_values(other)?;
            ExpressionKind::Enumerated(0)
        }
    };
    Some(Expression { ty: ty.clone(), kind })
}

/// Creates a literal that can stand wherever its type can: with a prefix, unless its form determines its type.
pub(super) fn literal_kind(value: Value) -> ExpressionKind {
    let tells_its_type = elementary(&value).is_some_and(|ty| {
        matches!(
            ty.family(),
            Family::Boolean
                | Family::Text
                | Family::Duration
                | Family::Date
                | Family::TimeOfDay
                | Family::DateAndTime
        )
    });
    let form = if tells_its_type {
        LiteralForm::Untyped
    } else {
        LiteralForm::Typed
    };
    ExpressionKind::Literal(value, form)
}

/// Returns the elementary type of a value; `None` for an enumerated value.
fn elementary(value: &Value) -> Option<ElementaryType> {
    match value {
        Value::Plain { ty, .. } | Value::Text { ty, .. } => Some(*ty),
        Value::Enumerated { .. } | Value::OutOfRange { .. } => None,
    }
}

/// A way to simplify a value, from the boldest to the most careful.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Simplification {
    /// 0, or the empty text.
    Zero,
    /// 1, or one character.
    One,
    /// Half the number, or the first half of the text.
    Half,
    /// One nearer to 0, or one character less; a small step, for small numbers and short texts only.
    Less,
    /// The power of two below.
    Power,
    /// One more than the power of two below.
    AbovePower,
    /// Nine tenths of the number, which gets past a limit that halves cannot reach; of a text, repetitions of one character.
    Tenth,
}

impl Simplification {
    /// Returns the simplified value; `None` if it does not differ.
    pub fn of(self, value: &Value) -> Option<Value> {
        let plainer = match value {
            Value::Text { ty, units } => Value::text(*ty, self.of_text(units)),
            Value::Plain { ty, raw } if *ty == ElementaryType::Real => {
                let number = self.of_real(f64::from(f32::from_bits(*raw as u32)))?;
                Value::plain(*ty, u64::from((number as f32).to_bits()))
            }
            Value::Plain { ty, raw } if *ty == ElementaryType::Lreal => {
                Value::plain(*ty, self.of_real(f64::from_bits(*raw))?.to_bits())
            }
            Value::Plain { ty, raw } => {
                let number = self.of_number(ty.integer_value(*raw), unit_of(*ty));
                Value::plain(*ty, number_as_raw(*ty, number))
            }
            Value::Enumerated { .. } | Value::OutOfRange { .. } => return None,
        };
        (plainer != *value).then_some(plainer)
    }

    fn of_text(self, units: &[u16]) -> Vec<u16> {
        let length = units.len();
        let kept = match self {
            Simplification::Zero => 0,
            Simplification::One => 1,
            Simplification::Half => length / 2,
            Simplification::Less if length > SMALL as usize => length,
            Simplification::Less => length.saturating_sub(1),
            Simplification::Power | Simplification::AbovePower => length,
            Simplification::Tenth => return units.iter().map(|_| u16::from(b'a')).collect(),
        };
        units.iter().take(kept).copied().collect()
    }

    fn of_real(self, number: f64) -> Option<f64> {
        if !number.is_finite() {
            return None;
        }
        Some(match self {
            Simplification::Zero => 0.0,
            Simplification::One => 1.0,
            Simplification::Half => number.trunc(),
            Simplification::Less | Simplification::Power | Simplification::AbovePower => number.abs(),
            Simplification::Tenth => (number * 10.0).trunc() / 10.0,
        })
    }

    /// Simplifies an integer, or a duration or moment that is counted in units.
    fn of_number(self, number: i128, unit: i128) -> i128 {
        match self {
            Simplification::Zero => 0,
            Simplification::One => unit,
            Simplification::Half => number / 2 / unit * unit,
            Simplification::Less if number.abs() / unit > SMALL => number,
            Simplification::Less => number - unit * number.signum(),
            Simplification::Power => power_below(number / unit) * unit,
            Simplification::AbovePower if number.abs() / unit > 2 => {
                (power_below(number / unit) + number.signum()) * unit
            }
            Simplification::AbovePower => number,
            Simplification::Tenth => (number - number / 10) / unit * unit,
        }
    }
}

/// The bound up to which numbers are decremented one by one.
const SMALL: i128 = 16;

/// Returns the greatest power of two that is not further from 0, with the same sign.
fn power_below(number: i128) -> i128 {
    match number.unsigned_abs().checked_ilog2() {
        Some(bit) => number.signum() << bit,
        None => 0,
    }
}

/// Returns the unit in which a person counts a type: durations and dates are stored in nanoseconds.
const fn unit_of(ty: ElementaryType) -> i128 {
    match ty.family() {
        Family::Duration | Family::TimeOfDay => 1_000_000,
        Family::Date => 86_400_000_000_000,
        Family::DateAndTime => 1_000_000_000,
        _ => 1,
    }
}

fn number_as_raw(ty: ElementaryType, number: i128) -> u64 {
    match ty.integer_range() {
        Some(_) => ty.wrap(number),
        // Nanoseconds or a code unit: nearer to 0 than the old value, so it fits.
        None => number as u64,
    }
}

#[cfg(test)]
mod tests {
    use super::Simplification;
    use stickler_types::Value;

    fn after(step: Simplification, literal: &str) -> Option<String> {
        let value = Value::parse(literal).expect("a typed literal");
        step.of(&value).map(|value| value.to_string())
    }

    #[test]
    fn numbers_come_nearer_to_nothing() {
        assert_eq!(after(Simplification::Zero, "INT#-300").as_deref(), Some("INT#0"));
        assert_eq!(
            after(Simplification::Half, "INT#-300").as_deref(),
            Some("INT#-150")
        );
        assert_eq!(
            after(Simplification::Less, "SINT#-16").as_deref(),
            Some("SINT#-15")
        );
        assert_eq!(after(Simplification::Less, "INT#300"), None);
        assert_eq!(
            after(Simplification::Power, "INT#-300").as_deref(),
            Some("INT#-256")
        );
        assert_eq!(
            after(Simplification::AbovePower, "INT#300").as_deref(),
            Some("INT#257")
        );
        assert_eq!(
            after(Simplification::Power, "ULINT#18446744073709551615").as_deref(),
            Some("ULINT#9223372036854775808")
        );
        assert_eq!(after(Simplification::Less, "SINT#0"), None);
        assert_eq!(
            after(Simplification::Half, "REAL#-2.75").as_deref(),
            Some("REAL#-2.0")
        );
        assert_eq!(
            after(Simplification::Zero, "REAL#-0.0").as_deref(),
            Some("REAL#0.0")
        );
        assert_eq!(after(Simplification::Zero, "REAL#NaN"), None);
    }

    #[test]
    fn durations_stay_whole_milliseconds() {
        assert_eq!(
            after(Simplification::Half, "TIME#1001ms").as_deref(),
            Some("TIME#500ms")
        );
        assert_eq!(after(Simplification::One, "TIME#7h").as_deref(), Some("TIME#1ms"));
        assert_eq!(
            after(Simplification::Power, "TIME#1001ms").as_deref(),
            Some("TIME#512ms")
        );
    }

    #[test]
    fn dates_stay_whole_days() {
        assert_eq!(
            after(Simplification::Power, "DATE#1970-01-08").as_deref(),
            Some("DATE#1970-01-05")
        );
        assert_eq!(
            after(Simplification::AbovePower, "DATE#1970-01-08").as_deref(),
            Some("DATE#1970-01-06")
        );
    }

    #[test]
    fn texts_get_shorter_and_then_duller() {
        assert_eq!(
            after(Simplification::Half, "STRING#'abcd'").as_deref(),
            Some("STRING#'ab'")
        );
        assert_eq!(
            after(Simplification::Tenth, "STRING#'xyz'").as_deref(),
            Some("STRING#'aaa'")
        );
        assert_eq!(after(Simplification::Less, "STRING#''"), None);
    }
}
