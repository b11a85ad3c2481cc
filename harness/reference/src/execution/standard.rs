//! The standard functions that are no conversions, over plain values and over texts.
//!
//! Basis: iec-61131-3: standard functions (numeric, selection, bit string, character string); where a shift
//! count or a selector may lie outside its range, [`StandardFunction`] says what happens.

use super::arithmetic::absolute;
use super::comparison::{compare, extreme};
use super::stop::Halt;
use crate::conversion::real;
use crate::instruction::{FaultKind, StandardFunction};
use crate::raw::narrow;
use std::borrow::Cow;
use std::cmp::Ordering;
use stickler_types::ElementaryType;

/// Counts the plain operands that a function takes from the stack, its selector included.
pub(super) fn operand_count(function: StandardFunction, count: u16) -> usize {
    match function {
        StandardFunction::Abs | StandardFunction::FiniteAbs => 1,
        StandardFunction::Shl | StandardFunction::Shr | StandardFunction::Rol | StandardFunction::Ror => 2,
        StandardFunction::Sel | StandardFunction::Limit | StandardFunction::FiniteLimit => 3,
        StandardFunction::Mux => usize::from(count) + 1,
        StandardFunction::Min | StandardFunction::Max | StandardFunction::InOrder(_) => usize::from(count),
        StandardFunction::Len | StandardFunction::Concat => 0,
    }
}

/// The result for plain operands, the deepest first.
pub(super) fn of_plain(
    function: StandardFunction,
    of: ElementaryType,
    operands: &[u64],
) -> Result<u64, Halt> {
    match (function, operands) {
        (StandardFunction::FiniteAbs, &[value]) | (StandardFunction::FiniteLimit, &[_, value, _])
            if !operands.iter().all(|&raw| real::decode(raw, of).is_finite()) =>
        {
            Ok(value)
        }
        (StandardFunction::Abs | StandardFunction::FiniteAbs, &[value]) => Ok(absolute(of, value)),
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

/// Counts the texts that a function takes from the stack.
pub(super) fn text_count(function: StandardFunction, count: u16) -> usize {
    match function {
        StandardFunction::Len => 1,
        StandardFunction::Sel => 2,
        StandardFunction::Limit => 3,
        _ => usize::from(count),
    }
}

/// The resulting text for texts, the deepest first; `selector` is that of SEL and MUX.
pub(super) fn of_texts<'p>(
    function: StandardFunction,
    selector: Option<u64>,
    texts: &mut [Text<'p>],
) -> Result<Text<'p>, Halt> {
    let missing = Halt::Missing("operand of a standard function");
    let chosen = match function {
        StandardFunction::Concat => return Ok(Cow::Owned(texts.concat())),
        StandardFunction::Sel | StandardFunction::Mux => {
            let selector = selector.ok_or(missing)?;
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
        // The first of equal texts, as for plain values.
        StandardFunction::Min => texts
            .iter_mut()
            .reduce(|a, b| if *b < *a { b } else { a })
            .ok_or(missing)?,
        StandardFunction::Max => texts
            .iter_mut()
            .reduce(|a, b| if *b > *a { b } else { a })
            .ok_or(missing)?,
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
