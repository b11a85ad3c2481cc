//! The standard functions that are no conversions, over plain values and over texts.
//!
//! Basis: iec-61131-3: standard functions (numeric, selection, bit string, character string); where a shift
//! count or a selector may lie outside its range, [`StandardFunction`] says what happens.

use super::arithmetic::absolute;
use super::comparison::{compare, lies_further};
use super::stop::Halt;
use crate::conversion::real;
use crate::instruction::{FaultKind, RealFunction, StandardFunction, TextPart};
use crate::raw::narrow;
use crate::semantics::unary_function;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::Range;
use stickler_types::ElementaryType;
use stickler_types::dialect::TextPositions;
use stickler_types::literal::date;

/// A standard function of one number or bit string, computed as the machine does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnaryFunction {
    /// The function; `None` for NOT.
    called: Option<StandardFunction>,
    of: ElementaryType,
}

impl UnaryFunction {
    /// Finds a function by its name, for operands of a type that it takes.
    pub fn find(name: &str, of: ElementaryType) -> Option<UnaryFunction> {
        let called = match name {
            "NOT" => None,
            name => Some(unary_function(name)?),
        };
        Some(UnaryFunction { called, of })
    }

    /// Returns the raw form of the result; 0 where a program would stop.
    pub fn apply(self, operand: u64) -> u64 {
        match self.called {
            None => complement(operand, self.of),
            Some(called) => of_plain(called, self.of, &[operand]).unwrap_or_default(),
        }
    }
}

/// Returns what LEN gives for a text.
pub fn length(text: &[u16]) -> u64 {
    narrow(text.len() as u64, ElementaryType::Int)
}

/// The bits of a value, each inverted.
pub(super) fn complement(value: u64, of: ElementaryType) -> u64 {
    narrow(!value, of)
}

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
        (StandardFunction::InOrder(operator), values) => {
            let is_in_order = values
                .windows(2)
                .all(|pair| compare(operator, of, pair[0], pair[1]));
            Ok(is_in_order.into())
        }
        (StandardFunction::Shl, &[value, count]) => {
            Ok(shift_count(count, of).map_or(0, |n| narrow(value << n, of)))
        }
        (StandardFunction::Shr, &[value, count]) if of.is_signed() => {
            // Copies of the sign come in.
            let steps = shift_count(count, of).unwrap_or(63);
            Ok((value.cast_signed() >> steps).cast_unsigned())
        }
        (StandardFunction::Shr, &[value, count]) => Ok(shift_count(count, of).map_or(0, |n| value >> n)),
        (StandardFunction::Rol, &[value, count]) => Ok(rotated_left(value, count.cast_signed(), of)),
        (StandardFunction::Ror, &[value, count]) => Ok(rotated_left(
            value,
            (count.cast_signed() % i64::from(of.bits().max(1))).wrapping_neg(),
            of,
        )),
        _ => {
            let has_selector = matches!(called, StandardFunction::Sel | StandardFunction::Mux);
            let (numbers, values) = operands.split_at_checked(has_selector.into()).ok_or(MISSING)?;
            let lies_further =
                |further, second: &u64, first: &u64| lies_further(of, further, *second, *first);
            let chosen = chosen(called, numbers, values, lies_further)?;
            values.get(chosen).copied().ok_or(MISSING)
        }
    }
}

const MISSING: Halt = Halt::Missing("operand of a standard function");

