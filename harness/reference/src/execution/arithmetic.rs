//! Arithmetic on two values of one type.
//!
//! Basis: rule: integer-overflow-wraps; iec-61131-3: Table 10 (IEC 60559) for REAL
//! and LREAL, every operation rounded once to the width of its type; durations and dates, of which no source
//! says it, wrap in 64-bit nanoseconds, and times of day within the day.

use crate::conversion::real::{of_single, single};
use crate::instruction::{ArithmeticOperator, FaultKind};
use crate::raw::narrow;
use std::ops::{Add, Div, Mul, Rem, Sub};
use stickler_types::{ElementaryType, Family};

const DAY: i64 = 86_400_000_000_000;

/// The result of an operator on two raw forms of a type.
///
/// # Errors
/// `DivisionByZero` where the divisor is zero; that of a real number only for [`ArithmeticOperator::DivideOrStop`], which also stops
/// where a quotient does not fit.
#[inline]
pub fn arithmetic(
    operator: ArithmeticOperator,
    ty: ElementaryType,
    left: u64,
    right: u64,
) -> Result<u64, FaultKind> {
    match ty.family() {
        _ if operator == ArithmeticOperator::DivideOrStop && has_no_quotient(ty, left, right) => {
            Err(FaultKind::DivisionByZero)
        }
        Family::Signed => signed(operator, left, right).map(|bits| narrow(bits, ty)),
        Family::Real if ty == ElementaryType::Real => {
            Ok(of_single(on_reals(operator, single(left), single(right))))
        }
        Family::Real => Ok(on_reals(operator, f64::from_bits(left), f64::from_bits(right)).to_bits()),
        Family::Duration | Family::Date | Family::DateAndTime => signed(operator, left, right),
        Family::TimeOfDay => signed(operator, left, right)
            .map(|nanoseconds| nanoseconds.cast_signed().rem_euclid(DAY).cast_unsigned()),
        _ => unsigned(operator, left, right).map(|bits| narrow(bits, ty)),
    }
}

/// Returns whether a division has no quotient of the type: a real number by zero, or the least integer by -1.
fn has_no_quotient(ty: ElementaryType, left: u64, right: u64) -> bool {
    match ty {
        ElementaryType::Real => single(right) == 0.0,
        ElementaryType::Lreal => f64::from_bits(right) == 0.0,
        _ => {
            let least = ty.integer_range().map(|(least, _)| least);
            ty.is_signed() && right.cast_signed() == -1 && least == Some(left.cast_signed().into())
        }
    }
}

/// Modulo 2^64, which holds the result modulo any smaller width. The least integer divided by -1 wraps to
/// itself, and its remainder is 0.
#[inline]
fn signed(operator: ArithmeticOperator, left: u64, right: u64) -> Result<u64, FaultKind> {
    let (a, b) = (left.cast_signed(), right.cast_signed());
    let result = match operator {
        ArithmeticOperator::Add => a.wrapping_add(b),
        ArithmeticOperator::Subtract => a.wrapping_sub(b),
        ArithmeticOperator::Multiply => a.wrapping_mul(b),
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop | ArithmeticOperator::Modulo
            if b == 0 =>
        {
            return Err(FaultKind::DivisionByZero);
        }
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop => a.wrapping_div(b),
        ArithmeticOperator::ModuloOrZero if b == 0 => 0,
        ArithmeticOperator::Modulo | ArithmeticOperator::ModuloOrZero => a.wrapping_rem(b),
    };
    Ok(result.cast_unsigned())
}

#[inline]
fn unsigned(operator: ArithmeticOperator, a: u64, b: u64) -> Result<u64, FaultKind> {
    match operator {
        ArithmeticOperator::Add => Ok(a.wrapping_add(b)),
        ArithmeticOperator::Subtract => Ok(a.wrapping_sub(b)),
        ArithmeticOperator::Multiply => Ok(a.wrapping_mul(b)),
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop => {
            a.checked_div(b).ok_or(FaultKind::DivisionByZero)
        }
        ArithmeticOperator::Modulo => a.checked_rem(b).ok_or(FaultKind::DivisionByZero),
        ArithmeticOperator::ModuloOrZero => Ok(a.checked_rem(b).unwrap_or(0)),
    }
}

