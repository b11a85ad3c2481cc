//! The list of boundary values of each elementary type, as the tables of the suite go through it.
//!
//! Basis: conformance-cases/README.md (boundary values).

use crate::{ElementaryType, Family, Value, WrittenValue};

/// Returns the boundary values of a type, each once; integers and bit strings in ascending order.
///
/// The ids of cases are made of these literals, so that a value may be added but none be changed or taken away:
///
/// * integers and bit strings: the limits and one inside them, 0, 1, -1, each power of two and one beside it; of signed types also
///   what lies beside the limits of the narrower ones, and two numbers that reals cannot hold;
/// * reals: both zeros, halves, the limits of the integer types, 2^24+1 and 2^53+1 and their neighbours, the smallest, the largest
///   subnormal, the smallest normal and the largest finite numbers of both signs, the neighbours of 1;
/// * BOOL: both; every other type: a short list.
pub fn boundaries(ty: ElementaryType) -> Vec<WrittenValue> {
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => integers(ty)
            .into_iter()
            .map(|number| WrittenValue::of(Value::plain(ty, ty.wrap(number))))
            .collect(),
        Family::Real => reals(ty),
        _ => short_list(ty)
            .iter()
            .filter_map(|literal| WrittenValue::parse(ty, literal).ok())
            .collect(),
    }
}

/// Returns one ordinary value of a type: neither its zero nor one that another type could not hold.
pub fn ordinary(ty: ElementaryType) -> Option<WrittenValue> {
    WrittenValue::parse(ty, ordinary_literal(ty)).ok()
}

/// Returns a value of a type that shows whether it is converted as its type says: a number with its sign or its highest bit set, and more
/// digits than a REAL holds where the type has them, but no more than an LREAL holds.
pub fn telling(ty: ElementaryType) -> Option<WrittenValue> {
    use ElementaryType as E;
    let literal = match ty {
        E::Sint => "-127",
        E::Int => "-32767",
        E::Dint => "-2147483647",
        E::Lint => "-9007199254740991",
        E::Usint => "255",
        E::Uint => "65535",
        E::Udint => "4294967295",
        E::Ulint => "9223372036854777856",
        E::Byte => "16#A5",
        E::Word => "16#A55A",
        E::Dword => "16#A55A0FF1",
        E::Lword => "16#A55A0FF1C33C8001",
        E::Real => "-0.1",
        E::Lreal => "-1.0000000000000002",
        _ => ordinary_literal(ty),
    };
    WrittenValue::parse(ty, literal).ok()
}

/// Returns an ordinary value of a type that is not `value`.
pub fn other_than(ty: ElementaryType, value: Option<&Value>) -> Option<WrittenValue> {
    let candidates = [ordinary_literal(ty), second_literal(ty)];
    candidates
        .into_iter()
        .filter_map(|literal| WrittenValue::parse(ty, literal).ok())
        .find(|other| Some(&other.value) != value)
}

