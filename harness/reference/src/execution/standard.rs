//! The standard functions that are no conversions, over plain values and over texts.
//!
//! Basis: iec-61131-3: standard functions (numeric, selection, bit string, character string); where a shift
//! count or a selector may lie outside its range, [`StandardFunction`] says what happens.

use super::arithmetic::absolute;
use super::comparison::{compare, extreme};
use super::stop::Halt;
use crate::conversion::real;
use crate::instruction::{FaultKind, RealFunction, StandardFunction, TextPart};
use crate::raw::narrow;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::Range;
use stickler_types::ElementaryType;
use stickler_types::dialect::TextPositions;
use stickler_types::literal::date;

/// The result for plain operands, the deepest first.
pub(super) fn of_plain(called: StandardFunction, of: ElementaryType, operands: &[u64]) -> Result<u64, Halt> {
    match (called, operands) {
        (StandardFunction::FiniteAbs, &[value]) | (StandardFunction::FiniteLimit, &[_, value, _])
            if !operands.iter().all(|&raw| real::decode(raw, of).is_finite()) =>
        {
            Ok(value)
        }
        (StandardFunction::Abs | StandardFunction::FiniteAbs, &[value]) => Ok(absolute(of, value)),
        (StandardFunction::Real(function) | StandardFunction::RealOrStop(function), raw) => {
            let values: Vec<f64> = raw.iter().map(|raw| real::decode(*raw, of)).collect();
            let result = of_reals(function, &values);
            let is_pole = values.iter().all(|value| *value == 0.0) && result.is_infinite();
            match is_pole && matches!(called, StandardFunction::RealOrStop(_)) {
                true => Err(FaultKind::DivisionByZero.into()),
                false => Ok(real::encode(result, of)),
            }
        }
        (StandardFunction::Compose, fields) => composed(of, fields),
        (StandardFunction::SwapBytes, &[value]) => Ok(narrow(
            value.swap_bytes() >> (64 - of.bits().next_multiple_of(8)),
            of,
        )),
        (StandardFunction::IsValid, &[value]) => Ok(real::decode(value, of).is_finite().into()),
        (StandardFunction::IsValidBcd, &[value]) => {
            Ok((0..16).all(|digit| (value >> (4 * digit)) & 15 < 10).into())
        }
        (StandardFunction::Sel, &[choice, if_false, if_true]) => {
            Ok(if choice == 0 { if_false } else { if_true })
        }
        (StandardFunction::Mux, [selector, values @ ..]) => {
            let chosen = usize::try_from(*selector)
                .ok()
                .and_then(|index| values.get(index));
            chosen.copied().ok_or(FaultKind::SubscriptRange.into())
        }
        (StandardFunction::Min, values) => furthest(of, Ordering::Less, values),
        (StandardFunction::Max, values) => furthest(of, Ordering::Greater, values),
        (StandardFunction::InOrder(operator), values) => {
            let is_in_order = values
                .windows(2)
                .all(|pair| compare(operator, of, pair[0], pair[1]));
            Ok(is_in_order.into())
        }
        (StandardFunction::Limit | StandardFunction::FiniteLimit, &[minimum, value, maximum]) => {
            let raised = extreme(of, Ordering::Greater, value, minimum);
            Ok(extreme(of, Ordering::Less, raised, maximum))
        }
        (StandardFunction::Shl, &[value, count]) => {
            Ok(shift_count(count, of).map_or(0, |n| narrow(value << n, of)))
        }
        (StandardFunction::Shr, &[value, count]) if of.is_signed() => Ok(signed_right(value, count, of)),
        (StandardFunction::Shr, &[value, count]) => Ok(shift_count(count, of).map_or(0, |n| value >> n)),
        (StandardFunction::Rol, &[value, count]) => Ok(rotated_left(value, count.cast_signed(), of)),
        (StandardFunction::Ror, &[value, count]) => Ok(rotated_left(
            value,
            (count.cast_signed() % i64::from(of.bits().max(1))).wrapping_neg(),
            of,
        )),
        _ => Err(Halt::Missing("operand of a standard function")),
    }
}