/// Returns the position of the value that SEL, MUX, MIN, MAX or LIMIT gives, of which the first two have a selector. `lies_further` tells whether
/// the first of two values lies further in a direction than the second; of equal ones the first counts.
fn chosen<T>(
    function: StandardFunction,
    selector: &[u64],
    values: &[T],
    lies_further: impl Fn(Ordering, &T, &T) -> bool,
) -> Result<usize, Halt> {
    let further = |direction, second: usize, first: usize| {
        let is_further = lies_further(direction, &values[second], &values[first]);
        if is_further { second } else { first }
    };
    let furthest = |direction| (1..values.len()).fold(0, |first, second| further(direction, second, first));
    match (function, selector) {
        (StandardFunction::Sel, [choice]) => Ok(usize::from(*choice != 0)),
        (StandardFunction::Mux, [selector]) => usize::try_from(*selector)
            .ok()
            .filter(|index| *index < values.len())
            .ok_or(FaultKind::SubscriptRange.into()),
        (StandardFunction::Min, _) => Ok(furthest(Ordering::Less)),
        (StandardFunction::Max, _) => Ok(furthest(Ordering::Greater)),
        (StandardFunction::Limit | StandardFunction::FiniteLimit, _) if values.len() == 3 => {
            Ok(further(Ordering::Less, 2, further(Ordering::Greater, 0, 1)))
        }
        _ => Err(MISSING),
    }
}

/// Returns the date, the time of day or both that have these numbers, from the year or the hour on.
///
/// Basis: iec-61131-3: Table 36, which does not say what numbers give that no date has.
fn composed(of: ElementaryType, fields: &[u64]) -> Result<u64, Halt> {
    let fields: Vec<i64> = fields.iter().map(|field| field.cast_signed()).collect();
    let (day, time) = match fields[..] {
        [year, month, day] => (date::days(year, month, day), Some(0)),
        [hour, minute, second, milliseconds] => (Some(0), time_of_day(hour, minute, second, milliseconds)),
        [year, month, day, hour, minute, second, milliseconds] => (
            date::days(year, month, day),
            time_of_day(hour, minute, second, milliseconds),
        ),
        _ => return Err(MISSING),
    };
    let moment = day
        .zip(time)
        .and_then(|(day, time)| date::instant(day, time).ok());
    let moment = moment.ok_or(FaultKind::Subrange)?;
    Ok(narrow(moment.cast_unsigned(), of))
}

/// Returns the nanoseconds since midnight of a time of day; `None` where a day has no such time.
fn time_of_day(hour: i64, minute: i64, second: i64, milliseconds: i64) -> Option<i64> {
    let fields = [(hour, 24), (minute, 60), (second, 60), (milliseconds, 1000)];
    let is_time = fields.iter().all(|(field, limit)| (0..*limit).contains(field));
    is_time.then(|| (((hour * 60 + minute) * 60 + second) * 1000 + milliseconds) * 1_000_000)
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

/// The count of a shift where it lies within the width.
fn shift_count(count: u64, of: ElementaryType) -> Option<u32> {
    u32::try_from(count).ok().filter(|count| *count < of.bits())
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
        | (TextPositions::Empty | TextPositions::Whole, _, &[..0, ..] | &[_, ..1]) => {
            return Some(Vec::new());
        }
        (TextPositions::Whole, _, &[count]) if count > text.len() as i64 => return Some(Vec::new()),
        (TextPositions::Whole, _, &[length, at]) if length.saturating_add(at) > text.len() as i64 + 1 => {
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

/// The resulting text for texts and the numbers besides, the deepest of each first.
pub(super) fn of_texts<'p>(
    function: StandardFunction,
    numbers: &[u64],
    texts: &mut [Text<'p>],
) -> Result<Text<'p>, Halt> {
    if let Some(text) = of_ranges(function, numbers, texts) {
        return Ok(Cow::Owned(text));
    }
    if function == StandardFunction::Concat {
        return Ok(Cow::Owned(texts.concat()));
    }
    if let (StandardFunction::Fitting, &[length]) = (function, numbers) {
        let fits = texts.first().is_some_and(|text| text.len() as u64 <= length);
        return Ok(texts
            .get_mut(usize::from(!fits))
            .map(std::mem::take)
            .unwrap_or_default());
    }
    let lies_further = |further, second: &Text<'p>, first: &Text<'p>| second.cmp(first) == further;
    let chosen = chosen(function, numbers, texts, lies_further)?;
    texts.get_mut(chosen).map(std::mem::take).ok_or(MISSING)
}
