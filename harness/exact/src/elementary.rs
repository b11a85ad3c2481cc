//! The standard functions of real numbers, to the nearest number of their type.
//!
//! Each is computed as an interval of numbers of [`PRECISION`] binary places; both of its ends are rounded, and where they differ nothing is stated.
//!
//! Basis: iec-61131-3: Tables 28 and 29 (the functions); IEC 60559: roundTiesToEven.

use crate::integer;
use crate::real::{self, Finite, Real, nearest};
use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::sync::LazyLock;
use stickler_types::{ElementaryType, Value};

/// The binary places of a number: those of the least LREAL, and as many as an angle of the greatest one loses.
const PRECISION: u32 = 2600;

/// The binary digits of the greatest error of a number: those of the multiple of pi that an angle is reduced by, and more than the steps of any
/// function add up to.
const ERROR_BITS: u32 = 1100;

/// A number in units of `2^-PRECISION`, times a power of two.
type Scaled = (BigInt, i32);

/// Returns the number of a type that is nearest to what SQRT, LN, LOG, EXP, SIN, COS, TAN, ASIN, ACOS, ATAN, ATAN2 or EXPT gives for numbers.
///
/// `None` for another function, for an operand that is no finite number, where the function is not defined or has no number (LN of 0), and where
/// the operands are so far apart that the interval decides nothing.
#[must_use]
pub fn nearest_result(function: &str, operands: &[Value], result: ElementaryType) -> Option<Value> {
    let numbers: Vec<BigInt> = operands.iter().map(fixed).collect::<Option<_>>()?;
    // A zero of an odd function keeps its sign.
    if let ([Value::Plain { ty, raw }], "SQRT" | "SIN" | "TAN" | "ASIN" | "ATAN") = (operands, function)
        && numbers[0].is_zero()
    {
        return Some(Value::plain(result, real::between(*raw, *ty, result)));
    }
    let (number, exponent) = scaled(function, &numbers)?;
    let error = BigInt::one() << ERROR_BITS;
    let ends = [&number - &error, number + error].map(|end| rounded(&end, exponent, result));
    (ends[0] == ends[1]).then_some(Value::plain(result, ends[0]))
}

/// Returns a finite number in units of `2^-PRECISION`.
fn fixed(value: &Value) -> Option<BigInt> {
    let &Value::Plain { ty, raw } = value else {
        return None;
    };
    if ty.is_integer() {
        return Some(BigInt::from(integer::number(raw, ty)) << PRECISION);
    }
    match real::decode(raw, ty) {
        Real::Finite(Finite {
            negative,
            significand,
            exponent,
        }) if ty.is_real() => {
            let number = BigInt::from(significand) << (PRECISION as i32 + exponent).unsigned_abs();
            Some(if negative { -number } else { number })
        }
        _ => None,
    }
}

/// Rounds a number once; what rounds to zero has no sign.
fn rounded(number: &BigInt, exponent: i32, to: ElementaryType) -> u64 {
    let dropped = (number.bits() as u32).saturating_sub(120);
    let magnitude = number.abs();
    let kept = &magnitude >> dropped;
    let sticky = (&kept << dropped) != magnitude;
    let exponent = exponent - PRECISION as i32 + dropped as i32;
    let raw = nearest(false, kept.to_u128().unwrap_or(u128::MAX), sticky, exponent, to);
    match number.sign() == Sign::Minus && raw != 0 {
        true => raw | 1 << (to.bits() - 1),
        false => raw,
    }
}

fn scaled(function: &str, numbers: &[BigInt]) -> Option<Scaled> {
    let one = BigInt::one() << PRECISION;
    match (function, numbers) {
        ("SQRT", [x]) if !x.is_negative() => Some((root(x), 0)),
        ("LN", [x]) if x.is_positive() => Some((logarithm(x), 0)),
        ("LOG", [x]) if x.is_positive() => Some((quotient(&logarithm(x), &logarithm(&(one * 10))), 0)),
        ("EXP", [x]) => exponential(x),
        ("SIN", [x]) => Some((sine_and_cosine(x).0, 0)),
        ("COS", [x]) => Some((sine_and_cosine(x).1, 0)),
        ("TAN", [x]) => {
            let (sine, cosine) = sine_and_cosine(x);
            Some((quotient(&sine, &cosine), 0))
        }
        ("ASIN", [x]) if x.abs() <= one => Some((arc_sine(x), 0)),
        ("ACOS", [x]) if x.abs() <= one => Some((&*HALF_PI - arc_sine(x), 0)),
        ("ATAN", [x]) => Some((arc_tangent(x, &one), 0)),
        ("ATAN2", [y, x]) if !x.is_zero() || !y.is_zero() => {
            let angle = arc_tangent(y, &x.abs());
            Some((
                match (x.is_negative(), y.is_negative()) {
                    (false, _) => angle,
                    (true, false) => &*HALF_PI * 2 - angle,
                    (true, true) => -&*HALF_PI * 2 - angle,
                },
                0,
            ))
        }
        ("EXPT", [base, exponent]) => power(base, exponent),
        _ => None,
    }
}

