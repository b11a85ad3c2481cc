//! Real numbers: ties and what lies beside them, the limits of the integer types, and the ends of the format itself.

use super::integers::limits;
use crate::operand::Operand;
use stickler_types::{ElementaryType, Value};

/// `REAL` and `LREAL`.
pub const REALS: [ElementaryType; 2] = [ElementaryType::Real, ElementaryType::Lreal];

/// The operands with these decimal numbers, each rounded once to the type, by value; each once, those that would be infinite
/// left out.
#[must_use]
pub fn by_value(ty: ElementaryType, numbers: &[String]) -> Vec<Operand> {
    let literals = numbers
        .iter()
        .filter_map(|number| Value::parse(&format!("{ty}#{number}")).ok());
    sorted(literals.map(Operand::of).collect())
}

/// Operands by value, each once; -0.0 stands before 0.0.
#[must_use]
pub fn sorted(mut operands: Vec<Operand>) -> Vec<Operand> {
    operands.sort_by_key(order);
    operands.dedup_by(|a, b| a.value == b.value);
    operands
}

/// A number that grows with the value of a real that is no NaN.
fn order(operand: &Operand) -> i128 {
    let Value::Plain { ty, raw } = operand.value else {
        return 0;
    };
    let sign = 1_u64 << (ty.bits() - 1);
    let magnitude = i128::from(raw & !sign);
    if raw & sign == 0 {
        magnitude
    } else {
        -magnitude - 1
    }
}

/// The decimal number that is `halves` halves.
fn halves(halves: i128) -> String {
    let sign = if halves < 0 { "-" } else { "" };
    let magnitude = halves.unsigned_abs();
    format!(
        "{sign}{}.{}",
        magnitude / 2,
        if magnitude.is_multiple_of(2) { "0" } else { "5" }
    )
}

/// Fractions, ties, and the limits of an integer type with what lies half beside them.
#[must_use]
pub fn for_integer(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    const SMALL: [&str; 18] = [
        "0.0", "0.25", "0.5", "0.75", "1.0", "1.5", "2.5", "2.9999", "3.5", "99.99", "-0.25", "-0.5",
        "-0.75", "-1.0", "-1.5", "-2.5", "-3.5", "-99.99",
    ];
    let (least, greatest) = limits(to);
    let mut numbers: Vec<String> = SMALL.map(str::to_owned).into();
    numbers.extend([2 * least, 2 * least + 1].map(halves));
    numbers.extend([-2, -1, 0, 1].map(|beside| halves(2 * greatest + beside)));
    by_value(from, &numbers)
}

/// What lies outside an integer type: one past its limits, at and past its modulus.
#[must_use]
pub fn outside(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    let (least, greatest) = limits(to);
    let modulus: i128 = 1 << to.bits();
    let mut numbers: Vec<String> = [
        2 * (greatest + 1),
        2 * (least - 1),
        2 * least - 3,
        2 * greatest + 5,
        2 * (modulus + 5),
        2 * (-modulus - 7),
    ]
    .map(halves)
    .into();
    numbers.push("1.0E20".to_owned());
    by_value(from, &numbers)
}

/// More of what lies outside, up to the greatest numbers of `REAL`.
#[must_use]
pub fn far_outside(from: ElementaryType, to: ElementaryType) -> Vec<Operand> {
    let mut numbers = vec![halves(2 << to.bits())];
    numbers.extend(["1.0E10", "-1.0E10", "123456789.75", "-123456789.75", "3.0E38"].map(str::to_owned));
    let mut operands = outside(from, to);
    operands.extend(by_value(from, &numbers));
    sorted(operands)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Lreal, Real, Sint};

    #[test]
    fn numbers_are_rounded_once_sorted_and_each_once() {
        let numbers = ["16777217.0", "-1.5", "16777216.0", "0.0", "-0.0", "1.0E99"].map(str::to_owned);
        let literals: Vec<String> = by_value(Real, &numbers)
            .into_iter()
            .map(|operand| operand.literal)
            .collect();
        assert_eq!(literals, ["-1.5", "-0.0", "0.0", "16777216.0"]);
    }

    #[test]
    fn the_limits_of_a_type_have_their_halves() {
        let literals: Vec<String> = for_integer(Lreal, Sint)
            .into_iter()
            .map(|operand| operand.literal)
            .collect();
        for literal in ["-128.0", "-127.5", "126.0", "126.5", "127.0", "127.5"] {
            assert!(literals.iter().any(|l| l == literal), "{literal} in {literals:?}");
        }
        assert!(!literals.iter().any(|l| l == "128.0"));
    }
}
