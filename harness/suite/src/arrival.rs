//! What arrives when a value is implicitly converted, by exact arithmetic on integers.
//!
//! This is the suite's own arithmetic, independent of the reference and of the host's floating point: it says what a `yes` in
//! a matrix asserts. Basis: stickler-design §3.2 and §8.

use stickler_types::{ElementaryType, Family, Value};

/// What is known about the value that arrives.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Arrival {
    /// Exactly this value.
    Exactly(Value),
    /// The target cannot hold the value, and no document says what it holds instead: it is recorded.
    Open,
}

/// The number of nanoseconds in a millisecond, which is what numbers for a TIME count.
const MILLISECOND: i128 = 1_000_000;

/// What arrives in a variable of type `target`; nothing for pairs of types that this arithmetic knows nothing of.
pub(crate) fn arrives(value: &Value, target: ElementaryType) -> Option<Arrival> {
    let (source, raw) = match *value {
        Value::Plain { ty, raw } => (ty, raw),
        Value::Text { ty, .. } => return (ty == target).then(|| Arrival::Exactly(value.clone())),
        Value::Enumerated { .. } => return None,
    };
    if source == target {
        return Some(Arrival::Exactly(value.clone()));
    }
    let exactly = |raw| Some(Arrival::Exactly(Value::plain(target, raw)));
    let is_number = |ty: ElementaryType| ty.integer_range().is_some();
    match (source, target) {
        (ElementaryType::Real, ElementaryType::Lreal) => exactly(widen(raw)),
        (ElementaryType::Udint, ElementaryType::Time) => {
            let nanoseconds = source.integer_value(raw) * MILLISECOND;
            i64::try_from(nanoseconds)
                .ok()
                .and_then(|nanoseconds| exactly(nanoseconds.cast_unsigned()))
        }
        (ElementaryType::Time, ElementaryType::Udint) => {
            let nanoseconds = i128::from(raw.cast_signed());
            let whole = nanoseconds % MILLISECOND == 0;
            Some(if whole {
                number(nanoseconds / MILLISECOND, target)
            } else {
                Arrival::Open
            })
        }
        _ if is_number(source) && is_number(target) => Some(number(source.integer_value(raw), target)),
        (_, ElementaryType::Real) if source.is_integer() => {
            exactly(nearest(source.integer_value(raw), SINGLE))
        }
        (_, ElementaryType::Lreal) if source.is_integer() => {
            exactly(nearest(source.integer_value(raw), DOUBLE))
        }
        _ if source.long_form() == Some(target) || target.long_form() == Some(source) => {
            (source.family() != Family::Text).then(|| Arrival::Exactly(Value::plain(target, raw)))
        }
        _ => None,
    }
}

fn number(number: i128, target: ElementaryType) -> Arrival {
    match target.integer_range() {
        Some((least, greatest)) if (least..=greatest).contains(&number) => {
            Arrival::Exactly(Value::plain(target, target.wrap(number)))
        }
        _ => Arrival::Open,
    }
}

/// A binary format of IEC 60559.
#[derive(Clone, Copy)]
struct Format {
    /// The bits of the fraction, without the leading one.
    fraction: u32,
    /// The bits of the exponent.
    exponent: u32,
}

const SINGLE: Format = Format {
    fraction: 23,
    exponent: 8,
};
const DOUBLE: Format = Format {
    fraction: 52,
    exponent: 11,
};

impl Format {
    const fn bias(self) -> u64 {
        (1 << (self.exponent - 1)) - 1
    }
}

/// The bits of the real that is nearest to an integer below 2^64 in magnitude; of two that are equally near, the even one.
fn nearest(number: i128, format: Format) -> u64 {
    let magnitude = number.unsigned_abs();
    if magnitude == 0 {
        return 0;
    }
    let sign = u64::from(number < 0) << (format.fraction + format.exponent);
    let top = magnitude.ilog2();
    let significand = match top.checked_sub(format.fraction) {
        None | Some(0) => magnitude << (format.fraction - top),
        Some(dropped) => {
            let kept = magnitude >> dropped;
            let rest = magnitude & ((1 << dropped) - 1);
            let half = 1 << (dropped - 1);
            kept + u128::from(rest > half || (rest == half && kept & 1 == 1))
        }
    };
    // A carry out of the fraction runs into the exponent, which is then right.
    let exponent = u64::from(top) + format.bias() - 1;
    let significand = u64::try_from(significand).unwrap_or(u64::MAX);
    sign | ((exponent << format.fraction) + significand)
}