fn product(a: &BigInt, b: &BigInt) -> BigInt {
    (a * b) >> PRECISION
}

fn quotient(a: &BigInt, b: &BigInt) -> BigInt {
    (a << PRECISION) / b
}

fn root(x: &BigInt) -> BigInt {
    (x << PRECISION).sqrt()
}

/// Adds up `first`, and each term divided by its number, where `next` makes one term of the one before it.
fn series(first: BigInt, next: impl Fn(&BigInt, u32) -> BigInt, divided: impl Fn(u32) -> u32) -> BigInt {
    let (mut sum, mut term, mut number) = (BigInt::zero(), first, 0);
    while !term.is_zero() {
        sum += &term / divided(number);
        number += 1;
        term = next(&term, number);
    }
    sum
}

/// The inverse hyperbolic tangent of a number near 0.
fn hyperbolic_arc_tangent(x: &BigInt) -> BigInt {
    let square = product(x, x);
    series(
        x.clone(),
        |term, _| toward_zero(term * &square),
        |number| 2 * number + 1,
    )
}

/// A product of two numbers in the unit of one, cut toward zero, so that a series ends.
fn toward_zero(product: BigInt) -> BigInt {
    product / (BigInt::one() << PRECISION)
}

static LOGARITHM_OF_TWO: LazyLock<BigInt> =
    LazyLock::new(|| hyperbolic_arc_tangent(&((BigInt::one() << PRECISION) / 3)) * 2);

/// Half of pi, by Machin's formula.
static HALF_PI: LazyLock<BigInt> = LazyLock::new(|| {
    let of = |divisor: u32| inverse_arc_tangent(&((BigInt::one() << PRECISION) / divisor));
    of(5) * 8 - of(239) * 2
});

fn logarithm(x: &BigInt) -> BigInt {
    let one = BigInt::one() << PRECISION;
    // Of a number from 3/4 to 3/2 times a power of two.
    let four_thirds: BigInt = x * 4_u32 / 3_u32;
    let exponent = four_thirds.bits() as i64 - 1 - i64::from(PRECISION);
    let (above, below) = match exponent >= 0 {
        true => (x.clone(), &one << exponent),
        false => (x << -exponent, one),
    };
    let number = quotient(&(&above - &below), &(above + below));
    hyperbolic_arc_tangent(&number) * 2 + &*LOGARITHM_OF_TWO * exponent
}

/// `None` of a number so great that what it gives would not fit in memory; it is infinite or 0 in any type long before.
fn exponential(x: &BigInt) -> Option<Scaled> {
    let two = &*LOGARITHM_OF_TWO;
    let exponent = x
        .div_floor(two)
        .to_i32()
        .filter(|exponent| exponent.abs() < 100_000)?;
    let rest = x - two * exponent;
    let one = BigInt::one() << PRECISION;
    let next = |term: &BigInt, number| toward_zero(term * &rest) / number;
    Some((series(one, next, |_| 1), exponent))
}

/// The arc tangent of a number near 0.
fn inverse_arc_tangent(x: &BigInt) -> BigInt {
    let square = product(x, x);
    series(
        x.clone(),
        |term, _| -toward_zero(term * &square),
        |number| 2 * number + 1,
    )
}

