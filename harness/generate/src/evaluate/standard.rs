//! Standard functions other than conversions.
//!
//! Basis: iec-61131-3: Tables 28 to 32 and 34; the tables standard-functions and functions-of-texts of the cases. IEC 60559 rounds a square root
//! once.

use super::arithmetic::{self, Computed};
use super::evaluator::ModelEvaluator;
use super::memory::MemoryCell;
use super::{Evaluated, EvaluationError, OpenQuestion, ill_formed};
use crate::model::{Expression, StandardFunction, Type, UnaryOperator};
use std::cmp::Ordering;
use stickler_types::dialect::TextPositions;
use stickler_types::{ElementaryType, Family};

/// The shortest default length of a text among the known systems; a longer text may be truncated by one of them.
const SHORTEST_DEFAULT_LENGTH: usize = 80;

const ARGUMENTS: EvaluationError = ill_formed("a standard function with other arguments than it has");

impl<'p> ModelEvaluator<'p> {
    /// Computes a standard function; all arguments are evaluated, in their order.
    pub fn standard(
        &mut self,
        function: StandardFunction,
        arguments: &'p [Expression],
    ) -> Evaluated<MemoryCell> {
        use StandardFunction::{
            Abs, Concat, Find, Left, Len, Limit, Max, Min, Mux, Right, Rol, Ror, Sel, Shl, Shr, SquareRoot,
        };
        let mut cells = Vec::with_capacity(arguments.len());
        for argument in arguments {
            cells.push(self.expression(argument)?);
        }
        let keeps = self.program.dialect.rules().keeps_not_finite;
        let is_finite = |(cell, argument): (&MemoryCell, &'p Expression)| {
            let (MemoryCell::Plain(raw), Ok(ty)) = (cell, self.elementary(&argument.ty)) else {
                return true;
            };
            ty.real_value(*raw).is_none_or(f64::is_finite)
        };
        let is_kept = keeps && !cells.iter().zip(arguments).all(is_finite);
        match (function, &cells[..], arguments) {
            // What is not finite, or has a limit that is not, stays what it is.
            (Abs, [value], _) | (Limit, [_, value, _], _) if is_kept => Ok(value.clone()),
            (Abs, [cell], [argument]) => self.absolute(argument, cell),
            (Sel, [MemoryCell::Plain(gate), first, second], _) => {
                Ok(if *gate == 0 { first } else { second }.clone())
            }
            (Mux, [MemoryCell::Plain(selector), inputs @ ..], [argument, ..]) => {
                let selector = self.elementary(&argument.ty)?.integer_value(*selector);
                self.selected(selector, inputs)
            }
            (Min, [a, b], [argument, _]) => self.lesser(argument, a, b, Ordering::Less),
            (Max, [a, b], [argument, _]) => self.lesser(argument, a, b, Ordering::Greater),
            (Limit, [low, value, high], [argument, ..]) => self.limited(argument, low, value, high),
            (Shl | Shr | Rol | Ror, [MemoryCell::Plain(raw), MemoryCell::Plain(count)], [operand, by]) => {
                let count = self.elementary(&by.ty)?.integer_value(*count);
                let ty = self.elementary(&operand.ty)?;
                let computed = shifted(function, ty, *raw, count).ok_or(ARGUMENTS)?;
                self.computed(computed, || format!("{function:?} of {ty} by {count}"))
            }
            (Len, [MemoryCell::Text(units)], _) => Ok(MemoryCell::Plain(units.len() as u64)),
            (Find, [MemoryCell::Text(units), MemoryCell::Text(sought)], _) if !sought.is_empty() => {
                let mut places = units.windows(sought.len());
                let at = places.position(|place| place == &sought[..]);
                Ok(MemoryCell::Plain(at.map_or(0, |at| at as u64 + 1)))
            }
            (Left | Right, [MemoryCell::Text(units), MemoryCell::Plain(count)], _) => {
                let count = usize::try_from(*count).unwrap_or(usize::MAX);
                let is_whole = self.program.dialect.rules().text_positions == TextPositions::Whole;
                let kept = match count > units.len() && is_whole {
                    true => 0,
                    false => count.min(units.len()),
                };
                let (left, right) = (&units[..kept], &units[units.len() - kept..]);
                Ok(MemoryCell::Text(
                    if function == Left { left } else { right }.into(),
                ))
            }
            (SquareRoot, [MemoryCell::Plain(raw)], [argument]) => {
                Ok(MemoryCell::Plain(match self.elementary(&argument.ty)? {
                    ElementaryType::Real => f32::from_bits(*raw as u32).sqrt().to_bits().into(),
                    _ => f64::from_bits(*raw).sqrt().to_bits(),
                }))
            }
            (Concat, [MemoryCell::Text(a), MemoryCell::Text(b)], _) => {
                let joined = [&a[..], &b[..]].concat();
                if joined.len() > SHORTEST_DEFAULT_LENGTH {
                    self.open(OpenQuestion::TextLength, || {
                        format!("CONCAT gives {} characters", joined.len())
                    });
                }
                Ok(MemoryCell::Text(joined.into_boxed_slice()))
            }
            _ => Err(ARGUMENTS),
        }
    }

