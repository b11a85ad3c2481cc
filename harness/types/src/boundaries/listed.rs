//! The list of boundary values of each elementary type, as the tables of the suite go through it.
//!
//! Basis: conformance-cases/README.md (boundary values).

use crate::{ElementaryType, Family, Value, WrittenValue};
use std::sync::LazyLock;

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
        _ => parsed(ty),
    }
}

/// The literals of a type that are listed rather than computed.
struct ListedLiterals {
    ordinary: &'static str,
    other: &'static str,
    telling: &'static str,
    boundaries: Vec<&'static str>,
}

/// The lists of all types, in the order of [`ElementaryType::ALL`].
static LISTS: LazyLock<Vec<ListedLiterals>> = LazyLock::new(|| {
    let lines = include_str!("literals.txt")
        .lines()
        .filter(|line| !line.starts_with('#'));
    let lists = lines.map(|line| {
        let mut columns = line.split(" | ").skip(1).map(str::trim);
        let mut next = || columns.next().unwrap_or_default();
        ListedLiterals {
            ordinary: next(),
            other: next(),
            telling: next(),
            boundaries: next().split_whitespace().collect(),
        }
    });
    lists.collect()
});

fn listed(ty: ElementaryType) -> &'static ListedLiterals {
    &LISTS[ty as usize]
}

/// Returns one ordinary value of a type: neither its zero nor one that another type could not hold.
pub fn ordinary(ty: ElementaryType) -> Option<WrittenValue> {
    WrittenValue::parse(ty, listed(ty).ordinary).ok()
}

/// Returns a value of a type that shows whether it is converted as its type says: a number with its sign or its highest bit set, and more
/// digits than a REAL holds where the type has them, but no more than an LREAL holds.
pub fn telling(ty: ElementaryType) -> Option<WrittenValue> {
    WrittenValue::parse(ty, listed(ty).telling).ok()
}

/// Returns an ordinary value of a type that is not `value`.
pub fn other_than(ty: ElementaryType, value: Option<&Value>) -> Option<WrittenValue> {
    let candidates = [listed(ty).ordinary, listed(ty).other].into_iter();
    candidates
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

/// Returns the listed values, and the numbers at the ends of the type: the smallest, the largest subnormal, the
/// smallest normal, the largest but one and the largest finite, of both signs, and the neighbours of 1.
fn reals(ty: ElementaryType) -> Vec<WrittenValue> {
    let mut values = parsed(ty);
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

/// Returns the values of the list of a type.
fn parsed(ty: ElementaryType) -> Vec<WrittenValue> {
    let literals = listed(ty).boundaries.iter();
    literals
        .filter_map(|literal| WrittenValue::parse(ty, literal).ok())
        .collect()
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
    fn every_listed_literal_is_one_of_its_type() {
        assert_eq!(LISTS.len(), ElementaryType::ALL.len());
        for ty in ElementaryType::ALL {
            assert_eq!(parsed(ty).len(), listed(ty).boundaries.len(), "{ty}");
            assert!(ordinary(ty).is_some() && telling(ty).is_some(), "{ty}");
        }
        for (line, ty) in include_str!("literals.txt")
            .lines()
            .filter(|line| !line.starts_with('#'))
            .zip(ElementaryType::ALL)
        {
            assert!(line.starts_with(&format!("{ty} ")), "{line}");
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