/// Returns the limits and one inside them, 0, 1, -1, each power of two and one beside it; for signed types also the numbers
/// beside the limits of the narrower ones, and two numbers that reals cannot hold.
fn integers(ty: ElementaryType) -> Vec<i128> {
    let Some((least, greatest)) = ty.integer_range() else {
        return Vec::new();
    };
    let mut numbers = vec![least, least + 1, greatest - 1, greatest, 0, 1, -1];
    for bit in 0..ty.bits() {
        numbers.extend([1 << bit, (1 << bit) + 1]);
    }
    if ty.is_signed() {
        for bits in [8, 16, 32] {
            numbers.extend([-(1 << (bits - 1)), -(1 << (bits - 1)) - 1]);
        }
        numbers.extend([-((1 << 24) + 1), -((1 << 53) + 1)]);
    }
    numbers.retain(|number| (least..=greatest).contains(number));
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// The literals that both real types accept, each with its own rounding: 2^24+1 is not a REAL, and 2^53+1 not an LREAL.
const REALS: &[&str] = &[
    "0.0",
    "-0.0",
    "1.0",
    "-1.0",
    "0.5",
    "-0.5",
    "1.5",
    "2.5",
    "0.1",
    "-0.1",
    "127.0",
    "128.0",
    "255.0",
    "256.0",
    "32767.0",
    "32768.0",
    "65535.0",
    "65536.0",
    "8388608.0",
    "8388609.0",
    "16777215.0",
    "16777216.0",
    "16777217.0",
    "-16777217.0",
    "16777218.0",
    "2147483648.0",
    "4294967296.0",
    "9007199254740991.0",
    "9007199254740992.0",
    "9007199254740993.0",
    "-9007199254740993.0",
    "9007199254740994.0",
    "9223372036854775808.0",
    "18446744073709551616.0",
];

/// Returns the values of [`REALS`], and the numbers at the ends of the type: the smallest, the largest subnormal, the
/// smallest normal, the largest but one and the largest finite, of both signs, and the neighbours of 1.
fn reals(ty: ElementaryType) -> Vec<WrittenValue> {
    let mut values: Vec<_> = REALS
        .iter()
        .filter_map(|literal| WrittenValue::parse(ty, literal).ok())
        .collect();
    let (sign, fraction, one, largest) = match ty {
        ElementaryType::Real => (1_u64 << 31, 1_u64 << 23, 0x3F80_0000, 0x7F7F_FFFF),
        _ => (1 << 63, 1 << 52, 0x3FF0_0000_0000_0000, 0x7FEF_FFFF_FFFF_FFFF),
    };
    for raw in [1, fraction - 1, fraction, largest - 1, largest] {
        values.extend([raw, raw | sign].map(|raw| WrittenValue::of(Value::plain(ty, raw))));
    }
    values.extend([one - 1, one + 1].map(|raw| WrittenValue::of(Value::plain(ty, raw))));
    values
}

/// Returns the short lists of the other types. A TIME has the limits of 32 bits of milliseconds, and one value beyond.
fn short_list(ty: ElementaryType) -> &'static [&'static str] {
    use ElementaryType as E;
    match ty {
        E::Time => &[
            "TIME#0ms",
            "TIME#1ms",
            "TIME#-1ms",
            "TIME#1.5ms",
            "TIME#1d2h3m4s5ms",
            "TIME#2147483647ms",
            "TIME#2147483648ms",
            "TIME#4294967295ms",
            "TIME#4294967296ms",
        ],
        E::Ltime => &[
            "LTIME#0ns",
            "LTIME#1ns",
            "LTIME#-1ns",
            "LTIME#1ms",
            "LTIME#1d2h3m4s5ms",
            "LTIME#2147483648ms",
            "LTIME#4294967296ms",
        ],
        E::Date => &[
            "DATE#1970-01-01",
            "DATE#2000-02-29",
            "DATE#2024-02-29",
            "DATE#2038-01-19",
            "DATE#2106-02-07",
        ],
        E::Ldate => &[
            "LDATE#1970-01-01",
            "LDATE#2024-02-29",
            "LDATE#2038-01-20",
            "LDATE#2106-02-08",
        ],
        E::Tod => &[
            "TOD#00:00:00",
            "TOD#00:00:00.001",
            "TOD#12:34:56.789",
            "TOD#23:59:59.999",
        ],
        E::Ltod => &["LTOD#00:00:00", "LTOD#12:34:56.789", "LTOD#23:59:59.999999999"],
        E::Dt => &[
            "DT#1970-01-01-00:00:00",
            "DT#2024-02-29-12:34:56",
            "DT#2038-01-19-03:14:08",
        ],
        E::Ldt => &[
            "LDT#1970-01-01-00:00:00",
            "LDT#2024-02-29-12:34:56.789",
            "LDT#2106-02-07-06:28:16",
        ],
        E::String => &["''", "'a'", "'abc'", "'it$'s'", "'$$'"],
        E::Wstring => &["\"\"", "\"a\"", "\"abc\"", "\"$20AC\""],
        E::Char => &["'a'", "'Z'", "'$41'", "'$FF'"],
        E::Wchar => &["\"a\"", "\"Z\"", "\"$20AC\"", "\"$FFFF\""],
        _ => &[],
    }
}

fn ordinary_literal(ty: ElementaryType) -> &'static str {
    use ElementaryType as E;
    match ty {
        E::Bool => "TRUE",
        E::Byte | E::Word | E::Dword | E::Lword => "16#01",
        E::Real | E::Lreal => "1.5",
        E::Time => "TIME#1ms",
        E::Ltime => "LTIME#1ms",
        E::Date => "DATE#2024-02-29",
        E::Ldate => "LDATE#2024-02-29",
        E::Tod => "TOD#12:34:56",
        E::Ltod => "LTOD#12:34:56",
        E::Dt => "DT#2024-02-29-12:34:56",
        E::Ldt => "LDT#2024-02-29-12:34:56",
        E::String => "'abc'",
        E::Char => "'a'",
        E::Wstring => "\"abc\"",
        E::Wchar => "\"a\"",
        _ => "1",
    }
}