    fn absolute(&mut self, argument: &'p Expression, cell: &MemoryCell) -> Evaluated<MemoryCell> {
        let ty = self.elementary(&argument.ty)?;
        let MemoryCell::Plain(raw) = *cell else {
            return Err(ARGUMENTS);
        };
        let computed = match ty.family() {
            Family::Unsigned => Computed { raw, question: None },
            Family::Real => Computed {
                raw: raw & !(1 << (ty.bits() - 1)),
                question: None,
            },
            Family::Signed if ty.integer_value(raw) >= 0 => Computed { raw, question: None },
            Family::Signed => arithmetic::unary(UnaryOperator::Negate, ty, raw).ok_or(ARGUMENTS)?,
            _ => return Err(ARGUMENTS),
        };
        self.computed(computed, String::new)
    }

    /// Returns the input of MUX that the selector chooses, counted from 0.
    fn selected(&mut self, selector: i128, inputs: &[MemoryCell]) -> Evaluated<MemoryCell> {
        let chosen = usize::try_from(selector).ok().and_then(|index| inputs.get(index));
        if chosen.is_none() {
            self.open(OpenQuestion::MuxSelector, || {
                format!("{selector} of {}", inputs.len())
            });
        }
        chosen.or(inputs.first()).cloned().ok_or(ARGUMENTS)
    }

    /// Computes MIN if the first operand is wanted to be `Less`, MAX if it is wanted to be `Greater`.
    fn lesser(
        &mut self,
        argument: &'p Expression,
        a: &MemoryCell,
        b: &MemoryCell,
        wanted: Ordering,
    ) -> Evaluated<MemoryCell> {
        let ty = self.comparable(argument)?;
        let order = arithmetic::compare(ty, a, b);
        if order.is_none() || (order == Some(Ordering::Equal) && a != b) {
            self.open(OpenQuestion::ZerosOfTwoSigns, || format!("MIN or MAX of {ty}"));
        }
        Ok(if order == Some(wanted) { a } else { b }.clone())
    }

    /// Computes LIMIT as the standard defines it: MIN(MAX(low, value), high).
    fn limited(
        &mut self,
        argument: &'p Expression,
        low: &MemoryCell,
        value: &MemoryCell,
        high: &MemoryCell,
    ) -> Evaluated<MemoryCell> {
        let ty = self.comparable(argument)?;
        if arithmetic::compare(ty, low, high).is_some_and(Ordering::is_gt) {
            self.open(OpenQuestion::LimitsCrossed, || format!("LIMIT of {ty}"));
        }
        let above = self.lesser(argument, low, value, Ordering::Greater)?;
        self.lesser(argument, &above, high, Ordering::Less)
    }

    /// Returns the type by which values compare.
    fn comparable(&self, argument: &'p Expression) -> Evaluated<ElementaryType> {
        match self.resolved(&argument.ty) {
            Type::Elementary(ty) => Ok(*ty),
            _ => Err(ARGUMENTS),
        }
    }
}

/// Computes a shift or rotation of a bit string; `None` if the type has none.
///
/// Basis: iec-61131-3: Table 30. For counts of the width and more, the table standard-functions of the cases: bits are
/// shifted out, or rotate around.
fn shifted(function: StandardFunction, ty: ElementaryType, raw: u64, count: i128) -> Option<Computed> {
    if !ty.is_bit_string() {
        return None;
    }
    let bits = i128::from(ty.bits());
    let question = if count < 0 {
        Some(OpenQuestion::NegativeShiftCount)
    } else {
        (count >= bits).then_some(OpenQuestion::ShiftCount)
    };
    let (number, by) = (i128::from(raw), count.clamp(0, 64) as u32);
    let around = count.rem_euclid(bits) as u32;
    let rest = ty.bits() - around;
    let exact = match function {
        StandardFunction::Shl => number << by,
        StandardFunction::Shr => number >> by,
        StandardFunction::Rol => number << around | number >> rest,
        StandardFunction::Ror => number >> around | number << rest,
        _ => return None,
    };
    Some(Computed {
        raw: ty.wrap(exact),
        question,
    })
}
