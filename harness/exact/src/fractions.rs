//! Fractions of any size, with which tests compute exactly what the crate rounds.

use crate::real::{self, Real};
use num_bigint::BigInt;
use num_rational::Ratio;
use stickler_types::ElementaryType;

/// A number of any size and precision.
pub(crate) type Fraction = Ratio<BigInt>;

/// Returns `number * base^exponent`.
pub(crate) fn scaled(number: impl Into<BigInt>, base: u32, exponent: i32) -> Fraction {
    Fraction::from_integer(number.into()) * Fraction::from_integer(base.into()).pow(exponent)
}

/// Returns the number of a raw form; `None` where it is not finite.
pub(crate) fn of_raw(raw: u64, ty: ElementaryType) -> Option<Fraction> {
    let Real::Finite(number) = real::decode(raw, ty) else {
        return None;
    };
    let magnitude = scaled(number.significand, 2, number.exponent);
    Some(if number.negative { -magnitude } else { magnitude })
}

/// Returns how far two numbers are apart.
pub(crate) fn distance(one: &Fraction, other: &Fraction) -> Fraction {
    if one > other { one - other } else { other - one }
}