fn second_literal(ty: ElementaryType) -> &'static str {
    use ElementaryType as E;
    match ty {
        E::Bool => "FALSE",
        E::Byte | E::Word | E::Dword | E::Lword => "16#02",
        E::Real | E::Lreal => "2.5",
        E::Time => "TIME#2ms",
        E::Ltime => "LTIME#2ms",
        E::Date => "DATE#2000-02-29",
        E::Ldate => "LDATE#2000-02-29",
        E::Tod => "TOD#01:02:03",
        E::Ltod => "LTOD#01:02:03",
        E::Dt => "DT#2000-02-29-01:02:03",
        E::Ldt => "LDT#2000-02-29-01:02:03",
        E::String => "'xyz'",
        E::Char => "'x'",
        E::Wstring => "\"xyz\"",
        E::Wchar => "\"x\"",
        _ => "2",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn literals(ty: ElementaryType) -> Vec<String> {
        boundaries(ty)
            .iter()
            .map(|value| value.literal.to_string())
            .collect()
    }

    #[test]
    fn a_narrow_integer_has_these_boundaries() {
        assert_eq!(
            literals(ElementaryType::Sint).join(" "),
            "-128 -127 -1 0 1 2 3 4 5 8 9 16 17 32 33 64 65 126 127"
        );
        assert_eq!(literals(ElementaryType::Bool), ["FALSE", "TRUE"]);
        assert_eq!(literals(ElementaryType::Byte)[..3], ["16#00", "16#01", "16#02"]);
    }

    #[test]
    fn wider_integers_have_the_values_at_which_shortcuts_show() {
        let has = |ty, literal: &str| assert!(literals(ty).iter().any(|known| known == literal), "{literal}");
        for literal in [
            "16777217",
            "9007199254740993",
            "-9223372036854775808",
            "-16777217",
            "-129",
            "2147483648",
        ] {
            has(ElementaryType::Lint, literal);
        }
        has(ElementaryType::Ulint, "18446744073709551615");
        has(ElementaryType::Dint, "-32769");
        has(ElementaryType::Udint, "2147483649");
    }

    #[test]
    fn reals_have_their_ends_and_both_zeros() {
        let has = |ty, raw| {
            assert!(
                boundaries(ty)
                    .iter()
                    .any(|known| known.value == Value::plain(ty, raw)),
                "{raw:X}"
            );
        };
        for raw in [0, 1 << 31, 1, 0x0080_0000, 0x7F7F_FFFF, 0xFF7F_FFFF] {
            has(ElementaryType::Real, raw);
        }
        for raw in [
            0,
            1 << 63,
            1,
            1 << 52,
            f64::MAX.to_bits(),
            f64::MIN.to_bits(),
            16_777_217_f64.to_bits(),
        ] {
            has(ElementaryType::Lreal, raw);
        }
    }

    #[test]
    fn every_type_has_boundaries_each_once_and_each_reads_back() {
        for ty in ElementaryType::ALL {
            let values = boundaries(ty);
            assert!(values.len() >= 2, "{}", ty.name());
            for (at, value) in values.iter().enumerate() {
                assert_eq!(value.value.type_name(), ty.name());
                assert_eq!(
                    WrittenValue::parse(ty, &value.literal).as_ref(),
                    Ok(value),
                    "{}",
                    value.literal
                );
                assert!(
                    values[..at].iter().all(|other| other.literal != value.literal),
                    "{}",
                    value.literal
                );
            }
        }
    }

    #[test]
    fn the_short_lists_are_literals_of_their_types() {
        for ty in ElementaryType::ALL {
            let list = short_list(ty);
            assert!(
                list.iter()
                    .all(|literal| WrittenValue::parse(ty, literal).is_ok()),
                "{}",
                ty.name()
            );
        }
    }

    #[test]
    fn there_is_always_another_value() {
        for ty in ElementaryType::ALL {
            let ordinary = ordinary(ty).unwrap().value;
            assert_eq!(other_than(ty, None).unwrap().value, ordinary, "{}", ty.name());
            assert_ne!(
                other_than(ty, Some(&ordinary)).unwrap().value,
                ordinary,
                "{}",
                ty.name()
            );
        }
    }
}
