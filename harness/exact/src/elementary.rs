//! The standard functions of real numbers, to the nearest number of their type.
//!
//! Each is computed as an interval of numbers of [`PRECISION`] binary places; both of its ends are rounded, and where they differ nothing is stated.
//!
//! Basis: iec-61131-3: Tables 28 and 29 (the functions); IEC 60559: roundTiesToEven.

use crate::real::{self, Finite, Real};
use crate::{Operation, Signature, integer, quotient};
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::sync::LazyLock;
use stickler_types::{DialectName, ElementaryType, Value};

/// The binary places of a number: those of the least LREAL, and as many as an angle of the greatest one loses.
const PRECISION: u32 = 2600;

/// The binary digits of the greatest error of a number: those of the multiple of pi that an angle is reduced by, and more than the steps of any
/// function add up to.
const ERROR_BITS: u32 = 1100;

/// A number in units of `2^-PRECISION`, times a power of two.
type Scaled = (BigInt, i32);

/// Returns the number of a type that is nearest to what SQRT, LN, LOG, EXP, SIN, COS, TAN, ASIN, ACOS, ATAN, ATAN2 or EXPT gives for numbers.
///
/// `None` for another function, for an operand that is no finite number, for a result that is no real number, where the function is not defined or
/// has no number (LN of 0), where the sign of a zero among two operands decides, and where the interval decides nothing: the operands are too far
/// apart, or the result lies in the middle between two numbers.
pub fn nearest_result(function: &str, operands: &[Value], result: ElementaryType) -> Option<Value> {
    let numbers: Vec<BigInt> = operands.iter().map(fixed).collect::<Option<_>>()?;
    let is_negative_zero = |value: &Value| value.real().map(f64::to_bits) == Some(1 << 63);
    if !result.is_real() || numbers.len() == 2 && operands.iter().any(is_negative_zero) {
        return None;
    }
    // A zero of an odd function keeps its sign.
    if let ([Value::Plain { ty, raw }], "SQRT" | "SIN" | "TAN" | "ASIN" | "ATAN") = (operands, function)
        && numbers[0].is_zero()
    {
        return Some(Value::plain(result, real::between(*raw, *ty, result)));
    }
    let (number, exponent) = scaled(function, &numbers)?;
    let error = BigInt::one() << ERROR_BITS;
    let ends = [&number - &error, number + error].map(|end| rounded(&end, exponent, result));
    let negative_zero = result.real_bits(-0.0);
    match ends {
        [low, high] if low == high => Some(Value::plain(result, low)),
        // The interval is around zero, and holds no other number.
        [low, 0] if low == negative_zero => Some(Value::plain(result, 0)),
        _ => None,
    }
}

/// The functions of one real number, of which SQRT is exact.
const OF_REALS: [&str; 10] = [
    "SQRT", "LN", "LOG", "EXP", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN",
];

/// Returns the signatures of a standard function of one operand in a dialect, by its name in upper case: of ABS, NOT, LEN and the functions of one
/// real number. LEN gives an INT, each of the others the type of its operand. They are no conversions, so that [`crate::signatures`] does not have
/// them.
pub fn elementary_signatures(function: &str, dialect: DialectName) -> Vec<Signature> {
    let takes = |ty: &ElementaryType| match function {
        "ABS" => ty.is_number(),
        "NOT" => ty.is_bit_string(),
        "LEN" => *ty == ElementaryType::String || ty.is_text() && dialect.rules().wide_text_functions,
        name => ty.is_real() && OF_REALS.contains(&name),
    };
    let has = |word: &str| !dialect.rules().lacks(&word.to_ascii_lowercase());
    let types = ElementaryType::ALL.into_iter().filter(takes);
    let types = types.filter(|ty| has(function) && has(ty.name()));
    let signature = |ty: ElementaryType| Signature {
        function: function.to_owned(),
        operands: vec![ty],
        result: if ty.is_text() { ElementaryType::Int } else { ty },
        operation: Operation::Elementary,
    };
    types.map(signature).collect()
}

