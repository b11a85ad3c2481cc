//! Exact arithmetic between integers and IEC 60559 numbers: every result is rounded at most once.

use stickler_types::{ElementaryType, Rounding};

/// The number that a REAL or LREAL raw form stands for; exact, since LREAL holds every REAL.
#[inline]
pub fn decode(raw: u64, ty: ElementaryType) -> f64 {
    if ty == ElementaryType::Real {
        f64::from(single(raw))
    } else {
        f64::from_bits(raw)
    }
}

/// The REAL of a raw form.
#[inline]
pub const fn single(raw: u64) -> f32 {
    // A REAL's raw form is zero-extended, so nothing is lost.
    f32::from_bits(raw as u32)
}

/// The raw form of a REAL.
#[inline]
pub fn of_single(value: f32) -> u64 {
    value.to_bits().into()
}

/// Returns whether a raw form stands for something other than zero; only for reals is that not whether it is 0.
#[inline]
pub fn is_nonzero(raw: u64, ty: ElementaryType) -> bool {
    if ty.is_real() {
        decode(raw, ty) != 0.0
    } else {
        raw != 0
    }
}

/// The REAL or LREAL next to the value of an integer's raw form, ties to even. REAL is rounded from the integer
/// itself, not by way of LREAL, which would round twice.
#[inline]
pub fn from_integer(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    // The raw form of a narrower unsigned integer is no negative number either, and signed ones convert quicker.
    match (from.is_signed() || from.bits() < 64, to == ElementaryType::Real) {
        (true, true) => of_single(raw.cast_signed() as f32),
        (false, true) => of_single(raw as f32),
        (true, false) => (raw.cast_signed() as f64).to_bits(),
        (false, false) => (raw as f64).to_bits(),
    }
}

/// REAL to LREAL or back.
#[inline]
pub fn between(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    encode(decode(raw, from), to)
}

/// The raw form of a number as REAL (rounded to nearest, ties to even) or LREAL.
#[inline]
pub fn encode(value: f64, to: ElementaryType) -> u64 {
    if to == ElementaryType::Real {
        of_single(value as f32)
    } else {
        value.to_bits()
    }
}

/// The number rounded to an integer, modulo 2^64; NaN and the infinities give 0.
#[inline]
pub fn to_integer(value: f64, rounding: Rounding) -> u64 {
    if value.abs() < 9.2e18 {
        rounded(value, rounding).cast_unsigned()
    } else {
        wrapped(value)
    }
}

/// A number that 64 bits hold, rounded to an integer. Little is left of it where the rounding is known, as in each loop of
/// [`super::Conversion::apply_to_slice`]; a call would choose the rounding anew for each number.
#[inline(always)]
fn rounded(value: f64, rounding: Rounding) -> i64 {
    let whole = value as i64;
    // Exact: a part of the number's own digits.
    let rest = value - whole as f64;
    let away = match rounding {
        Rounding::Truncate => false,
        Rounding::HalfToEven => rest.abs() > 0.5 || (rest.abs() == 0.5 && whole & 1 == 1),
        Rounding::HalfAwayFromZero => rest.abs() >= 0.5,
        Rounding::Up => rest > 0.0,
        Rounding::Down => rest < 0.0,
        Rounding::AwayFromZero => rest != 0.0,
    };
    match (away, value < 0.0) {
        (false, _) => whole,
        (true, false) => whole + 1,
        (true, true) => whole - 1,
    }
}

/// The number rounded to a whole one; NaN and the infinities stay.
pub fn to_whole(value: f64, rounding: Rounding) -> f64 {
    // Numbers from 2^52 on have no fraction.
    let has_fraction = value.abs() < 4_503_599_627_370_496.0;
    if has_fraction {
        (rounded(value, rounding) as f64).copysign(value)
    } else {
        value
    }
}

/// The number rounded to an integer, or the limit of the target that lies next to it, the infinities included;
/// NaN gives 0. The target is an integer or a bit string.
#[inline]
pub fn to_nearest_of(value: f64, rounding: Rounding, to: ElementaryType) -> u64 {
    let Some((low, high)) = to.integer_range() else {
        return 0;
    };
    // What 128 bits do not hold becomes their limit, and a NaN 0.
    let integer = if value.abs() < 9.2e18 {
        rounded(value, rounding).into()
    } else {
        value as i128
    };
    let nearest: i128 = integer.clamp(low, high);
    // Within the limits the low 64 bits are the raw form.
    nearest as u64
}

