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
/// infinity is 0, as such a number is as an integer, or the least duration.
///
/// # Errors
/// `DivisionByZero` where the divisor is zero, a real one too: a duration has no infinity to give.
pub(super) fn scale(
    operator: ArithmeticOperator,
    ty: ElementaryType,
    (duration, number): (u64, u64),
    is_least: bool,
) -> Result<u64, Halt> {
    match operator {
        ArithmeticOperator::Multiply if ty.is_real() => {
            Ok(product(duration, real::decode(number, ty), is_least))
        }
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

fn product(duration: u64, number: f64, is_least: bool) -> u64 {
    if !number.is_finite() {
        return if is_least { i64::MIN.cast_unsigned() } else { 0 };
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
