//! Numbers of IEC 60559, decoded into integers and encoded again; each result is rounded once.

use stickler_types::{ElementaryType, Rounding};

/// A decoded REAL or LREAL.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Real {
    /// A NaN, whatever its sign and payload.
    NotANumber,
    /// An infinity.
    Infinite {
        /// Whether the infinity is negative.
        negative: bool,
    },
    /// A number.
    Finite(Finite),
}

/// The number `significand * 2^exponent`, or its negative.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Finite {
    /// Whether the sign bit is set, which zero has too.
    pub(crate) negative: bool,
    /// The significand, below 2^53.
    pub(crate) significand: u64,
    /// The exponent, from -1074 to 971.
    pub(crate) exponent: i32,
}

/// The shape of an interchange format.
///
/// Basis: IEC 60559: binary32 and binary64.
#[derive(Clone, Copy, Debug)]
struct FormatParameters {
    /// The number of bits of a significand, including the hidden one.
    precision: u32,
    /// The number of bits of the biased exponent.
    exponent_bits: u32,
    /// The exponent of the unit in the last place of the smallest numbers.
    least_exponent: i32,
}

const BINARY32: FormatParameters = FormatParameters {
    precision: 24,
    exponent_bits: 8,
    least_exponent: -149,
};
const BINARY64: FormatParameters = FormatParameters {
    precision: 53,
    exponent_bits: 11,
    least_exponent: -1074,
};

impl FormatParameters {
    /// Returns the format of REAL, or else that of LREAL.
    const fn of(ty: ElementaryType) -> FormatParameters {
        match ty {
            ElementaryType::Real => BINARY32,
            _ => BINARY64,
        }
    }

    /// Returns the raw form of positive infinity: all exponent bits set, the rest zero.
    const fn infinity(self) -> u64 {
        ((1 << self.exponent_bits) - 1) << (self.precision - 1)
    }

    const fn sign(self, negative: bool) -> u64 {
        (negative as u64) << (self.precision - 1 + self.exponent_bits)
    }

    /// Returns the raw form of the positive number `significand * 2^exponent`, which must have no more bits than the
    /// format, be normalised or have the least exponent, and may be the power of two just above all such numbers.
    ///
    /// The encoding counts through: the number next to the largest of one exponent is the smallest of the next exponent, and
    /// next to the largest finite number is infinity.
    fn pack(self, significand: u64, exponent: i32) -> u64 {
        // How many binades above the least; never negative, for the exponent never is below the least.
        let binades = u64::from((exponent - self.least_exponent).unsigned_abs());
        let limit = 1 << self.exponent_bits;
        ((binades.min(limit) << (self.precision - 1)) + significand).min(self.infinity())
    }
}

/// Decodes the raw form of a REAL, or else that of an LREAL.
pub(crate) const fn decode(raw: u64, ty: ElementaryType) -> Real {
    let format = FormatParameters::of(ty);
    let fraction_bits = format.precision - 1;
    let negative = raw & format.sign(true) != 0;
    let fraction = raw & ((1 << fraction_bits) - 1);
    let biased = (raw >> fraction_bits) & ((1 << format.exponent_bits) - 1);
    if biased == (1 << format.exponent_bits) - 1 {
        return if fraction == 0 {
            Real::Infinite { negative }
        } else {
            Real::NotANumber
        };
    }
    // Subnormal numbers share the least exponent, and have no hidden bit.
    let (significand, binades) = if biased == 0 {
        (fraction, 0)
    } else {
        (fraction | 1 << fraction_bits, biased as i32 - 1)
    };
    Real::Finite(Finite {
        negative,
        significand,
        exponent: binades + format.least_exponent,
    })
}

/// Returns the raw form of the one NaN that conversions give: quiet, positive, without a payload.
pub(crate) const fn not_a_number(to: ElementaryType) -> u64 {
    let format = FormatParameters::of(to);
    format.infinity() | 1 << (format.precision - 2)
}

/// Returns the raw form of an infinity.
pub(crate) const fn infinite(negative: bool, to: ElementaryType) -> u64 {
    let format = FormatParameters::of(to);
    format.infinity() | format.sign(negative)
}