/// The bits of the LREAL that equals the REAL with these bits.
fn widen(raw: u64) -> u64 {
    let fraction = raw & ((1 << SINGLE.fraction) - 1);
    let exponent = (raw >> SINGLE.fraction) & 0xFF;
    let sign = (raw >> 31 & 1) << 63;
    let spare = DOUBLE.fraction - SINGLE.fraction;
    let magnitude = match (exponent, fraction) {
        (0, 0) => 0,
        (0, _) => {
            // A subnormal number is fraction * 2^-149, which is normal in the wider format.
            let top = fraction.ilog2();
            let exponent = DOUBLE.bias() + u64::from(top) - 149;
            let without_top = fraction ^ (1 << top);
            (exponent << DOUBLE.fraction) | (without_top << (DOUBLE.fraction - top))
        }
        (0xFF, _) => (0x7FF << DOUBLE.fraction) | (fraction << spare),
        _ => ((exponent + DOUBLE.bias() - SINGLE.bias()) << DOUBLE.fraction) | (fraction << spare),
    };
    sign | magnitude
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrives_as(value: &str, target: ElementaryType) -> Option<String> {
        match arrives(&Value::parse(value).unwrap(), target)? {
            Arrival::Exactly(value) => Some(value.to_string()),
            Arrival::Open => Some("open".to_owned()),
        }
    }

    #[test]
    fn known_values_arrive_as_what_they_are() {
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
                arrives_as(value, target),
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
            assert_eq!(arrives_as(value, target), None, "{value} to {}", target.name());
        }
    }

    #[test]
    fn a_number_that_does_not_fit_is_open() {
        assert_eq!(
            arrives_as("INT#-1", ElementaryType::Word),
            Some("open".to_owned())
        );
        assert_eq!(
            arrives_as("INT#128", ElementaryType::Sint),
            Some("open".to_owned())
        );
    }

    #[test]
    fn integers_round_as_the_hosts_conversion_does() {
        let mut numbers: Vec<i128> = vec![0, 1, -1, i128::from(i64::MIN), i128::from(u64::MAX)];
        for bit in 1..64 {
            for beside in [-3, -2, -1, 0, 1, 2, 3] {
                numbers.push((1 << bit) + beside);
                numbers.push(-(1 << bit) + beside);
                // Half of the last place of either format, and beside it.
                numbers.push((1 << bit) + (1 << bit >> 24) + beside);
                numbers.push((1 << bit) + 3 * (1 << bit >> 24) + beside);
                numbers.push((1 << bit) + (1 << bit >> 53) + beside);
                numbers.push((1 << bit) + 3 * (1 << bit >> 53) + beside);
            }
        }
        for number in numbers {
            assert_eq!(
                nearest(number, DOUBLE),
                (number as f64).to_bits(),
                "{number} as LREAL"
            );
            assert_eq!(
                nearest(number, SINGLE),
                u64::from((number as f32).to_bits()),
                "{number} as REAL"
            );
        }
    }

    #[test]
    fn reals_widen_as_the_hosts_conversion_does() {
        let mut patterns: Vec<u32> = vec![0, 1, 2, 3, 0x007F_FFFF, 0x0080_0000, 0x7F7F_FFFF, 0x7F80_0000];
        patterns.extend((0..32).map(|bit| 1 << bit));
        patterns.extend((0..255).map(|exponent| (exponent << 23) | 0x0055_5555));
        for pattern in patterns
            .into_iter()
            .flat_map(|pattern| [pattern, pattern | 0x8000_0000])
        {
            let expected = f64::from(f32::from_bits(pattern));
            assert_eq!(widen(pattern.into()), expected.to_bits(), "{pattern:08X}");
        }
    }
}
