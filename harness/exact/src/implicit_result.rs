//! Results of implicit conversions.

use crate::real;
use crate::{integer, moment};
use stickler_types::{ElementaryType, MomentUnits, Value};

/// The unit of a TIME, which is the same whatever counts a date.
const MILLISECONDS: MomentUnits = MomentUnits::Seconds;

/// The result of an implicit conversion, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub enum ImplicitResult {
    /// The result is exactly this value.
    Exactly(Value),
    /// The target cannot hold the value, and no document says what it holds instead.
    Open,
}

/// Returns the value of a variable of type `to` after `value` was assigned to it; `None` for pairs of types that no
/// document converts implicitly.
///
/// The result is the number (rounded once, to the nearest, where the target is a real), the zero-extended bits, the same
/// duration, date or time of day in its long or short form, or for UDINT and TIME the same count of milliseconds.
///
/// Basis: conformance-cases/README.md (a matrix of types).
#[must_use]
pub fn implicit_result(value: &Value, to: ElementaryType) -> Option<ImplicitResult> {
    use ElementaryType::{Lreal, Real, Time, Udint};
    let (from, raw) = match *value {
        Value::Plain { ty, raw } => (ty, raw),
        Value::Text { ty, .. } => return (ty == to).then(|| ImplicitResult::Exactly(value.clone())),
        Value::Enumerated { .. } | Value::OutOfRange { .. } => return None,
    };
    let is_number = |ty: ElementaryType| ty.integer_range().is_some();
    let raw = match (from, to) {
        _ if from == to => raw,
        (Real, Lreal) => real::between(raw, from, to),
        (Udint, Time) => moment::from_units(integer::number(raw, from), to, MILLISECONDS),
        (Time, Udint) if !moment::has_whole_units(raw, from, MILLISECONDS) => {
            return Some(ImplicitResult::Open);
        }
        (Time, Udint) => return Some(held(moment::units(raw, from, MILLISECONDS), to)),
        _ if is_number(from) && is_number(to) => return Some(held(integer::number(raw, from), to)),
        _ if from.is_integer() && to.is_real() => real::from_integer(integer::number(raw, from), to),
        _ if from.long_form() == Some(to) || to.long_form() == Some(from) => moment::between(raw, to),
        _ => return None,
    };
    Some(ImplicitResult::Exactly(Value::plain(to, raw)))
}

/// Returns the number as a value of the type, if the type holds it.
fn held(number: i128, to: ElementaryType) -> ImplicitResult {
    match to.integer_range() {
        Some((least, greatest)) if (least..=greatest).contains(&number) => {
            ImplicitResult::Exactly(Value::plain(to, integer::wrapped(number, to)))
        }
        _ => ImplicitResult::Open,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn result_as(value: &str, target: ElementaryType) -> Option<String> {
        match implicit_result(&Value::parse(value).unwrap(), target)? {
            ImplicitResult::Exactly(value) => Some(value.to_string()),
            ImplicitResult::Open => Some("open".to_owned()),
        }
    }

    #[test]
    fn known_values_stay_what_they_are() {
        use ElementaryType::*;
        for (value, target, expected) in [
            ("SINT#-128", Lint, "LINT#-128"),
            ("USINT#255", Int, "INT#255"),
            ("UDINT#4000000000", Lint, "LINT#4000000000"),
            ("BYTE#16#80", Lword, "LWORD#16#0000000000000080"),
            ("BYTE#16#FF", Int, "INT#255"),
            ("BOOL#TRUE", Word, "WORD#16#0001"),
            ("INT#-5", Real, "REAL#-5.0"),
            ("DINT#16777217", Lreal, "LREAL#16777217.0"),
            ("LINT#9007199254740993", Lreal, "LREAL#9007199254740992.0"),
            ("LINT#9007199254740995", Lreal, "LREAL#9007199254740996.0"),
            ("ULINT#18446744073709551615", Lreal, "LREAL#1.8446744073709552E19"),
            (
                "LINT#-9223372036854775808",
                Lreal,
                "LREAL#-9.223372036854775808E18",
            ),
            ("UDINT#4294967295", Time, "TIME#4294967295ms"),
            ("TIME#1500ms", Udint, "UDINT#1500"),
            ("TIME#-1ms", Udint, "open"),
            ("TIME#1500us", Udint, "open"),
            ("TIME#-1.5ms", Ltime, "LTIME#-1500000ns"),
            ("LDATE#2024-02-29", Date, "DATE#2024-02-29"),
            ("STRING#'a'", String, "STRING#'a'"),
            ("REAL#0.1", Lreal, "LREAL#0.10000000149011612"),
            ("REAL#-0.0", Lreal, "LREAL#-0.0"),
        ] {
            let expected = match expected {
                "open" => "open".to_owned(),
                literal => Value::parse(literal).unwrap().to_string(),
            };
            assert_eq!(
                result_as(value, target),
                Some(expected),
                "{value} to {}",
                target.name()
            );
        }
    }

    #[test]
    fn pairs_without_a_rule_are_not_guessed() {
        use ElementaryType::*;
        for (value, target) in [
            ("REAL#1.5", Int),
            ("BYTE#1", Real),
            ("STRING#'a'", Wstring),
            ("LREAL#1.0", Real),
            ("DATE#2024-01-01", Dt),
        ] {
            assert_eq!(result_as(value, target), None, "{value} to {}", target.name());
        }
    }

    #[test]
    fn a_number_that_does_not_fit_is_open() {
        assert_eq!(result_as("INT#-1", ElementaryType::Word), Some("open".to_owned()));
        assert_eq!(
            result_as("INT#128", ElementaryType::Sint),
            Some("open".to_owned())
        );
    }
}