/// Returns the raw form nearest to `magnitude * 2^exponent` or its negative, ties to even; beyond the largest finite number
/// by half a unit or more, infinity; zero keeps the sign.
///
/// `sticky` says that the true number is greater than that by less than one unit of the magnitude; the magnitude must then
/// have at least two bits more than the format.
///
/// Basis: IEC 60559: roundTiesToEven.
pub(crate) fn nearest(
    negative: bool,
    magnitude: u128,
    sticky: bool,
    exponent: i32,
    to: ElementaryType,
) -> u64 {
    let format = FormatParameters::of(to);
    let length = 128 - magnitude.leading_zeros();
    // How many of the low bits go: those beyond the precision, and those below the least exponent.
    let too_long = length.saturating_sub(format.precision);
    let too_small = u32::try_from(format.least_exponent - exponent).unwrap_or(0);
    let dropped = too_long.max(too_small);
    let (kept, rest, half) = match dropped {
        0 => (magnitude, 0, 1),
        1..=127 => (
            magnitude >> dropped,
            magnitude & ((1 << dropped) - 1),
            1 << (dropped - 1),
        ),
        // Only what begins at bit 127 reaches half a unit when all 128 bits go, and nothing does when more go.
        128 => (0, magnitude, 1 << 127),
        _ => (0, magnitude.min(1), u128::MAX),
    };
    let up = rest > half || (rest == half && (sticky || kept & 1 == 1));
    // Below 2^53 + 1.
    let significand = kept as u64 + u64::from(up);
    let (significand, exponent) = normalised(significand, exponent + dropped as i32, format);
    let packed = if significand == 0 {
        0
    } else {
        format.pack(significand, exponent)
    };
    format.sign(negative) | packed
}

/// Shifts a number so that its significand uses all bits of the format, as far as the least exponent allows.
fn normalised(significand: u64, exponent: i32, format: FormatParameters) -> (u64, i32) {
    let unused = format.precision - (64 - significand.leading_zeros()).min(format.precision);
    let possible = u32::try_from(exponent - format.least_exponent).unwrap_or(0);
    let shift = unused.min(possible);
    (significand << shift, exponent - shift as i32)
}

/// Returns the raw form nearest to a whole number.
pub(crate) fn from_integer(number: i128, to: ElementaryType) -> u64 {
    nearest(number < 0, number.unsigned_abs(), false, 0, to)
}

/// Converts between REAL and LREAL: exactly or rounded once; a NaN stays a NaN, and an infinity an infinity.
pub(crate) fn between(raw: u64, from: ElementaryType, to: ElementaryType) -> u64 {
    match decode(raw, from) {
        Real::NotANumber => not_a_number(to),
        Real::Infinite { negative } => infinite(negative, to),
        Real::Finite(number) => nearest(
            number.negative,
            number.significand.into(),
            false,
            number.exponent,
            to,
        ),
    }
}

/// Returns whether a real number is not zero; a NaN is not.
pub(crate) const fn is_nonzero(raw: u64, ty: ElementaryType) -> bool {
    !matches!(decode(raw, ty), Real::Finite(Finite { significand: 0, .. }))
}

/// A real number rounded to an integer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Whole {
    /// The integer, where it is not huge.
    Number(i128),
    /// An integer of 2^65 or more in magnitude, and a multiple of 2^64.
    Huge {
        /// Whether the integer is negative.
        negative: bool,
    },
}

/// Rounds a number to an integer.
pub(crate) fn to_whole(number: Finite, rounding: Rounding) -> Whole {
    let Finite {
        negative,
        significand,
        exponent,
    } = number;
    if significand == 0 {
        return Whole::Number(0);
    }
    if exponent > 64 {
        return Whole::Huge { negative };
    }
    if exponent >= 0 {
        // At most 53 bits, and 64 more.
        let magnitude = i128::from(significand) << exponent;
        return Whole::Number(if negative { -magnitude } else { magnitude });
    }
    // When 64 bits go, nothing of a significand is left, and nothing reaches one half: as when more go.
    let dropped = exponent.unsigned_abs().min(64);
    let scaled = u128::from(significand);
    let (below, rest) = (scaled >> dropped, scaled & ((1 << dropped) - 1));
    let half = 1_u128 << (dropped - 1);
    let away = match rounding {
        Rounding::Truncate => false,
        Rounding::HalfToEven => rest > half || (rest == half && below & 1 == 1),
        Rounding::HalfAwayFromZero => rest >= half,
        Rounding::Up => rest > 0 && !negative,
        Rounding::Down => rest > 0 && negative,
        Rounding::AwayFromZero => rest > 0,
    };
    let magnitude = below as i128 + i128::from(away);
    Whole::Number(if negative { -magnitude } else { magnitude })
}

/// Rounds a real number to a whole one that is a real number of the other type; keeps NaN and the infinities.
pub(crate) fn whole(raw: u64, from: ElementaryType, to: ElementaryType, rounding: Rounding) -> u64 {
    match decode(raw, from) {
        Real::Finite(number) if number.exponent < 0 => match to_whole(number, rounding) {
            Whole::Number(whole) if whole != 0 => from_integer(whole, to),
            _ => FormatParameters::of(to).sign(number.negative),
        },
        _ => between(raw, from, to),
    }
}

#[cfg(test)]
mod tests;
