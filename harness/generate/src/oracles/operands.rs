//! Operands for conversions: any value of a type, more often boundary values.

use arbitrary::{Result, Unstructured};
use std::sync::LazyLock;
use stickler_types::{ElementaryType, Family, Value};

/// One day in nanoseconds.
const DAY: i64 = 86_400_000_000_000;

/// Draws a value of a type; 0 or the empty text if no bytes are left.
pub(super) fn operand(ty: ElementaryType, input: &mut Unstructured<'_>) -> Result<Value> {
    if ty.is_text() {
        return Ok(Value::text(ty, text(ty, input)?));
    }
    let raw = match ty.family() {
        Family::Real => real(ty, input)?,
        _ => ty.wrap(whole(ty, input)?.into()),
    };
    Ok(Value::plain(ty, raw))
}

/// Draws a number for a type that holds integers or nanoseconds.
fn whole(ty: ElementaryType, input: &mut Unstructured<'_>) -> Result<i64> {
    let number = match input.arbitrary::<u8>()? % 4 {
        0 => i64::from(input.arbitrary::<i8>()?),
        1 => near_power(input)?,
        2 => input.arbitrary::<i64>()?,
        // Whole milliseconds, seconds, days.
        _ => {
            let unit = *input.choose(&[1_000_000, 1_000_000_000, DAY])?;
            i64::from(input.arbitrary::<i32>()?).saturating_mul(unit)
        }
    };
    Ok(match ty.family() {
        // A date is a whole day, and a time of day lies within one.
        Family::Date => number / DAY * DAY,
        Family::TimeOfDay => number.rem_euclid(DAY),
        _ => number,
    })
}

/// Draws a number near a power of two or its negative.
fn near_power(input: &mut Unstructured<'_>) -> Result<i64> {
    let power = 1_i64.wrapping_shl(u32::from(input.arbitrary::<u8>()?) % 64);
    let beside = i64::from(input.arbitrary::<u8>()? % 5) - 2;
    let sign = if input.arbitrary::<bool>()? { -1 } else { 1 };
    Ok(power.wrapping_add(beside).wrapping_mul(sign))
}

/// Draws the raw form of a REAL or LREAL: any bits, an integer with a fraction where one fits, or a neighbour.
fn real(ty: ElementaryType, input: &mut Unstructured<'_>) -> Result<u64> {
    let kind = input.arbitrary::<u8>()? % 4;
    if kind == 3 {
        return Ok(ty.wrap(input.arbitrary::<i64>()?.into()));
    }
    let number = match kind {
        0 => f64::from(input.arbitrary::<i8>()?),
        1 => near_power(input)? as f64,
        _ => input.arbitrary::<i64>()? as f64,
    };
    let fraction = f64::from(input.arbitrary::<u8>()? % 8) / 8.0;
    let number = number + fraction;
    let raw = ty.real_bits(number);
    let step = i64::from(input.arbitrary::<u8>()? % 3) - 1;
    // The step from 0 down would turn the sign.
    Ok(if raw == 0 {
        0
    } else {
        raw.wrapping_add_signed(step)
    })
}

/// The maximum length of a text; the result of its conversion still fits the variable of the program.
const MAX_TEXT_LEN: usize = 60;

/// Pieces of texts that stand for values.
static PIECES: LazyLock<Vec<String>> =
    LazyLock::new(|| serde_json::from_str(include_str!("pieces.json")).unwrap_or_default());

fn text(ty: ElementaryType, input: &mut Unstructured<'_>) -> Result<Vec<u16>> {
    let mut units: Vec<u16> = Vec::new();
    while !input.is_empty() && units.len() < MAX_TEXT_LEN {
        match input.arbitrary::<u8>()? {
            0 => break,
            any @ 1..=0x1F => {
                let wide = u16::from(any) << 8 | u16::from(input.arbitrary::<u8>()?);
                units.push(if ty == ElementaryType::Wstring {
                    wide
                } else {
                    wide & 0xFF
                });
            }
            letter @ 0x20..=0x7F => units.push(letter.into()),
            piece => units.extend(PIECES[usize::from(piece) % PIECES.len()].bytes().map(u16::from)),
        }
    }
    units.truncate(MAX_TEXT_LEN);
    Ok(units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bytes_give_the_simplest_operand() {
        for ty in ElementaryType::ALL {
            let operand = operand(ty, &mut Unstructured::new(&[])).expect("the simplest");
            match operand {
                Value::Plain { raw, .. } => assert_eq!(raw, 0, "{ty}"),
                Value::Text { units, .. } => assert_eq!(units, [0_u16; 0]),
                Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => {
                    unreachable!("no elementary type")
                }
            }
        }
    }

    #[test]
    fn texts_of_single_bytes_have_no_wider_unit() {
        let data: Vec<u8> = (1..=255).collect();
        let units = text(ElementaryType::String, &mut Unstructured::new(&data)).expect("a text");
        assert!(units.len() <= MAX_TEXT_LEN && units.iter().all(|unit| *unit <= 0xFF));
    }
}
