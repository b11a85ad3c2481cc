//! Wrong values beside the numbers of their programs: whether a number left the range of a type, lost digits or kept too many, and
//! whether a unit is the wrong one.

use crate::literals::{kind, type_of_token, valued_types};
use crate::names::{DeclaredNames, converted, prefix_type};
use crate::operations::operations_of;
use crate::question::{Deviation, wrong_values};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use stickler_types::{ElementaryType, Family, Value};

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

/// Returns what a wrong value says by its number alone of how it came about, whatever types and sizes the program has; `None` where it
/// says nothing.
pub(crate) fn number_pattern(program: &str, deviation: &Deviation) -> Option<&'static str> {
    if counts_seconds(program, deviation) {
        Some("seconds in the place of milliseconds")
    } else if converts_out_of_range(program, deviation) {
        Some("conversion of a real number outside the range of its target")
    } else if counts_to_limit(program) {
        Some("FOR loop to the last value of its type")
    } else if keeps_range(program, deviation) {
        Some("conversion to an integer that does not bring it into its range")
    } else if rounds_to_lreal(program, deviation) {
        Some("integer literal with the bits of an LREAL")
    } else if keeps_lreal(program, deviation) {
        Some("REAL literal with the bits of an LREAL")
    } else {
        None
    }
}

/// Returns whether a program does nothing but convert a real number to an integer by name, and the number is outside the range of that.
fn converts_out_of_range(program: &str, deviation: &Deviation) -> bool {
    let all = tokens(program);
    let is_negative = |token: &ProgramToken<'_>| token.text == "-" || token.text.contains("#-");
    let sign = if all.iter().any(is_negative) { -1.0 } else { 1.0 };
    let leaves = |into: ElementaryType| {
        // Of an unsigned type the least number is 0, and a minus stands before a number.
        let is_outside = |number: f64| {
            let range = into.integer_range();
            let most = range.is_some_and(|(_, most)| number > most as f64);
            most || number * sign < 0.0 && into.family() != Family::Signed
        };
        leaves_range(program, deviation) || numbers(program).into_iter().any(is_outside)
    };
    let mut targets = all.iter().filter_map(converted);
    let is_outside =
        targets.any(|(from, into)| from.is_real() && kind(into) == Some("integer") && leaves(into));
    computed(program) == 1 && is_outside
}

/// Returns the number of operations with which a program computes. Calls, elements, conditions and the sign of an operand are none.
fn computed(program: &str) -> usize {
    let beside = [
        "sign",
        "call",
        "output argument",
        "subscript or list",
        "condition",
    ];
    let operations = operations_of(program).into_iter();
    operations.filter(|one| !beside.contains(&one.as_str())).count()
}

/// Returns whether a program does nothing but count in a FOR loop, with numbers of one type and the greatest amount of that type.
fn counts_to_limit(program: &str) -> bool {
    let all = tokens(program);
    if computed(program) > 0 || valued_types(&all).len() > 1 {
        return false;
    }
    let names = DeclaredNames::new(&all);
    let mut heads = all.windows(2).filter(|pair| pair[0].is("FOR"));
    heads.any(|pair| {
        let range = names.type_of(&pair[1]).and_then(ElementaryType::integer_range);
        let most = range.map(|(_, most)| most.to_string());
        all.iter().any(|token| Some(token.text) == most.as_deref())
    })
}

/// Returns whether a program converts to an integer by name, and the wrong value has the bits that the result has, with others before them.
fn keeps_range(program: &str, deviation: &Deviation) -> bool {
    let Some((Value::Plain { ty, raw }, Value::Plain { raw: got, .. })) = first_wrong(deviation) else {
        return false;
    };
    let has_bits_of = |token: &ProgramToken<'_>| {
        let narrow = converted(token).map(|(_, into)| into);
        narrow.is_some_and(|narrow| {
            let is_narrow = kind(narrow) == Some("integer") && narrow.bits() < ty.bits();
            is_narrow && (raw ^ got) & ((1 << narrow.bits()) - 1) == 0
        })
    };
    kind(*ty) == Some("integer") && tokens(program).iter().any(has_bits_of)
}

/// Returns whether an integer literal of 64 bits is off by no more than an LREAL, which has 53 bits, can be off at its size.
fn rounds_to_lreal(program: &str, deviation: &Deviation) -> bool {
    let Some((Value::Plain { ty, raw }, Value::Plain { raw: got, .. })) = first_wrong(deviation) else {
        return false;
    };
    let magnitude = match ty.family() {
        Family::Signed => raw.cast_signed().unsigned_abs(),
        _ => *raw,
    };
    let error = raw.wrapping_sub(*got).cast_signed().unsigned_abs();
    operations_of(program).is_empty()
        && kind(*ty) == Some("integer")
        && magnitude > 1 << f64::MANTISSA_DIGITS
        && error <= 1 << (u64::BITS - f64::MANTISSA_DIGITS)
}

/// Returns whether a literal of the type REAL is not rounded to one.
fn keeps_lreal(program: &str, deviation: &Deviation) -> bool {
    let is_real = |token: &ProgramToken<'_>| prefix_type(token) == Some(ElementaryType::Real);
    let is_rounded = |(expected, got): (f64, f64)| f64::from(got as f32) == expected;
    operations_of(program).is_empty()
        && tokens(program).iter().any(is_real)
        && wrong_numbers(deviation).is_some_and(is_rounded)
}