/// Returns the result of a function of [`elementary_signatures`], of a function of real numbers the nearest one; `None` where
/// [`nearest_result`] has none, and for the ABS of what is no number. LEN gives the number of code units.
pub fn elementary_result(signature: &Signature, operand: &Value) -> Option<Value> {
    let (ty, raw) = match operand {
        Value::Plain { ty, raw } => (*ty, *raw),
        Value::Text { units, .. } if signature.function == "LEN" => {
            let length = integer::wrapped(units.len() as i128, signature.result);
            return Some(Value::plain(signature.result, length));
        }
        _ => return None,
    };
    let result = match &*signature.function {
        "NOT" => ty.wrap(!i128::from(raw)),
        "ABS" if ty.is_integer() => integer::wrapped(integer::number(raw, ty).abs(), ty),
        "ABS" => match real::decode(raw, ty) {
            Real::NotANumber => return None,
            _ => raw & !ty.real_bits(-0.0),
        },
        "SQRT" if ty == ElementaryType::Real => match real::decode(raw, ty) {
            Real::Finite(finite) if !finite.negative && finite.significand != 0 => single_root(finite),
            Real::Finite(zero) if zero.significand == 0 => raw,
            _ => return None,
        },
        name => return nearest_result(name, std::slice::from_ref(operand), signature.result),
    };
    Some(Value::plain(ty, result))
}

/// Returns the raw form of the REAL that is nearest to the square root of a positive REAL, for a sweep of all of them.
fn single_root(of: Finite) -> u64 {
    // With 49 or 50 bits and an even exponent, so that the root has 25 bits.
    let widest = of.significand.leading_zeros().cast_signed() - 14;
    let shift = widest - (of.exponent - widest).rem_euclid(2);
    let square = of.significand << shift;
    let root = square.isqrt();
    let (kept, is_half, is_more) = (root >> 1, root & 1, u64::from(root * root != square));
    let rounded = kept + (is_half & (is_more | kept & 1));
    // The leading bit, which is not written, adds one to the exponent.
    let biased = (of.exponent - shift) / 2 + 150;
    (u64::from(biased.cast_unsigned()) << 23) + rounded
}

/// Returns the section of the standard that has a function of [`elementary_signatures`].
pub(crate) fn elementary_basis(function: &str) -> &'static str {
    match function {
        "ABS" | "SQRT" => "iec-61131-3: Table 28",
        "NOT" => "iec-61131-3: Table 30",
        "LEN" => "iec-61131-3: Table 34",
        _ => "rule: reals-within-units",
    }
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
        Real::Finite(finite) if ty.is_real() => {
            let number = BigInt::from(finite.significand) << PRECISION.checked_add_signed(finite.exponent)?;
            Some(if finite.negative { -number } else { number })
        }
        _ => None,
    }
}

/// Rounds a number once; what rounds to zero keeps its sign.
fn rounded(number: &BigInt, exponent: i32, to: ElementaryType) -> u64 {
    let power = |exponent: i32| BigUint::one() << u32::try_from(exponent).unwrap_or(0);
    let binary = exponent - PRECISION as i32;
    let numerator = number.magnitude() * power(binary);
    quotient::nearest(number.is_negative(), &numerator, &power(-binary), to)
}

fn scaled(function: &str, numbers: &[BigInt]) -> Option<Scaled> {
    let number = match (function, numbers) {
        ("EXP", [x]) => return exponential(x),
        ("EXPT", [base, exponent]) => return power(base, exponent),
        ("SQRT", [x]) if !x.is_negative() => root(x),
        ("LN", [x]) if x.is_positive() => logarithm(x),
        ("LOG", [x]) if x.is_positive() => quotient(&logarithm(x), &logarithm(&(one() * 10))),
        ("SIN", [x]) => sine_and_cosine(x).0,
        ("COS", [x]) => sine_and_cosine(x).1,
        ("TAN", [x]) => {
            let (sine, cosine) = sine_and_cosine(x);
            quotient(&sine, &cosine)
        }
        ("ASIN", [x]) if x.abs() <= one() => arc_sine(x),
        ("ACOS", [x]) if x.abs() <= one() => &*HALF_PI - arc_sine(x),
        ("ATAN", [x]) => arc_tangent(x, &one()),
        ("ATAN2", [y, x]) if !x.is_zero() || !y.is_zero() => {
            let angle = arc_tangent(y, &x.abs());
            match (x.is_negative(), y.is_negative()) {
                (false, _) => angle,
                (true, false) => &*HALF_PI * 2 - angle,
                (true, true) => -&*HALF_PI * 2 - angle,
            }
        }
        _ => return None,
    };
    Some((number, 0))
}

fn one() -> BigInt {
    BigInt::one() << PRECISION
}