fn on_reals<R>(operator: ArithmeticOperator, a: R, b: R) -> R
where
    R: Add<Output = R> + Sub<Output = R> + Mul<Output = R> + Div<Output = R> + Rem<Output = R>,
{
    match operator {
        ArithmeticOperator::Add => a + b,
        ArithmeticOperator::Subtract => a - b,
        ArithmeticOperator::Multiply => a * b,
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop => a / b,
        ArithmeticOperator::Modulo | ArithmeticOperator::ModuloOrZero => a % b,
    }
}

/// The negated value; the least integer stays as it is.
#[inline]
pub fn negate(ty: ElementaryType, value: u64) -> u64 {
    match ty {
        ElementaryType::Real => of_single(-single(value)),
        ElementaryType::Lreal => (-f64::from_bits(value)).to_bits(),
        _ if ty.is_moment() => value.wrapping_neg(),
        _ => narrow(value.wrapping_neg(), ty),
    }
}

/// The absolute value; the least integer stays as it is, which is what its negation wraps to.
pub fn absolute(ty: ElementaryType, value: u64) -> u64 {
    match ty {
        ElementaryType::Real => of_single(single(value).abs()),
        ElementaryType::Lreal => f64::from_bits(value).abs().to_bits(),
        _ if (ty.is_signed() || ty.is_duration()) && value.cast_signed() < 0 => negate(ty, value),
        _ => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instruction::ArithmeticOperator::{
        Add, Divide, DivideOrStop, Modulo, ModuloOrZero, Multiply, Subtract,
    };
    use ElementaryType::{Dint, Int, Lint, Lreal, Real, Sint, Udint, Uint, Ulint, Usint};

    /// Computes as the standard's arithmetic does, where nothing can overflow.
    fn exact(operator: ArithmeticOperator, a: i128, b: i128) -> Option<i128> {
        match operator {
            Add => Some(a + b),
            Subtract => Some(a - b),
            Multiply => Some(a.wrapping_mul(b)),
            Divide | DivideOrStop => a.checked_div(b),
            Modulo => a.checked_rem(b),
            ModuloOrZero => a.checked_rem(b).or(Some(0)),
        }
    }

    #[test]
    fn integers_wrap_to_their_width() {
        for ty in [Sint, Int, Dint, Lint, Usint, Uint, Udint, Ulint] {
            let (low, high) = ty.integer_range().expect("an integer has a range");
            let values = [low, low + 1, -1, 0, 1, 2, 3, 7, high / 2, high - 1, high];
            let values = values.into_iter().filter(|value| (low..=high).contains(value));
            for (a, b) in values.clone().flat_map(|a| values.clone().map(move |b| (a, b))) {
                for operator in [Add, Subtract, Multiply, Divide, Modulo, ModuloOrZero] {
                    let expected = exact(operator, a, b).map(|value| ty.wrap(value));
                    let got = arithmetic(operator, ty, ty.wrap(a), ty.wrap(b));
                    assert_eq!(got.ok(), expected, "{a} {operator:?} {b} in {}", ty.name());
                }
            }
        }
    }

    #[test]
    fn a_division_may_stop_where_there_is_no_quotient() {
        let stops = |ty, a, b| arithmetic(DivideOrStop, ty, a, b) == Err(FaultKind::DivisionByZero);
        let (minus_one, zero) = (u64::MAX, (-0.0_f64).to_bits());
        let least = i64::from(i32::MIN).cast_unsigned();
        assert!(
            stops(Dint, least, minus_one) && !stops(Dint, least + 1, minus_one) && !stops(Dint, least, 1)
        );
        assert!(!stops(Lint, least, minus_one) && stops(Lint, 1 << 63, minus_one));
        assert!(!stops(Ulint, 1 << 63, minus_one) && stops(Ulint, 1, 0));
        assert!(stops(Real, of_single(1.0), of_single(0.0)) && stops(Lreal, 1.0_f64.to_bits(), zero));
        assert!(!stops(Real, of_single(0.0), of_single(1.0)));
    }
}