/// Returns whether a program has a number with the first bit of an unsigned type, which is the sign of a signed type of the same size.
pub(crate) fn has_first_bit(program: &str) -> bool {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let has_first_bit = |ty: ElementaryType, text: &str| {
        let is_unsigned = kind(ty) == Some("integer") && ty.family() != Family::Signed;
        let digits = match text.split_once('#') {
            Some((prefix, digits)) if prefix.parse::<u32>().is_err() => digits,
            _ => text,
        };
        is_unsigned && parsed(digits).is_some_and(|number| number >= 2_f64.powi(ty.bits() as i32 - 1))
    };
    let mut numbers = all.iter().enumerate().filter_map(|(at, token)| {
        let is_number = matches!(token.kind, ProgramTokenKind::Number | ProgramTokenKind::Typed);
        let ty = prefix_type(token).or_else(|| names.target(&all, at))?;
        is_number.then_some((ty, token.text))
    });
    numbers.any(|(ty, text)| has_first_bit(ty, text))
}

/// Returns whether a program converts between durations and numbers, and the engine counts them in seconds where milliseconds are
/// expected.
fn counts_seconds(program: &str, deviation: &Deviation) -> bool {
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

/// Returns the first value that a program has wrong: what it must be, and what it is.
fn first_wrong(deviation: &Deviation) -> Option<(&Value, &Value)> {
    let first = wrong_values(&deviation.expected, &deviation.got).next();
    first.map(|(_, values)| values)
}

/// Returns the first number that a program has wrong: what it must be, and what it is.
fn wrong_numbers(deviation: &Deviation) -> Option<(f64, f64)> {
    let (value, other) = first_wrong(deviation)?;
    Some((number(value)?, number(other)?))
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
    use stickler_run::{Fact, Grade, Verdict};

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
    fn a_number_alone_says_how_it_came_about() {
        let of =
            |program: &str, expected: &str, got: &str| number_pattern(program, &deviation(expected, got));
        for (program, expected, got, is_known) in [
            (
                "into := REAL_TO_UINT(data); data : REAL := -8.0;",
                "UINT#65528",
                "UINT#0",
                true,
            ),
            ("into := REAL_TO_UINT(REAL#1.5);", "UINT#1", "UINT#2", false),
            (
                "into := REAL_TO_ULINT(data); data : REAL := -9.223372E18;",
                "ULINT#9223372036854775808",
                "ULINT#0",
                true,
            ),
            (
                "into := REAL_TO_LINT(data); data : REAL := -9.223373E18;",
                "LINT#9223370937343148032",
                "LINT#-9223372036854775808",
                true,
            ),
            (
                "into[0] := REAL_TO_UINT(-data); data : REAL := 2.0;",
                "UINT#65534",
                "UINT#0",
                true,
            ),
            (
                "VAR n : SINT; END_VAR FOR n := -127 TO -127 DO into := n; END_FOR;",
                "SINT#-127",
                "SINT#0",
                true,
            ),
            (
                "VAR n : SINT; END_VAR FOR n := -127 TO -127 DO into := SINT_TO_INT(n); END_FOR;",
                "INT#-127",
                "INT#0",
                false,
            ),
            (
                "VAR n : INT; END_VAR FOR n := -127 TO -127 DO into := n; END_FOR;",
                "INT#-127",
                "INT#0",
                false,
            ),
            ("into := INT_TO_REAL(INT#8);", "REAL#65528.0", "REAL#0.0", false),
            ("into := REAL_TO_UINT(data * 2.0);", "UINT#65528", "UINT#0", false),
            (
                "into := 9223372036854775807;",
                "LINT#9223372036854775807",
                "LINT#-9223372036854775616",
                true,
            ),
            (
                "into := 18446744073709551615;",
                "ULINT#18446744073709551615",
                "ULINT#384",
                true,
            ),
            (
                "into := 18446744073709551615;",
                "ULINT#18446744073709551615",
                "ULINT#0",
                true,
            ),
            (
                "into := 18446744073709551615;",
                "ULINT#18446744073709551615",
                "ULINT#5000",
                false,
            ),
            ("into := 70000;", "LINT#70000", "LINT#69999", false),
            (
                "into := a + b;",
                "LINT#9223372036854775807",
                "LINT#9223372036854775806",
                false,
            ),
            (
                "into : LREAL := REAL#0.1;",
                "LREAL#0.10000000149011612",
                "LREAL#0.1",
                true,
            ),
            (
                "into : LREAL := REAL#1.0E-45;",
                "LREAL#1.401298464324817E-45",
                "LREAL#1.0E-45",
                true,
            ),
            (
                "into : LREAL := LREAL#0.1;",
                "LREAL#0.10000000149011612",
                "LREAL#0.1",
                false,
            ),
            (
                "into : LREAL := REAL#0.1;",
                "LREAL#0.10000000149011612",
                "LREAL#0.0",
                false,
            ),
        ] {
            assert_eq!(of(program, expected, got).is_some(), is_known, "{program} {got}");
        }
    }

    #[test]
    fn the_first_bit_of_an_unsigned_type_is_half_of_its_range() {
        for (program, is_there) in [
            ("a : BYTE := 16#80; END_VAR", true),
            ("a : BYTE := 16#7F; END_VAR", false),
            ("a : ULINT := 18446744073709551610; END_VAR", true),
            ("a : INT := -1; END_VAR", false),
            ("r := a < UINT#40000;", true),
            ("r := a < UINT#16#4000;", false),
        ] {
            assert_eq!(has_first_bit(&format!("VAR {program}")), is_there, "{program}");
        }
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