fn sine_and_cosine(x: &BigInt) -> (BigInt, BigInt) {
    let quarter = &*HALF_PI;
    let turns = Integer::div_floor(&(x * 2_u32 + quarter), &(quarter * 2_u32));
    let rest = x - &turns * quarter;
    let square = product(&rest, &rest);
    let of = |first: BigInt, odd: u32| {
        let next = |term: &BigInt, number: u32| {
            -toward_zero(term * &square) / ((2 * number - 1 + odd) * (2 * number + odd))
        };
        series(first, next, |_| 1)
    };
    let (sine, cosine) = (of(rest, 1), of(BigInt::one() << PRECISION, 0));
    match turns.mod_floor(&BigInt::from(4)).to_u8() {
        Some(0) => (sine, cosine),
        Some(1) => (cosine, -sine),
        Some(2) => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

fn arc_sine(x: &BigInt) -> BigInt {
    let one = BigInt::one() << PRECISION;
    arc_tangent(x, &root(&(&one - product(x, x))))
}

/// The angle from -pi/2 to pi/2 of the point with an ordinate and an abscissa that is not negative.
fn arc_tangent(y: &BigInt, x: &BigInt) -> BigInt {
    if y.is_negative() {
        return -arc_tangent(&-y, x);
    }
    if y > x {
        return &*HALF_PI - arc_tangent(x, y);
    }
    let one = BigInt::one() << PRECISION;
    let mut tangent = quotient(y, x);
    // Each step halves the angle, so that the series is short.
    for _ in 0..3 {
        tangent = quotient(&tangent, &(&one + root(&(&one + product(&tangent, &tangent)))));
    }
    inverse_arc_tangent(&tangent) * 8
}

fn power(base: &BigInt, exponent: &BigInt) -> Option<Scaled> {
    let one = BigInt::one() << PRECISION;
    let is_odd = (exponent >> PRECISION).is_odd();
    match () {
        () if exponent.is_zero() => Some((one, 0)),
        () if base.is_zero() => exponent.is_positive().then(|| (BigInt::zero(), 0)),
        // The error of the logarithm is multiplied by the exponent.
        () if exponent.bits() > u64::from(PRECISION + ERROR_BITS / 2) => None,
        () if base.is_positive() => exponential(&product(exponent, &logarithm(base))),
        () if (exponent % one).is_zero() => {
            let (number, scale) = power(&-base, exponent)?;
            Some((if is_odd { -number } else { number }, scale))
        }
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Lreal, Real};

    fn given(function: &str, operands: &[&str], result: ElementaryType) -> Option<String> {
        let operands: Vec<Value> = operands.iter().map(|text| Value::parse(text).unwrap()).collect();
        nearest_result(function, &operands, result).map(|value| value.to_string())
    }

    #[test]
    fn results_are_those_of_tables_of_functions() {
        for (function, operands, result) in [
            ("EXP", &["LREAL#1.0"][..], "LREAL#2.718281828459045"),
            ("ATAN", &["LREAL#1.0"], "LREAL#0.7853981633974483"),
            ("ACOS", &["LREAL#-1.0"], "LREAL#3.141592653589793"),
            ("LN", &["LREAL#2.0"], "LREAL#0.6931471805599453"),
            ("LOG", &["LREAL#1000.0"], "LREAL#3.0"),
            ("SQRT", &["LREAL#2.0"], "LREAL#1.4142135623730951"),
            ("SIN", &["LREAL#-0.0"], "LREAL#-0.0"),
            ("TAN", &["LREAL#1.5707963267948966"], "LREAL#1.633123935319537E16"),
            ("COS", &["LREAL#1.0E22"], "LREAL#0.523214785395139"),
            ("ATAN2", &["LREAL#1.0", "LREAL#-1.0"], "LREAL#2.356194490192345"),
            ("EXPT", &["LREAL#-2.0", "INT#-3"], "LREAL#-0.125"),
            ("EXPT", &["LREAL#10.0", "LREAL#0.5"], "LREAL#3.1622776601683795"),
            ("EXP", &["LREAL#1000.0"], "LREAL#Infinity"),
            ("SIN", &["LREAL#5.0E-324"], "LREAL#5.0E-324"),
            ("ACOS", &["LREAL#1.0"], "LREAL#0.0"),
            ("SIN", &["LREAL#-1.0E-5"], "LREAL#-9.999999999833334E-6"),
        ] {
            assert_eq!(
                given(function, operands, Lreal).as_deref(),
                Some(result),
                "{function} of {operands:?}"
            );
        }
        assert_eq!(
            given("SIN", &["REAL#1.0"], Real).as_deref(),
            Some("REAL#0.84147096")
        );
    }

    #[test]
    fn nothing_is_stated_where_there_is_no_number() {
        for (function, operands) in [
            ("LN", &["LREAL#0.0"][..]),
            ("SQRT", &["LREAL#-1.0"]),
            ("ASIN", &["LREAL#1.5"]),
            ("EXPT", &["LREAL#-8.0", "LREAL#0.5"]),
            ("SIN", &["LREAL#NaN"]),
            ("MIN", &["LREAL#1.0"]),
        ] {
            assert_eq!(
                given(function, operands, Lreal),
                None,
                "{function} of {operands:?}"
            );
        }
    }
}
