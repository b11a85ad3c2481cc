//! Results of operators: integers in 128 bits, wrapped to their type; reals rounded once; durations in nanoseconds; and the order of two
//! values of one type.
//!
//! Basis: rule: integer-overflow-wraps (two's complement of the declared width); iec-61131-3: Table 10 (IEC 60559 in 32 and 64 bits;
//! each operation is rounded once), Table 33 (comparison); the table comparison of the cases states the order type by type.

use super::OpenQuestion;
use super::memory::MemoryCell;
use crate::model::{BinaryOperator, UnaryOperator};
use std::cmp::Ordering;
use stickler_types::{ElementaryType, Family};

/// A value, with the open question that it raises.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Computed {
    /// The raw form of the value.
    pub raw: u64,
    /// The question that no document answers, if there is one.
    pub question: Option<OpenQuestion>,
}

/// The result of an operator with two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Binary {
    /// A value.
    Computed(Computed),
    /// The fault of an integer division by zero.
    DivisionByZero,
    /// No result: the type does not have the operator.
    Undefined,
}

fn settled(raw: u64) -> Computed {
    Computed { raw, question: None }
}

/// Computes a prefix operator; `None` if the type does not have it.
pub(crate) fn unary(operator: UnaryOperator, ty: ElementaryType, raw: u64) -> Option<Computed> {
    match (operator, ty.family()) {
        (UnaryOperator::Negate, Family::Signed) => Some(settled(ty.wrap(-ty.integer_value(raw)))),
        (UnaryOperator::Negate, Family::Duration) => Some(moment(-ty.integer_value(raw))),
        (UnaryOperator::Negate, Family::Real) => Some(settled(negated(ty, raw))),
        (UnaryOperator::Not, Family::Boolean | Family::BitString) => {
            Some(settled(ty.wrap(!ty.integer_value(raw))))
        }
        _ => None,
    }
}

/// Negates a real; NaN stays NaN.
fn negated(ty: ElementaryType, raw: u64) -> u64 {
    raw ^ 1 << (ty.bits() - 1)
}

/// Computes an operator other than a comparison for two operands of one type.
pub(crate) fn binary(operator: BinaryOperator, ty: ElementaryType, a: u64, b: u64) -> Binary {
    match ty.family() {
        Family::Signed | Family::Unsigned => integers(operator, ty, ty.integer_value(a), ty.integer_value(b)),
        Family::Real if ty == ElementaryType::Real => {
            let (a, b) = (f32::from_bits(a as u32), f32::from_bits(b as u32));
            reals(operator, a, b).map_or(Binary::Undefined, |result| {
                real(u64::from(result.to_bits()), result.is_nan(), operator, b == 0.0)
            })
        }
        Family::Real => {
            let (a, b) = (f64::from_bits(a), f64::from_bits(b));
            reals(operator, a, b).map_or(Binary::Undefined, |result| {
                real(result.to_bits(), result.is_nan(), operator, b == 0.0)
            })
        }
        Family::Boolean | Family::BitString => bits(operator, a, b),
        Family::Duration => durations(operator, ty.integer_value(a), ty.integer_value(b)),
        _ => Binary::Undefined,
    }
}

/// Computes an integer operation; division truncates toward zero, and MOD has the sign of the dividend.
///
/// Basis: rule: integer-overflow-wraps; iec-61131-3: Table 29; the table integer-arithmetic of the cases states it for every type.
fn integers(operator: BinaryOperator, ty: ElementaryType, a: i128, b: i128) -> Binary {
    let exact = match operator {
        BinaryOperator::Add => a + b,
        BinaryOperator::Subtract => a - b,
        // Two numbers of 64 bits: their product is below 2^128, and wrapping drops the same bits.
        BinaryOperator::Multiply => a.wrapping_mul(b),
        BinaryOperator::Divide | BinaryOperator::Modulo if b == 0 => return Binary::DivisionByZero,
        BinaryOperator::Divide => a / b,
        BinaryOperator::Modulo => a % b,
        _ => return Binary::Undefined,
    };
    let is_quotient = matches!(operator, BinaryOperator::Divide | BinaryOperator::Modulo);
    let least = ty.integer_range().map(|(least, _)| least);
    let question = (is_quotient && b == -1 && Some(a) == least).then_some(OpenQuestion::LeastByMinusOne);
    Binary::Computed(Computed {
        raw: ty.wrap(exact),
        question,
    })
}

/// Computes one of the four operations on reals, rounded once by the processor.
fn reals<T>(operator: BinaryOperator, a: T, b: T) -> Option<T>
where
    T: std::ops::Add<Output = T>
        + std::ops::Sub<Output = T>
        + std::ops::Mul<Output = T>
        + std::ops::Div<Output = T>,
{
    match operator {
        BinaryOperator::Add => Some(a + b),
        BinaryOperator::Subtract => Some(a - b),
        BinaryOperator::Multiply => Some(a * b),
        BinaryOperator::Divide => Some(a / b),
        _ => None,
    }
}

fn real(raw: u64, is_nan: bool, operator: BinaryOperator, by_zero: bool) -> Binary {
    let question = if operator == BinaryOperator::Divide && by_zero {
        Some(OpenQuestion::RealDivisionByZero)
    } else {
        is_nan.then_some(OpenQuestion::NotANumber)
    };
    Binary::Computed(Computed { raw, question })
}

fn bits(operator: BinaryOperator, a: u64, b: u64) -> Binary {
    let raw = match operator {
        BinaryOperator::And => a & b,
        BinaryOperator::Or => a | b,
        BinaryOperator::Xor => a ^ b,
        _ => return Binary::Undefined,
    };
    Binary::Computed(settled(raw))
}

fn durations(operator: BinaryOperator, a: i128, b: i128) -> Binary {
    match operator {
        BinaryOperator::Add => Binary::Computed(moment(a + b)),
        BinaryOperator::Subtract => Binary::Computed(moment(a - b)),
        _ => Binary::Undefined,
    }
}

/// Stores nanoseconds in the 64 bits of a raw form; raises a question if they do not fit.
fn moment(nanoseconds: i128) -> Computed {
    let outside = i64::try_from(nanoseconds).is_err();
    Computed {
        raw: nanoseconds as u64,
        question: outside.then_some(OpenQuestion::MomentRange),
    }
}

/// Compares two values of a type; `None` if one of them is NaN or not of that type.
///
/// Unsigned integers and bit strings compare as unsigned numbers, texts by their characters; -0.0 equals 0.0.
pub(super) fn compare(ty: ElementaryType, a: &MemoryCell, b: &MemoryCell) -> Option<Ordering> {
    match (a, b) {
        (MemoryCell::Text(a), MemoryCell::Text(b)) => Some(a.cmp(b)),
        (MemoryCell::Plain(a), MemoryCell::Plain(b)) => match (ty.real_value(*a), ty.real_value(*b)) {
            (Some(a), Some(b)) => a.partial_cmp(&b),
            _ => Some(ty.integer_value(*a).cmp(&ty.integer_value(*b))),
        },
        _ => None,
    }
}
