//! Comparison of two values of one type, and the least and greatest of several.

use crate::conversion::real::single;
use crate::instruction::ComparisonOperator;
use std::cmp::Ordering;
use stickler_types::{ElementaryType, Family};

/// Returns whether the operator holds for two raw forms of a type. A NaN is unequal to everything, itself included,
/// and -0.0 equals 0.0. Basis: IEC 60559.
#[inline]
pub fn compare(operator: ComparisonOperator, ty: ElementaryType, left: u64, right: u64) -> bool {
    holds(operator, order(ty, left, right))
}

/// Orders two raw forms of a type; `None` where one is a NaN.
#[inline]
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

/// Returns whether the second of two values lies further in a direction than the first; a number does rather than a
/// NaN. Basis: IEC 60559 (minNum, maxNum).
pub fn lies_further(ty: ElementaryType, further: Ordering, second: u64, first: u64) -> bool {
    match order(ty, second, first) {
        Some(order) => order == further,
        None => order(ty, first, first).is_none(),
    }
}
