//! Real numbers beside a tie or a limit, and at the ends of their format.

use super::integers::limits;
use super::reals::{by_value, sorted};
use crate::operand::Operand;
use stickler_types::{ElementaryType, Value};

/// The number a few places further away from zero in the format of its type, or nearer to it.
#[must_use]
pub fn beside(operand: &Operand, places: i64) -> Operand {
    match operand.value {
        Value::Plain { ty, raw } => Operand::of(Value::plain(ty, raw.wrapping_add_signed(places))),
        _ => operand.clone(),
    }
}

/// An operand and its opposite.
#[must_use]
pub fn both_signs(operand: &Operand) -> [Operand; 2] {
    let opposite = match operand.value {
        Value::Plain { ty, raw } => Value::plain(ty, raw ^ 1 << (ty.bits() - 1)),
        _ => operand.value.clone(),
    };
    [operand.clone(), Operand::of(opposite)]
}

/// The ends of the format: both zeros, the least and greatest subnormal, the least normal and greatest finite number.
#[must_use]
pub fn of_format(ty: ElementaryType) -> Vec<Operand> {
    let fraction_bits = if ty == ElementaryType::Real { 23 } else { 52 };
    let least_normal = 1_u64 << fraction_bits;
    let infinity = ((1_u64 << (ty.bits() - 1)) - 1) & !(least_normal - 1);
    let raws = [0, 1, least_normal - 1, least_normal, infinity - 1];
    raws.iter()
        .flat_map(|&raw| both_signs(&Operand::of(Value::plain(ty, raw))))
        .collect()
}

/// 2^24 and 2^53 with their neighbours among the whole numbers, of both signs.
#[must_use]
pub fn of_precision(ty: ElementaryType) -> Vec<Operand> {
    let numbers = [1_u64 << 24, 1 << 53];
    let numbers = numbers.into_iter().flat_map(|number| number - 1..=number + 2);
    let literals: Vec<String> = numbers
        .flat_map(|number| [format!("{number}.0"), format!("-{number}.0")])
        .collect();
    by_value(ty, &literals)
}

/// What lies next to a tie, next to the limits of an integer type, powers of two, and the ends of the format.
#[must_use]
pub fn for_integer(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    let mut operands = of_format(from);
    operands.extend(of_precision(from));
    for tie in ["0.5", "1.5", "2.5", "3.5"] {
        let tie = Operand::read(from, tie);
        let near = [beside(&tie, -1), beside(&tie, 1)];
        operands.extend(near.iter().flat_map(both_signs));
    }
    let (least, greatest) = limits(to);
    for edge in [least, greatest + 1].into_iter().filter(|&edge| edge != 0) {
        let edge = Operand::read(from, &format!("{edge}.0"));
        operands.extend([-1, 0, 1].map(|places| beside(&edge, places)));
    }
    let powers = (0..=to.bits()).chain([63, 64]);
    for power in powers.map(|bit| 1_i128 << bit) {
        operands.extend(both_signs(&Operand::read(from, &format!("{power}.0"))));
    }
    sorted(operands)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Lreal, Real, Sint};

    fn literals(operands: &[Operand]) -> Vec<&str> {
        operands.iter().map(|operand| &*operand.literal).collect()
    }

    #[test]
    fn the_largest_number_below_a_tie_is_one_place_nearer_to_zero() {
        let half = Operand::read(Real, "0.5");
        assert_eq!(beside(&half, -1).literal, "0.49999997");
        assert_eq!(
            beside(&Operand::read(Lreal, "-0.5"), -1).literal,
            "-0.49999999999999994"
        );
    }

    #[test]
    fn the_ends_of_the_format_are_those_of_the_standard() {
        let real = [
            "0.0",
            "-0.0",
            "1.0E-45",
            "-1.0E-45",
            "1.1754942E-38",
            "-1.1754942E-38",
            "1.1754944E-38",
            "-1.1754944E-38",
            "3.4028235E38",
            "-3.4028235E38",
        ];
        assert_eq!(literals(&of_format(Real)), real);
        assert!(literals(&of_format(Lreal)).contains(&"1.7976931348623157E308"));
    }

    #[test]
    fn the_limits_of_the_target_have_their_neighbours() {
        let operands = for_integer(Real, Sint);
        for literal in ["-128.00002", "-127.99999", "127.99999", "128.0", "128.00002"] {
            assert!(
                literals(&operands).contains(&literal),
                "{literal}: {:?}",
                literals(&operands)
            );
        }
    }
}
