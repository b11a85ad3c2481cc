//! The list of boundary values of each elementary type, as the tables of the suite go through it.
//!
//! Basis: conformance-cases/README.md (boundary values).

use crate::{ElementaryType, Family, Value, WrittenValue, sorted};
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
    sorted(numbers)
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

    #[test]
    fn every_type_has_boundaries_each_once_and_each_reads_back() {
        for ty in ElementaryType::ALL {
            let values = boundaries(ty);
            assert!(values.len() >= 2, "{}", ty.name());
            for (at, value) in values.iter().enumerate() {
                assert_eq!(value.value.type_name(), ty.name());
                let literal = &value.literal;
                assert_eq!(WrittenValue::parse(ty, literal).as_ref(), Ok(value), "{literal}");
                assert!(
                    values[..at].iter().all(|other| other.literal != *literal),
                    "{literal}"
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
        let lines = include_str!("literals.txt").lines();
        let lines = lines.filter(|line| !line.starts_with('#'));
        for (line, ty) in lines.zip(ElementaryType::ALL) {
            assert!(line.starts_with(&format!("{ty} ")), "{line}");
        }
    }

    #[test]
    fn there_is_always_another_value() {
        for ty in ElementaryType::ALL {
            let ordinary = ordinary(ty).unwrap().value;
            let other = |value| other_than(ty, value).unwrap().value;
            assert_eq!(other(None), ordinary, "{ty}");
            assert_ne!(other(Some(&ordinary)), ordinary, "{ty}");
        }
    }
}