/// Returns the date, the time of day or both that have these numbers, from the year or the hour on.
///
/// Basis: iec-61131-3: Table 36, which does not say what numbers give that no date has.
fn composed(of: ElementaryType, fields: &[u64]) -> Result<u64, Halt> {
    let text: Vec<String> = fields
        .iter()
        .map(|field| field.cast_signed().to_string())
        .collect();
    let milliseconds = fields
        .get(3..)
        .and_then(<[u64]>::last)
        .copied()
        .unwrap_or_default();
    let read = match &text[..] {
        _ if milliseconds > 999 => None,
        [year, month, day] => date::date(&format!("{year}-{month}-{day}")).ok(),
        [hour, minute, second, _] => {
            date::time_of_day(&format!("{hour}:{minute}:{second}.{milliseconds:03}")).ok()
        }
        [year, month, day, hour, minute, second, _] => date::date_and_time(&format!(
            "{year}-{month}-{day}-{hour}:{minute}:{second}.{milliseconds:03}"
        ))
        .ok(),
        _ => return Err(Halt::Missing("operand of a standard function")),
    };
    let moment = read.ok_or(FaultKind::Subrange)?;
    Ok(narrow(moment.cast_unsigned(), of))
}

/// Returns what a function of real numbers gives; of one of a REAL, before it is rounded to that type.
fn of_reals(function: RealFunction, values: &[f64]) -> f64 {
    use RealFunction::*;
    let value = values.first().copied().unwrap_or(f64::NAN);
    match function {
        SquareRoot => value.sqrt(),
        NaturalLogarithm => value.ln(),
        Logarithm => value.log10(),
        Exponential => value.exp(),
        Sine => value.sin(),
        Cosine => value.cos(),
        Tangent => value.tan(),
        ArcSine => value.asin(),
        ArcCosine => value.acos(),
        ArcTangent => value.atan(),
        ArcTangent2 => value.atan2(values.get(1).copied().unwrap_or(f64::NAN)),
    }
}

fn furthest(of: ElementaryType, further: Ordering, values: &[u64]) -> Result<u64, Halt> {
    let furthest = values
        .iter()
        .copied()
        .reduce(|first, second| extreme(of, further, first, second));
    furthest.ok_or(Halt::Missing("operand of a standard function"))
}

/// The count of a shift where it lies within the width.
fn shift_count(count: u64, of: ElementaryType) -> Option<u32> {
    u32::try_from(count).ok().filter(|count| *count < of.bits())
}

/// Shifts an integer with a sign to the right: copies of its sign come in.
fn signed_right(value: u64, count: u64, of: ElementaryType) -> u64 {
    let steps = shift_count(count, of).unwrap_or(63);
    (value.cast_signed() >> steps).cast_unsigned()
}

/// Bits that leave at one end come in at the other; a negative count turns the other way round.
fn rotated_left(value: u64, count: i64, of: ElementaryType) -> u64 {
    let width = of.bits().max(1);
    // The remainder lies below 64.
    let count = count.rem_euclid(width.into()) as u32;
    // Of an integer with a sign the bits of its width.
    let bits = value & (u64::MAX >> (64 - width));
    if count == 0 {
        value
    } else {
        narrow(bits << count | bits >> (width - count), of)
    }
}

/// A text on the machine's stack: a constant of the program, or what the run made.
pub(super) type Text<'p> = Cow<'p, [u16]>;

/// Returns the characters of a text of this length that a number of them from a position on are, as far as they are there.
///
/// Basis: iec-61131-3: Table 34 (positions count from 1; what lies outside the text is an error, of which the standard leaves the consequences
/// open).
fn range(text: &[u16], length: i64, position: i64) -> Range<usize> {
    let start = position.saturating_sub(1);
    let end = start.saturating_add(length);
    let inside = |at: i64| usize::try_from(at.max(0)).map_or(text.len(), |at| at.min(text.len()));
    let start = inside(start);
    start..inside(end).max(start)
}

/// Returns the position of a text in another, from 1; 0 where it is not there, or is empty. It takes as long as the two texts have characters
/// together (the algorithm of Knuth, Morris and Pratt).
pub(super) fn position(text: &[u16], sought: &[u16]) -> u64 {
    // For each beginning of the sought text, how long a shorter beginning is with which it ends.
    let mut borders = vec![0; sought.len()];
    let longer = |borders: &[usize], mut matched: usize, unit: u16| {
        while matched > 0 && sought[matched] != unit {
            matched = borders[matched - 1];
        }
        matched + usize::from(sought[matched] == unit)
    };
    for at in 1..sought.len() {
        borders[at] = longer(&borders, borders[at - 1], sought[at]);
    }
    let mut matched = 0;
    for (at, unit) in text.iter().enumerate().filter(|_| !sought.is_empty()) {
        matched = longer(&borders, matched, *unit);
        if matched == sought.len() {
            return (at + 2 - matched) as u64;
        }
    }
    0
}

