//! Values as they stand in programs and tables.

use stickler_types::{ElementaryType, Value};

/// From here on a real has so many digits that they say less than an exponent.
const LARGE: f64 = 1e16;

/// How many characters of a value are shown to people.
const LONGEST: usize = 40;

/// A text as it is shown to people: the beginning of a long one.
pub fn shortened(text: &str) -> String {
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    let beginning: String = text.chars().take(LONGEST - 1).collect();
    format!("{beginning}…")
}

/// The literal of an operand as a program writes it.
///
/// A whole real has all of its digits: `2147483648.0`, where the canonical spelling of a REAL has the fewest that read
/// back to the same bits, `2147483600.0`. That is easier on people, and on compilers that read a REAL by way of an LREAL.
pub fn literal(value: &Value) -> String {
    match number(value) {
        Some(number) if number.abs() < LARGE && number == number.trunc() => format!("{number:.1}"),
        _ => value.literal(),
    }
}

/// The number that a real stands for; exactly, since every REAL is an LREAL.
pub fn number(value: &Value) -> Option<f64> {
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

#[cfg(test)]
mod tests {
    use super::literal;
    use stickler_types::Value;

    #[test]
    fn a_whole_real_has_all_of_its_digits_and_reads_back() {
        let value = Value::parse("REAL#2147483648.0").unwrap();
        assert_eq!(literal(&value), "2147483648.0");
        assert_eq!(
            Value::parse("REAL#-0.0").map(|zero| literal(&zero)).unwrap(),
            "-0.0"
        );
        for text in [
            "REAL#0.1",
            "REAL#16777216.0",
            "REAL#3.4028235E38",
            "LREAL#9007199254740993.0",
            "LREAL#-1.5",
        ] {
            let value = Value::parse(text).unwrap();
            let again = Value::parse(&format!("{}#{}", value.type_name(), literal(&value))).unwrap();
            assert_eq!(again, value, "{text}");
        }
    }
}
