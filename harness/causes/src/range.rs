//! Wrong values beside the numbers of their programs: whether a number left the range of a type, and whether a unit is the wrong one.

use crate::literals::{kind, type_of_token};
use crate::question::Deviation;
use crate::tokens::{ProgramTokenKind, tokens};
use stickler_run::Fact;
use stickler_types::{ElementaryType, Value};

/// The milliseconds of a second.
const MILLISECONDS: f64 = 1000.0;

/// Returns whether the first value that a program has wrong must be another number than each literal of the program, as where a
/// conversion wraps. Where the program has no number, none left a range.
pub(crate) fn leaves_range(program: &str, deviation: &Deviation) -> bool {
    let Some((expected, _)) = wrong_numbers(deviation) else {
        return false;
    };
    let numbers = numbers(program);
    // A fraction is dropped or rounded, and a REAL has 24 bits.
    let is_near = |number: &f64| (number.abs() - expected.abs()).abs() <= 1.0 + expected.abs() * 1e-6;
    !numbers.is_empty() && !numbers.iter().any(is_near)
}

/// Returns whether a program converts between durations and numbers, and the engine counts them in seconds where milliseconds are
/// expected.
pub(crate) fn counts_seconds(program: &str, deviation: &Deviation) -> bool {
    let Some((expected, got)) = wrong_numbers(deviation) else {
        return false;
    };
    let kinds = kinds(program);
    let converts =
        kinds.contains(&"duration") && kinds.iter().any(|kind| matches!(*kind, "integer" | "real"));
    // Below a second the number of seconds is 0, which other errors give too.
    let counts_seconds = expected.abs() >= MILLISECONDS && (got - expected / MILLISECONDS).abs() < 1.0;
    let takes_seconds = expected != 0.0 && (got - expected * MILLISECONDS).abs() < 1.0;
    converts && (counts_seconds || takes_seconds)
}

/// Returns the kinds of the types that a program names, in the names of its functions too.
fn kinds(program: &str) -> Vec<&'static str> {
    let mut found = Vec::new();
    for token in tokens(program) {
        match token.kind {
            ProgramTokenKind::Word => {
                let upper = token.text.to_ascii_uppercase();
                let types = upper.split('_').filter_map(ElementaryType::from_name);
                found.extend(types.filter_map(kind));
            }
            _ => found.extend(type_of_token(&token).and_then(kind)),
        }
    }
    found
}

/// Returns the first number that a program has wrong: what it must be, and what it is.
fn wrong_numbers(deviation: &Deviation) -> Option<(f64, f64)> {
    let mut pairs = deviation.expected.iter().zip(&deviation.got);
    pairs.find_map(|pair| match pair {
        (Fact::Value { value, .. }, Fact::Value { value: other, .. }) if value != other => {
            Some((number(value)?, number(other)?))
        }
        _ => None,
    })
}

/// Returns a numeric value, or a duration in its unit, as a number; exact enough to compare magnitudes.
fn number(value: &Value) -> Option<f64> {
    let text = value.to_string();
    let (_, digits) = text.split_once('#')?;
    parsed(digits.trim_end_matches(|character: char| character.is_ascii_lowercase()))
}

/// Returns the numbers that the literals of a program say, without their signs; of a duration with one unit its number.
fn numbers(program: &str) -> Vec<f64> {
    let literal = |kind: ProgramTokenKind, text: &str| match kind {
        ProgramTokenKind::Number => parsed(text),
        ProgramTokenKind::Typed => {
            let digits = text.split_once('#')?.1.trim_start_matches(['-', '+']);
            parsed(digits.trim_end_matches(|unit: char| unit.is_ascii_lowercase()))
        }
        _ => None,
    };
    let all = tokens(program);
    all.iter()
        .filter_map(|token| literal(token.kind, token.text))
        .collect()
}

/// Returns the number that digits say, with or without a base.
fn parsed(digits: &str) -> Option<f64> {
    let plain = digits.replace('_', "");
    match plain.split_once('#') {
        Some((base, digits)) => {
            let base = base.parse().ok().filter(|base| matches!(base, 2 | 8 | 16))?;
            Some(u64::from_str_radix(digits, base).ok()? as f64)
        }
        None => plain.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sign::Sign;
    use stickler_run::{Grade, Verdict};

    fn deviation(expected: &str, got: &str) -> Deviation {
        let fact = |text: &str| Fact::Value {
            name: "into".to_owned(),
            value: Value::parse(text).expect("a literal"),
        };
        let (expected, got) = (vec![fact(expected)], vec![fact(got)]);
        let sign = Sign::of("", Verdict::Fail, (&expected, &got), Grade::Line);
        Deviation { sign, expected, got }
    }

    #[test]
    fn a_number_that_wraps_has_left_its_range_and_one_that_is_truncated_has_not() {
        let outside = deviation("LINT#-1099511627776", "LINT#-9223372036854775808");
        assert!(leaves_range("into := REAL_TO_LINT(REAL#1.8446743E19);", &outside));
        let inside = deviation("ULINT#18446742974197923840", "ULINT#9223372036854775808");
        assert!(!leaves_range(
            "into := REAL_TO_ULINT(REAL#1.8446743E19);",
            &inside
        ));
        let truncated = deviation("DINT#-2", "DINT#-3");
        assert!(!leaves_range(
            "data : REAL := -2.9; into := REAL_TO_DINT(data);",
            &truncated
        ));
        assert!(!leaves_range("into := data;", &truncated), "there is no number");
        let duration = deviation("INT#-31072", "INT#100");
        assert!(leaves_range("into := TIME_TO_INT(TIME#100000ms);", &duration));
        let bits = deviation("WORD#16#00FF", "WORD#16#0000");
        assert!(!leaves_range("into := 16#FF;", &bits));
    }

    #[test]
    fn seconds_in_the_place_of_milliseconds_are_seen_in_both_directions() {
        let of =
            |program: &str, expected: &str, got: &str| counts_seconds(program, &deviation(expected, got));
        assert!(of(
            "into : INT; into := TIME_TO_INT(TIME#32767ms);",
            "INT#32767",
            "INT#32"
        ));
        assert!(of(
            "into : TIME; into := INT_TO_TIME(INT#-1);",
            "TIME#-1ms",
            "TIME#-1000ms"
        ));
        assert!(!of(
            "into : TIME; into := INT_TO_TIME(INT#5);",
            "TIME#5ms",
            "TIME#6ms"
        ));
        assert!(!of(
            "into : INT; into := REAL_TO_INT(5000.0);",
            "INT#5000",
            "INT#5"
        ));
        assert!(!of(
            "into : INT; into := TIME_TO_INT(TIME#500ms);",
            "INT#500",
            "INT#0"
        ));
    }
}
