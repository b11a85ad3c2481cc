//! Conversions from and to REAL and to LREAL: decodes and encodes the bits with integers, and rounds at most once.

use super::each;
use super::integer::Narrow;
use stickler_types::{ElementaryType, OutOfRange, Rounding};

/// The real type of a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RealResult {
    /// REAL.
    Single,
    /// LREAL.
    Double,
}

/// The raw form of the quiet NaN of REAL.
const SINGLE_NAN: u64 = 0x7FC0_0000;
const DOUBLE_NAN: u64 = 0x7FF8_0000_0000_0000;

/// The decoded bits of a REAL: `significand * 2^exponent`, unless it is not finite.
#[derive(Clone, Copy)]
pub struct Parts {
    /// Whether the sign bit is set.
    pub negative: bool,
    /// The significand, below 2^24.
    pub significand: u64,
    /// The exponent, from -149 to 104.
    pub exponent: i32,
    /// Whether the value is finite; otherwise the significand is 0 for an infinity, and not 0 for a NaN.
    pub finite: bool,
}

impl Parts {
    /// Decodes the raw form of a REAL.
    #[inline(always)]
    pub const fn of(raw: u64) -> Parts {
        let biased = ((raw >> 23) & 0xFF) as i32;
        let fraction = raw & 0x7F_FFFF;
        let finite = biased != 0xFF;
        // The leading bit is not written; numbers near zero and what is not finite have none.
        let leading = (finite && biased != 0) as u64;
        Parts {
            negative: raw >> 31 & 1 == 1,
            significand: fraction | leading << 23,
            exponent: (if biased == 0 { 1 } else { biased }) - 150,
            finite,
        }
    }

    /// Returns the magnitude multiplied by a factor below 2^30 and rounded to an integer, modulo 2^64.
    #[inline(always)]
    pub const fn magnitude(self, factor: u64, rounding: Rounding) -> u64 {
        let product = self.significand * factor;
        if self.exponent >= 0 {
            let shift = self.exponent.unsigned_abs();
            return if shift < 64 { product << shift } else { 0 };
        }
        // The product has less than 62 bits, so that beyond 63 places nothing but the shift itself would change.
        let places = self.exponent.unsigned_abs();
        let places = if places > 63 { 63 } else { places };
        let whole = product >> places;
        let rest = product & ((1 << places) - 1);
        let half = 1 << (places - 1);
        let up = match rounding {
            Rounding::Truncate => false,
            Rounding::HalfToEven => rest + (whole & 1) > half,
            Rounding::HalfAwayFromZero => rest >= half,
            Rounding::Up => rest != 0 && !self.negative,
            Rounding::Down => rest != 0 && self.negative,
            Rounding::AwayFromZero => rest != 0,
        };
        whole + up as u64
    }

    /// Returns a magnitude with the sign of the number, modulo 2^64.
    #[inline(always)]
    pub const fn signed(self, magnitude: u64) -> u64 {
        if self.negative {
            magnitude.wrapping_neg()
        } else {
            magnitude
        }
    }
}

/// Computes whether each number is not zero; NaN is not zero.
pub fn truth(operands: &[u64], results: &mut [u64]) {
    // All but the sign.
    each(operands, results, |operand| u64::from(operand & 0x7FFF_FFFF != 0));
}

/// Copies each REAL, with every NaN made the quiet one.
pub fn same(operands: &[u64], results: &mut [u64]) {
    each(operands, results, |operand| {
        let parts = Parts::of(operand);
        if parts.finite || parts.significand == 0 {
            operand
        } else {
            SINGLE_NAN
        }
    });
}

/// Converts each REAL to LREAL, which holds every REAL.
pub fn lengthened(operands: &[u64], results: &mut [u64]) {
    each(operands, results, |operand| {
        let parts = Parts::of(operand);
        let sign = (parts.negative as u64) << 63;
        match (parts.finite, parts.significand) {
            (true, 0) => sign,
            (true, significand) => sign | composed(significand, parts.exponent, 52),
            (false, 0) => sign | 0x7FF << 52,
            (false, _) => DOUBLE_NAN,
        }
    });
}

/// Returns the LREAL of a significand that has at most 53 bits and is not 0.
#[inline(always)]
const fn composed(significand: u64, exponent: i32, fraction_bits: u32) -> u64 {
    let leading = 63 - significand.leading_zeros();
    let aligned = significand << (fraction_bits - leading);
    // The leading bit, which is not written, adds one to the exponent.
    let biased = (exponent + leading as i32 + 1022) as u64;
    (biased << fraction_bits) + aligned
}

/// Converts each number of at most 33 bits to the nearest real, ties to even.
///
/// Successive operands mostly have their leading bit at the same place. A run in which all have it uses the same shifts for
/// all, which is several times faster than finding the bit of each.
pub fn nearest(operands: &[u64], results: &mut [u64], result: RealResult) {
    const STRETCH: usize = 64;
    for (operands, results) in operands.chunks(STRETCH).zip(results.chunks_mut(STRETCH)) {
        match (result, common_leading_zeros(operands)) {
            (RealResult::Single, Some(zeros)) => each(operands, results, |operand| {
                let (sign, magnitude) = sign_and_magnitude(operand);
                sign << 31 | single_with(magnitude, zeros)
            }),
            (RealResult::Double, Some(zeros)) => each(operands, results, |operand| {
                let (sign, magnitude) = sign_and_magnitude(operand);
                sign << 63 | double_with(magnitude, zeros)
            }),
            (RealResult::Single, None) => each(operands, results, |operand| {
                let (sign, magnitude) = sign_and_magnitude(operand);
                sign << 31 | nearest_single(magnitude)
            }),
            (RealResult::Double, None) => each(operands, results, |operand| {
                let (sign, magnitude) = sign_and_magnitude(operand);
                sign << 63 | nearest_double(magnitude)
            }),
        }
    }
}

