//! Durations multiplied and divided by numbers.
//!
//! Basis: iec-61131-3: functions of time and duration data types, which leaves rounding open: by an integer
//! the quotient is cut toward zero as integers are, by a real number the exact result is rounded once to the
//! nearest nanosecond, ties to even.

use super::stop::Halt;
use crate::conversion::real::{self, Exact};
use crate::instruction::{ArithmeticOperator, FaultKind};
use stickler_types::{ElementaryType, Rounding};

/// A duration times or divided by a number of the type, modulo 2^64 nanoseconds. A product with NaN or an
/// infinity is 0, as such a number is as an integer.
///
/// # Errors
/// `DivisionByZero` where the divisor is zero, a real one too: a duration has no infinity to give.
pub(super) fn scale(
    operator: ArithmeticOperator,
    ty: ElementaryType,
    duration: u64,
    number: u64,
) -> Result<u64, Halt> {
    match operator {
        ArithmeticOperator::Multiply if ty.is_real() => Ok(product(duration, real::decode(number, ty))),
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop if ty.is_real() => {
            Ok(quotient(duration, real::decode(number, ty))?)
        }
        ArithmeticOperator::Multiply => Ok(duration.wrapping_mul(number)),
        ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop => {
            Ok(integer_quotient(duration, ty.integer_value(number))?)
        }
        _ => Err(Halt::Missing("meaning for this operator on a duration")),
    }
}

fn integer_quotient(duration: u64, number: i128) -> Result<u64, FaultKind> {
    let quotient = i128::from(duration.cast_signed())
        .checked_div(number)
        .ok_or(FaultKind::DivisionByZero)?;
    // The low 64 bits: only the least duration divided by -1 wraps.
    Ok(quotient as u64)
}

fn product(duration: u64, number: f64) -> u64 {
    if !number.is_finite() {
        return 0;
    }
    let nanoseconds = duration.cast_signed();
    let (significand, exponent) = real::parts(number);
    Exact {
        negative: (nanoseconds < 0) != number.is_sign_negative(),
        magnitude: u128::from(nanoseconds.unsigned_abs()) * u128::from(significand),
        inexact: false,
        exponent,
    }
    .to_integer()
}

fn quotient(duration: u64, number: f64) -> Result<u64, FaultKind> {
    if number == 0.0 {
        return Err(FaultKind::DivisionByZero);
    }
    if !number.is_finite() {
        return Ok(0);
    }
    let nanoseconds = duration.cast_signed();
    let (significand, exponent) = real::parts(number);
    let negative = (nanoseconds < 0) != number.is_sign_negative();
    let exact = Exact::quotient(
        negative,
        nanoseconds.unsigned_abs().into(),
        significand,
        -exponent,
    );
    if exact.exponent < 0 {
        Ok(exact.to_integer())
    } else {
        // Far outside the range of a duration, where the low bits of the quotient are not known: it wraps as
        // the LREAL next to it does.
        Ok(real::to_integer(
            nanoseconds as f64 / number,
            Rounding::HalfToEven,
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ArithmeticOperator::{Divide, Multiply};
    use ElementaryType::{Int, Lreal, Real, Usint};

    fn by_real(operator: ArithmeticOperator, duration: i64, number: f64) -> Result<i64, Halt> {
        scale(operator, Lreal, duration.cast_unsigned(), number.to_bits()).map(u64::cast_signed)
    }

    #[test]
    fn an_integer_factor_is_exact_and_a_quotient_is_cut() {
        let minus_two = (-2_i64).cast_unsigned();
        assert_eq!(
            scale(Multiply, Int, 1_500, minus_two),
            Ok((-3_000_i64).cast_unsigned())
        );
        assert_eq!(scale(Divide, Int, 7, minus_two), Ok((-3_i64).cast_unsigned()));
        assert_eq!(
            scale(Divide, Usint, 7, 0),
            Err(Halt::Fault(FaultKind::DivisionByZero))
        );
    }

    #[test]
    fn a_real_factor_is_rounded_once() {
        // 2^60 + 1 does not fit an LREAL: multiplying by way of one would lose the last nanosecond.
        let long = (1 << 60) + 1;
        assert_eq!(by_real(Multiply, long, 1.0), Ok(long));
        assert_eq!(by_real(Divide, long, 1.0), Ok(long));
        assert_eq!(by_real(Multiply, 3, 0.5), Ok(2));
        assert_eq!(by_real(Multiply, 5, 0.5), Ok(2));
        assert_eq!(by_real(Divide, -3, 2.0), Ok(-2));
        assert_eq!(by_real(Divide, 1, 3.0), Ok(0));
        assert_eq!(by_real(Divide, long, -4.0), Ok(-(1 << 58)));
        assert_eq!(scale(Multiply, Real, 1_000, real::of_single(1.5)), Ok(1_500));
    }

    #[test]
    fn a_number_that_is_none_gives_no_time_at_all() {
        assert_eq!(by_real(Multiply, 5, f64::NAN), Ok(0));
        assert_eq!(by_real(Divide, 5, f64::INFINITY), Ok(0));
        assert_eq!(
            by_real(Divide, 5, -0.0),
            Err(Halt::Fault(FaultKind::DivisionByZero))
        );
        assert_eq!(by_real(Divide, 1 << 62, f64::MIN_POSITIVE), Ok(0));
    }
}
