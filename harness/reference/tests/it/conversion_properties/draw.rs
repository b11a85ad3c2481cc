//! Values drawn from seeded bytes, and the conversions that they go through.

use arbitrary::{Arbitrary, Result, Unstructured};
use stickler_reference::conversion::{Conversion, function};
use stickler_types::Dialect;
use stickler_types::{DialectName, ElementaryType, Family, SplitMix64};

/// Tries a property so many times; each time it is given 64 bytes of its own to draw from.
#[track_caller]
pub fn each(seed: u64, times: usize, mut property: impl FnMut(&mut Unstructured<'_>) -> Result<()>) {
    const BYTES: usize = 64;
    for case in SplitMix64::new(seed).bytes(times * BYTES).chunks(BYTES) {
        property(&mut Unstructured::new(case)).expect("64 bytes are enough");
    }
}

/// One of several things.
pub fn one_of<T: Copy>(draw: &mut Unstructured<'_>, things: &[T]) -> Result<T> {
    draw.choose(things).copied()
}

/// 64 bits: small numbers, neighbours of powers of two, and any, each with either sign.
pub fn bits(draw: &mut Unstructured<'_>) -> Result<u64> {
    let magnitude = match draw.int_in_range(0..=2)? {
        0 => u8::arbitrary(draw)?.into(),
        1 => (1_u64 << draw.int_in_range(0..=63)?).wrapping_add_signed(draw.int_in_range(-2..=2)?),
        _ => u64::arbitrary(draw)? >> draw.int_in_range(0..=63)?,
    };
    let negative = bool::arbitrary(draw)?;
    Ok(if negative {
        magnitude.wrapping_neg()
    } else {
        magnitude
    })
}

/// A raw form of a type that is no text, with every kind of real number among them.
pub fn raw(draw: &mut Unstructured<'_>, ty: ElementaryType) -> Result<u64> {
    const DAY: i64 = 86_400_000_000_000;
    let bits = bits(draw)?;
    Ok(match ty.family() {
        Family::Real => real(draw, ty, bits)?,
        Family::Date => (bits.cast_signed() / DAY * DAY).cast_unsigned(),
        Family::TimeOfDay => bits % DAY.unsigned_abs(),
        Family::Duration | Family::DateAndTime => bits,
        _ => ty.wrap(bits.into()),
    })
}

/// A real: near an integer, near half of one, or of any bits at all.
fn real(draw: &mut Unstructured<'_>, ty: ElementaryType, bits: u64) -> Result<u64> {
    let value = match draw.int_in_range(0..=2)? {
        0 => bits.cast_signed() as f64,
        1 => bits.cast_signed() as f64 / 2.0,
        _ => {
            return Ok(if ty == ElementaryType::Real {
                bits >> 32
            } else {
                bits
            });
        }
    };
    let step = draw.int_in_range(0..=2)?;
    Ok(if ty == ElementaryType::Real {
        u64::from((value as f32).to_bits()).saturating_sub(1) + step
    } else {
        value.to_bits().saturating_sub(1) + step
    })
}

/// Returns the number of the raw form of a real; 0 for other types.
pub fn number(raw: u64, ty: ElementaryType) -> f64 {
    ty.real_value(raw).unwrap_or_default()
}

/// Returns whether two raw forms are the same value; all NaNs are.
pub fn same(left: u64, right: u64, ty: ElementaryType) -> bool {
    left == right || (ty.is_real() && number(left, ty).is_nan() && number(right, ty).is_nan())
}

/// The conversion of `<FROM>_TO_<TO>`, where the dialect has it.
pub fn conversion(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Conversion> {
    let function = function(&format!("{from}_TO_{to}"), dialect)?;
    Some(function.conversion(from, to))
}

/// All ordered pairs of types that a dialect has, with the conversion from the one to the other.
pub fn pairs(dialect: &Dialect) -> Vec<Conversion> {
    let types = || ElementaryType::ALL.into_iter().filter(|&ty| dialect.has(ty));
    types()
        .flat_map(|from| types().filter_map(move |to| conversion(from, to, dialect)))
        .collect()
}

/// Every dialect.
pub fn dialects() -> [&'static Dialect; DialectName::ALL.len()] {
    DialectName::ALL.map(Dialect::of)
}