/// Returns the number of zeros before the leading bit, if it is the same for every magnitude; `None` if it differs or one
/// of the magnitudes is 0.
#[inline(always)]
fn common_leading_zeros(operands: &[u64]) -> Option<u32> {
    let first = sign_and_magnitude(*operands.first()?).1;
    let differing = operands
        .iter()
        .fold(0, |bits, &operand| bits | (sign_and_magnitude(operand).1 ^ first));
    let zeros = first.leading_zeros();
    (first != 0 && differing.leading_zeros() > zeros).then_some(zeros)
}

/// Returns sign and magnitude of a raw form. That of a signed integer is two's complement; an unsigned one of 32 bits is
/// never negative.
#[inline(always)]
const fn sign_and_magnitude(raw: u64) -> (u64, u64) {
    (raw >> 63, raw.cast_signed().unsigned_abs())
}

#[inline(always)]
const fn nearest_single(magnitude: u64) -> u64 {
    match magnitude {
        0 => 0,
        _ => single_with(magnitude, magnitude.leading_zeros()),
    }
}

#[inline(always)]
const fn nearest_double(magnitude: u64) -> u64 {
    match magnitude {
        0 => 0,
        _ => double_with(magnitude, magnitude.leading_zeros()),
    }
}

/// Returns the REAL nearest to a number with `zeros` zeros before its leading bit, at least one.
#[inline(always)]
const fn single_with(magnitude: u64, zeros: u32) -> u64 {
    // The leading bit next to the top, 24 bits to keep, 39 to round away: half of what those can say is added, less
    // one where the last bit that is kept is even.
    let normal = magnitude << (zeros - 1);
    let rounded = (normal + ((1 << 38) - 1) + (normal >> 39 & 1)) >> 39;
    // The leading bit adds one to the exponent, and so does a carry out of the fraction.
    (((126 + 63 - zeros) as u64) << 23) + rounded
}

/// Returns the LREAL of a number with `zeros` zeros before its leading bit, at least eleven.
#[inline(always)]
const fn double_with(magnitude: u64, zeros: u32) -> u64 {
    // The leading bit, which is not written, adds one to the exponent.
    (((1022 + 63 - zeros) as u64) << 52) + (magnitude << (zeros - 11))
}

/// Converts REAL to an integer or bit string.
pub fn integral(
    operands: &[u64],
    results: &mut [u64],
    to: ElementaryType,
    rounding: Rounding,
    out_of_range: OutOfRange,
) {
    // The rounding is a constant in each of these loops.
    macro_rules! one_loop_for_each {
        ($($rounding:ident)*) => {
            match (out_of_range, rounding) {
                $((OutOfRange::Wrap, Rounding::$rounding) => wrapped(operands, results, to, Rounding::$rounding),)*
                (OutOfRange::Saturate, _) => saturated(operands, results, to, rounding),
                (OutOfRange::Indefinite64, _) => indefinite(operands, results, to, rounding, 64),
                (OutOfRange::Indefinite32, _) => indefinite(operands, results, to, rounding, 32),
            }
        };
    }
    one_loop_for_each!(Truncate HalfToEven HalfAwayFromZero Up Down AwayFromZero);
}

/// Converts REAL to an integer modulo 2^n; NaN and the infinities give 0.
#[inline(always)]
fn wrapped(operands: &[u64], results: &mut [u64], to: ElementaryType, rounding: Rounding) {
    let narrow = Narrow::to(to);
    each(operands, results, |operand| {
        let parts = Parts::of(operand);
        if parts.finite {
            narrow.of(parts.signed(parts.magnitude(1, rounding)))
        } else {
            0
        }
    });
}

/// Converts REAL to the nearest value that the type has; NaN gives 0.
fn saturated(operands: &[u64], results: &mut [u64], to: ElementaryType, rounding: Rounding) {
    let (least, greatest) = to.integer_range().unwrap_or((0, 0));
    each(operands, results, |operand| {
        let number = number(Parts::of(operand), rounding).unwrap_or(0);
        // The low bits are the raw form of a number in the range, sign and all.
        number.clamp(least, greatest) as u64
    });
}

/// Converts REAL to the low bits of an integer of so many bits, which is the least one where those do not hold the number; a negative
/// number has at most 32 on its way to a target that has no more, and a target of 64 bits takes a number of 64 bits without a sign.
fn indefinite(operands: &[u64], results: &mut [u64], to: ElementaryType, rounding: Rounding, bits: u32) {
    let narrow = Narrow::to(to);
    each(operands, results, |operand| {
        let parts = Parts::of(operand);
        let number = number(parts, rounding);
        let is_below_zero = number.is_some_and(|number| number < 0);
        let bits = if is_below_zero && to.bits() <= 32 {
            32
        } else {
            bits
        };
        let least = -(1_i128 << (bits - 1));
        let limit = if bits == 64 && to.bits() == 64 {
            1 << 64
        } else {
            -least
        };
        let held = number.filter(|number| (least..limit).contains(number));
        narrow.of(held.unwrap_or(least) as u64)
    });
}

/// Returns the number rounded to an integer, or one beyond all integers for an infinity and from 2^88 on; `None` for a NaN.
#[inline(always)]
fn number(parts: Parts, rounding: Rounding) -> Option<i128> {
    let magnitude = match (parts.finite, parts.significand) {
        (true, _) if parts.exponent < 0 => parts.magnitude(1, rounding).into(),
        (true, significand) if parts.exponent < 64 => i128::from(significand) << parts.exponent,
        (true, _) | (false, 0) => i128::MAX,
        (false, _) => return None,
    };
    Some(if parts.negative { -magnitude } else { magnitude })
}
