//! Integers, bit strings and BOOL: limits, powers of two, and what lies beside them.

use crate::operand::Operand;
use stickler_types::ElementaryType;

/// `SINT` … `ULINT`.
pub const INTEGERS: [ElementaryType; 8] = [
    ElementaryType::Sint,
    ElementaryType::Int,
    ElementaryType::Dint,
    ElementaryType::Lint,
    ElementaryType::Usint,
    ElementaryType::Uint,
    ElementaryType::Udint,
    ElementaryType::Ulint,
];

/// `BYTE` … `LWORD`.
pub const BIT_STRINGS: [ElementaryType; 4] = [
    ElementaryType::Byte,
    ElementaryType::Word,
    ElementaryType::Dword,
    ElementaryType::Lword,
];

/// The least and the greatest number of an integer or bit string; 0 and 0 of other types, which have none.
#[must_use]
pub fn limits(ty: ElementaryType) -> (i128, i128) {
    ty.integer_range().unwrap_or((0, 0))
}

/// The operands of a type with these numbers, ascending, each once; numbers that the type does not hold are left out.
#[must_use]
pub fn ascending(ty: ElementaryType, numbers: impl IntoIterator<Item = i128>) -> Vec<Operand> {
    let (least, greatest) = limits(ty);
    let mut numbers: Vec<i128> = numbers
        .into_iter()
        .filter(|number| (least..=greatest).contains(number))
        .collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
        .into_iter()
        .map(|number| Operand::number(ty, number))
        .collect()
}

/// The limits of both types with what lies beside them, 0 and its neighbours, the modulus of the target, and an irregular
/// pattern of bits.
#[must_use]
pub fn for_pair(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    let mut numbers = Vec::new();
    for (least, greatest) in [limits(from), limits(to)] {
        for edge in [least, greatest] {
            numbers.extend([edge - 1, edge, edge + 1]);
        }
    }
    let modulus = 1 << to.bits();
    numbers.extend([-1, 0, 1, modulus, modulus + 1, -modulus, 100_000]);
    numbers.push(limits(from).1 & 0x55AA_33CC_0FF0_A5C3);
    ascending(from, numbers)
}

/// Each power of two that the type holds, and of a signed type its opposite.
#[must_use]
pub fn powers_of_two(ty: ElementaryType) -> Vec<Operand> {
    let powers = (0..64).map(|bit| 1_i128 << bit);
    ascending(ty, powers.flat_map(|power| [-power, power]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Int, Sint, Usint};

    fn literals(operands: &[Operand]) -> Vec<&str> {
        operands.iter().map(|operand| &*operand.literal).collect()
    }

    #[test]
    fn operands_are_within_their_type_and_each_once() {
        assert_eq!(
            literals(&for_pair(Usint, Sint)),
            ["0", "1", "126", "127", "128", "195", "254", "255"]
        );
        assert_eq!(for_pair(Int, Sint).len(), 17);
    }

    #[test]
    fn powers_of_two_have_both_signs_where_the_type_has() {
        assert_eq!(
            literals(&powers_of_two(Sint)),
            [
                "-128", "-64", "-32", "-16", "-8", "-4", "-2", "-1", "1", "2", "4", "8", "16", "32", "64"
            ]
        );
        assert_eq!(powers_of_two(Usint).len(), 8);
    }
}