/// Returns what a function of texts and positions gives; `None` for another function.
fn of_ranges(function: StandardFunction, numbers: &[u64], texts: &[Text<'_>]) -> Option<Vec<u16>> {
    let StandardFunction::Part(part, positions) = function else {
        return None;
    };
    let text = texts.first()?;
    let numbers: Vec<i64> = numbers.iter().map(|number| number.cast_signed()).collect();
    match (positions, part, &numbers[..]) {
        (TextPositions::Kept, TextPart::Mid, &[_, ..1])
        | (TextPositions::Empty, _, &[..0, ..] | &[_, ..1]) => {
            return Some(Vec::new());
        }
        (TextPositions::Kept, TextPart::Insert, &[at]) if at < 0 || at > text.len() as i64 => {
            return Some(text.to_vec());
        }
        (TextPositions::Kept, TextPart::Replace, &[_, at]) if at > text.len() as i64 => {
            return Some(text.to_vec());
        }
        _ => {}
    }
    of_clipped(part, &numbers, texts)
}

/// Returns what a function of texts and positions gives for what of the positions lies in the text.
fn of_clipped(part: TextPart, numbers: &[i64], texts: &[Text<'_>]) -> Option<Vec<u16>> {
    let joined = |text: &[u16], range: Range<usize>, between: &[u16]| {
        let (before, behind) = (text.get(..range.start)?, text.get(range.end..)?);
        Some([before, between, behind].concat())
    };
    match (part, numbers, texts) {
        (TextPart::Left, &[length], [text]) => text.get(range(text, length, 1)).map(<[u16]>::to_vec),
        (TextPart::Right, &[length], [text]) => {
            let before = (text.len() as i64).saturating_sub(length.max(0));
            let kept = range(text, length, before.saturating_add(1).max(1));
            text.get(kept).map(<[u16]>::to_vec)
        }
        (TextPart::Mid, &[length, position], [text]) => {
            let kept = range(text, length, position);
            text.get(kept).map(<[u16]>::to_vec)
        }
        (TextPart::Delete, &[length, position], [text]) => joined(text, range(text, length, position), &[]),
        (TextPart::Replace, &[length, position], [text, other]) => {
            joined(text, range(text, length, position), other)
        }
        (TextPart::Insert, &[position], [text, other]) => {
            let at = range(text, 0, position.saturating_add(1));
            joined(text, at, other)
        }
        _ => None,
    }
}

fn furthest_text<'t, 'p>(further: Ordering, texts: &'t mut [Text<'p>]) -> Option<&'t mut Text<'p>> {
    // The first of equal texts, as for plain values.
    texts.iter_mut().reduce(|first, second| {
        if (*second).cmp(first) == further {
            second
        } else {
            first
        }
    })
}

/// The resulting text for texts and the numbers besides, the deepest of each first.
pub(super) fn of_texts<'p>(
    function: StandardFunction,
    numbers: &[u64],
    texts: &mut [Text<'p>],
) -> Result<Text<'p>, Halt> {
    let missing = Halt::Missing("operand of a standard function");
    if let Some(text) = of_ranges(function, numbers, texts) {
        return Ok(Cow::Owned(text));
    }
    let chosen = match function {
        StandardFunction::Concat => return Ok(Cow::Owned(texts.concat())),
        StandardFunction::Sel | StandardFunction::Mux => {
            let selector = numbers.first().copied().ok_or(missing)?;
            let index = if function == StandardFunction::Sel {
                selector.min(1)
            } else {
                selector
            };
            usize::try_from(index)
                .ok()
                .and_then(|index| texts.get_mut(index))
                .ok_or(FaultKind::SubscriptRange)?
        }
        StandardFunction::Min => furthest_text(Ordering::Less, texts).ok_or(missing)?,
        StandardFunction::Max => furthest_text(Ordering::Greater, texts).ok_or(missing)?,
        StandardFunction::Limit => {
            let [minimum, value, maximum] = texts else {
                return Err(missing);
            };
            let raised = if *minimum > *value { minimum } else { value };
            if *maximum < *raised { maximum } else { raised }
        }
        _ => return Err(missing),
    };
    Ok(std::mem::take(chosen))
}
