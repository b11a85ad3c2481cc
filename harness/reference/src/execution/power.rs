//! The operator `**`.
//!
//! Basis: iec-61131-3: Table 71 names the operator; how it rounds is open. Here an integer base with an
//! integer exponent is multiplied with itself and wraps; everything else is the `pow` of IEC 60559 in 64 bits,
//! rounded once more for a REAL base. That is the one operation whose last bit may depend on the platform.

use crate::conversion::real;
use crate::instruction::FaultKind;
use crate::raw::narrow;
use stickler_types::ElementaryType;

/// Base raised to exponent, in the type of the base.
///
/// # Errors
/// `DivisionByZero` for an integer zero with a negative exponent, and for a real one where that `stops`.
pub fn power(
    (base_type, base): (ElementaryType, u64),
    (exponent_type, exponent): (ElementaryType, u64),
    stops: bool,
) -> Result<u64, FaultKind> {
    if !base_type.is_real() {
        let exponent = exponent_type.integer_value(exponent);
        return integer_power(base, exponent).map(|bits| narrow(bits, base_type));
    }
    let base = real::decode(base, base_type);
    let (result, is_finite) = if exponent_type.is_real() {
        let exponent = real::decode(exponent, exponent_type);
        (base.powf(exponent), exponent.is_finite())
    } else {
        (real_power(base, exponent_type.integer_value(exponent)), true)
    };
    if stops && base == 0.0 && is_finite && result.is_infinite() {
        return Err(FaultKind::DivisionByZero);
    }
    Ok(real::encode(result, base_type))
}

/// Modulo 2^64. A negative exponent gives 1 divided by the power, cut toward zero, so that only 1 and -1 give
/// something other than 0.
fn integer_power(base: u64, exponent: i128) -> Result<u64, FaultKind> {
    if exponent >= 0 {
        return Ok(wrapping_power(base, exponent.unsigned_abs()));
    }
    match base.cast_signed() {
        0 => Err(FaultKind::DivisionByZero),
        1 | -1 => Ok(wrapping_power(base, exponent.unsigned_abs())),
        _ => Ok(0),
    }
}

fn wrapping_power(mut base: u64, mut exponent: u128) -> u64 {
    let mut result = 1_u64;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result.wrapping_mul(base);
        }
        base = base.wrapping_mul(base);
        exponent >>= 1;
    }
    result
}

/// An integer exponent may be too long for an LREAL; its parity, which decides the sign, is taken beforehand.
fn real_power(base: f64, exponent: i128) -> f64 {
    let magnitude = base.abs().powf(exponent as f64);
    if base.is_sign_negative() && exponent & 1 == 1 {
        -magnitude
    } else {
        magnitude
    }
}