/// Multiplies two numbers; the product is cut toward zero, so that a series ends.
fn product(a: &BigInt, b: &BigInt) -> BigInt {
    let product = a * b;
    BigInt::from_biguint(product.sign(), product.magnitude() >> PRECISION)
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

/// Returns the inverse hyperbolic tangent of a number near 0 for a `sign` of 1, and its arc tangent for -1.
fn inverse_tangent(x: &BigInt, sign: i32) -> BigInt {
    let square = product(x, x) * sign;
    series(
        x.clone(),
        |term, _| product(term, &square),
        |number| 2 * number + 1,
    )
}

static LOGARITHM_OF_TWO: LazyLock<BigInt> = LazyLock::new(|| inverse_tangent(&(one() / 3), 1) * 2);

/// Half of pi, by Machin's formula.
static HALF_PI: LazyLock<BigInt> = LazyLock::new(|| {
    let of = |divisor: u32| inverse_tangent(&(one() / divisor), -1);
    of(5) * 8 - of(239) * 2
});

fn logarithm(x: &BigInt) -> BigInt {
    // Of a number from 3/4 to 3/2 times a power of two.
    let four_thirds: BigInt = x * 4_u32 / 3_u32;
    let exponent = four_thirds.bits() as i64 - 1 - i64::from(PRECISION);
    let (above, below) = match exponent >= 0 {
        true => (x.clone(), one() << exponent),
        false => (x << -exponent, one()),
    };
    let number = quotient(&(&above - &below), &(above + below));
    inverse_tangent(&number, 1) * 2 + &*LOGARITHM_OF_TWO * exponent
}

/// `None` of a number so great that what it gives would not fit in memory; it is infinite or 0 in any type long before.
fn exponential(x: &BigInt) -> Option<Scaled> {
    let two = &*LOGARITHM_OF_TWO;
    let exponent = x
        .div_floor(two)
        .to_i32()
        .filter(|exponent| exponent.abs() < 100_000)?;
    let rest = x - two * exponent;
    let next = |term: &BigInt, number| product(term, &rest) / number;
    Some((series(one(), next, |_| 1), exponent))
}

fn sine_and_cosine(x: &BigInt) -> (BigInt, BigInt) {
    let quarter = &*HALF_PI;
    let turns = Integer::div_floor(&(x * 2_u32 + quarter), &(quarter * 2_u32));
    let rest = x - &turns * quarter;
    let square = product(&rest, &rest);
    let of = |first: BigInt, odd: u32| {
        let next = |term: &BigInt, number: u32| {
            -product(term, &square) / ((2 * number - 1 + odd) * (2 * number + odd))
        };
        series(first, next, |_| 1)
    };
    let (sine, cosine) = (of(rest, 1), of(one(), 0));
    match turns.mod_floor(&BigInt::from(4)).to_u8() {
        Some(0) => (sine, cosine),
        Some(1) => (cosine, -sine),
        Some(2) => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

fn arc_sine(x: &BigInt) -> BigInt {
    arc_tangent(x, &root(&(one() - product(x, x))))
}

/// The angle from -pi/2 to pi/2 of the point with an ordinate and an abscissa that is not negative.
fn arc_tangent(y: &BigInt, x: &BigInt) -> BigInt {
    if y.is_negative() {
        return -arc_tangent(&-y, x);
    }
    if y > x {
        return &*HALF_PI - arc_tangent(x, y);
    }
    let mut tangent = quotient(y, x);
    // Each step halves the angle, so that the series is short.
    for _ in 0..3 {
        tangent = quotient(&tangent, &(one() + root(&(one() + product(&tangent, &tangent)))));
    }
    inverse_tangent(&tangent, -1) * 8
}

fn power(base: &BigInt, exponent: &BigInt) -> Option<Scaled> {
    let is_odd = (exponent >> PRECISION).is_odd();
    match () {
        () if exponent.is_zero() => Some((one(), 0)),
        () if base.is_zero() => exponent.is_positive().then(|| (BigInt::zero(), 0)),
        // The error of the logarithm is multiplied by the exponent.
        () if exponent.bits() > u64::from(PRECISION + ERROR_BITS / 2) => None,
        () if base.is_positive() => exponential(&product(exponent, &logarithm(base))),
        () if (exponent % one()).is_zero() => {
            let (number, scale) = power(&-base, exponent)?;
            Some((if is_odd { -number } else { number }, scale))
        }
        () => None,
    }
}
