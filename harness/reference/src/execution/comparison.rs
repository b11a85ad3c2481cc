//! Comparison of two values of one type, and the least and greatest of several.

use crate::conversion::real::single;
use crate::instruction::ComparisonOperator;
use std::cmp::Ordering;
use stickler_types::{ElementaryType, Family};

/// Returns whether the operator holds for two raw forms of a type. A NaN is unequal to everything, itself included,
/// and -0.0 equals 0.0. Basis: IEC 60559.
#[inline]
#[must_use]
pub fn compare(operator: ComparisonOperator, ty: ElementaryType, left: u64, right: u64) -> bool {
    holds(operator, order(ty, left, right))
}

/// Orders two raw forms of a type; `None` where one is a NaN.
#[inline]
#[must_use]
pub fn order(ty: ElementaryType, left: u64, right: u64) -> Option<Ordering> {
    match ty.family() {
        Family::Signed | Family::Duration | Family::Date | Family::TimeOfDay | Family::DateAndTime => {
            Some(left.cast_signed().cmp(&right.cast_signed()))
        }
        Family::Real if ty == ElementaryType::Real => single(left).partial_cmp(&single(right)),
        Family::Real => f64::from_bits(left).partial_cmp(&f64::from_bits(right)),
        _ => Some(left.cmp(&right)),
    }
}

/// Returns whether an operator holds for operands of this order.
#[inline]
#[must_use]
pub fn holds(operator: ComparisonOperator, order: Option<Ordering>) -> bool {
    match operator {
        ComparisonOperator::Equal => order == Some(Ordering::Equal),
        ComparisonOperator::NotEqual => order != Some(Ordering::Equal),
        ComparisonOperator::LessOrGreater => order.is_some_and(Ordering::is_ne),
        ComparisonOperator::Less => order == Some(Ordering::Less),
        ComparisonOperator::LessOrEqual => order.is_some_and(Ordering::is_le),
        ComparisonOperator::Greater => order == Some(Ordering::Greater),
        ComparisonOperator::GreaterOrEqual => order.is_some_and(Ordering::is_ge),
    }
}

/// The one of two values that lies further in a direction; the first of equal ones, and a number rather than a
/// NaN. Basis: IEC 60559 (minNum, maxNum).
#[must_use]
pub fn extreme(ty: ElementaryType, further: Ordering, first: u64, second: u64) -> u64 {
    match order(ty, second, first) {
        Some(order) if order == further => second,
        None if order(ty, first, first).is_none() => second,
        _ => first,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Dword, Int, Lreal, Time, Ulint};

    #[test]
    fn signed_types_order_by_sign_and_the_others_do_not() {
        let (minus_one, one) = (u64::MAX, 1);
        assert!(compare(ComparisonOperator::Less, Int, minus_one, one));
        assert!(compare(ComparisonOperator::Less, Time, minus_one, one));
        assert!(compare(ComparisonOperator::Greater, Ulint, minus_one, one));
        assert!(compare(
            ComparisonOperator::GreaterOrEqual,
            Dword,
            0x8000_0000,
            one
        ));
    }

    #[test]
    fn a_nan_is_unequal_to_everything_and_orders_with_nothing() {
        let (nan, one) = (f64::NAN.to_bits(), 1.0_f64.to_bits());
        assert!(compare(ComparisonOperator::NotEqual, Lreal, nan, nan));
        for operator in [
            ComparisonOperator::LessOrGreater,
            ComparisonOperator::Equal,
            ComparisonOperator::Less,
            ComparisonOperator::LessOrEqual,
            ComparisonOperator::Greater,
            ComparisonOperator::GreaterOrEqual,
        ] {
            assert!(!compare(operator, Lreal, nan, one), "{operator:?}");
        }
        let zeros = (0.0_f64.to_bits(), (-0.0_f64).to_bits());
        assert!(compare(ComparisonOperator::Equal, Lreal, zeros.0, zeros.1));
    }

    #[test]
    fn an_extreme_is_a_number_where_there_is_one() {
        let (nan, one, two) = (f64::NAN.to_bits(), 1.0_f64.to_bits(), 2.0_f64.to_bits());
        assert_eq!(extreme(Lreal, Ordering::Less, nan, one), one);
        assert_eq!(extreme(Lreal, Ordering::Less, one, nan), one);
        assert_eq!(extreme(Lreal, Ordering::Less, two, one), one);
        assert_eq!(extreme(Lreal, Ordering::Greater, one, two), two);
    }
}