/// The number rounded to an integer of 64 bits, as [`stickler_types::OutOfRange::Indefinite64`] describes it; the low bits are
/// those of the target.
#[inline]
pub fn to_integer_of_64_bits(value: f64, rounding: Rounding, to: ElementaryType) -> u64 {
    const LIMIT: f64 = 18_446_744_073_709_551_616.0;
    let integer = match checked(value, rounding) {
        Some(integer) => integer,
        // Numbers from 2^63 on have no fraction.
        None if to.bits() == 64 && value > 0.0 && value < LIMIT => wrapped(value).cast_signed(),
        None => i64::MIN,
    };
    let held = if value < 0.0 && to.bits() <= 32 {
        integer.max(i32::MIN.into())
    } else {
        integer
    };
    held.cast_unsigned()
}

/// The number rounded to an integer of 32 bits, as [`stickler_types::OutOfRange::Indefinite32`] describes it.
#[inline]
pub fn to_integer_of_32_bits(value: f64, rounding: Rounding) -> u64 {
    let integer = checked(value, rounding).filter(|integer| i32::try_from(*integer).is_ok());
    integer.unwrap_or(i32::MIN.into()).cast_unsigned()
}

/// The number rounded to an integer; `None` where 64 bits do not hold it, and for a NaN.
#[inline(always)]
fn checked(value: f64, rounding: Rounding) -> Option<i64> {
    const LIMIT: f64 = 9_223_372_036_854_775_808.0;
    // Numbers next to the limits have no fraction.
    (-LIMIT..LIMIT).contains(&value).then(|| rounded(value, rounding))
}

/// A number of 2^62 or more, which has no fraction, modulo 2^64. NaN and the infinities have the greatest
/// exponent, at which no bits are left of any number.
#[inline]
fn wrapped(value: f64) -> u64 {
    let (magnitude, exponent) = parts(value);
    let bits = magnitude.checked_shl(exponent.unsigned_abs()).unwrap_or(0);
    if value.is_sign_negative() {
        bits.wrapping_neg()
    } else {
        bits
    }
}

/// A finite number's magnitude as `significand * 2^exponent`.
#[inline]
pub const fn parts(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match ((bits >> 52) & 0x7FF) as i32 {
        0 => (fraction, -1074),
        exponent => (fraction | (1 << 52), exponent - 1075),
    }
}

/// A real number that is known exactly but for a rest: `(magnitude + rest) * 2^exponent` with
/// `0 <= rest < 1`. What is computed in this form is rounded only once, when it is taken out.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// Whether the sign is negative.
    pub negative: bool,
    /// The leading bits.
    pub magnitude: u128,
    /// Whether the rest is not zero.
    pub inexact: bool,
    /// The power of two.
    pub exponent: i32,
}

impl Exact {
    /// `numerator / denominator * 2^exponent`, with at least 63 leading bits known; the denominator, which
    /// must not be 0, has less than 64.
    pub fn quotient(negative: bool, numerator: u128, denominator: u64, exponent: i32) -> Exact {
        let shift = numerator.leading_zeros().min(127);
        let numerator = numerator << shift;
        let denominator = u128::from(denominator.max(1));
        Exact {
            negative,
            magnitude: numerator / denominator,
            inexact: !numerator.is_multiple_of(denominator),
            exponent: exponent.saturating_sub(shift.cast_signed()),
        }
    }

    /// Rounded to the nearest integer, ties to even, modulo 2^64. Where the rest is not known and the exponent
    /// is positive the low bits are lost; callers keep out of there.
    pub fn to_integer(self) -> u64 {
        let bits = if self.exponent >= 0 {
            self.magnitude
                .checked_shl(self.exponent.unsigned_abs())
                .unwrap_or(0)
        } else {
            self.rounded_right_shift()
        };
        // The low 64 bits are the value modulo 2^64.
        let bits = bits as u64;
        if self.negative { bits.wrapping_neg() } else { bits }
    }

    fn rounded_right_shift(self) -> u128 {
        let shift = self.exponent.unsigned_abs();
        if shift > 128 {
            return 0;
        }
        let floor = self.magnitude.checked_shr(shift).unwrap_or(0);
        let below = self.magnitude ^ floor.checked_shl(shift).unwrap_or(0);
        let half = 1_u128 << (shift - 1);
        let up = below > half || (below == half && (self.inexact || floor & 1 == 1));
        floor + u128::from(up)
    }

    /// Rounded to the nearest REAL or LREAL, ties to even; the value must lie well within their exponents and
    /// be known to 63 bits, or exactly.
    pub fn to_real(self, ty: ElementaryType) -> u64 {
        // The last bit lies far below the rounding position, so it can stand for all that comes after it.
        let magnitude = self.magnitude | u128::from(self.inexact);
        let sign = if self.negative { -1.0 } else { 1.0 };
        // Scaling by a power of two is exact here; a REAL is scaled as LREAL, where no exponent is too small.
        let scale = 2_f64.powi(self.exponent) * sign;
        if ty == ElementaryType::Real {
            of_single((f64::from(magnitude as f32) * scale) as f32)
        } else {
            (magnitude as f64 * scale).to_bits()
        }
    }
}
