//! Accesses to bits that do not exist.
//!
//! Basis: ironplc-bit-access, which is why most kinds are for the dialects of IronPLC only; a kind with another basis names
//! it.

use super::super::fault_site::{FaultSite, literal};
use super::super::scope::elementary;
use super::operands::stands_for_any_value;
use crate::model::{AssignmentTarget, Expression, ExpressionKind, Place, Program, Statement, Type};
use stickler_types::ElementaryType;

/// Returns the number of bits of a type that has bits.
pub(super) fn bits(program: &Program, ty: &Type) -> Option<u32> {
    let ty = elementary(program, ty)?;
    (ty.is_integer() || ty.is_bit_string()).then(|| ty.bits())
}

/// Plants a read of a bit beyond the last one where a BOOL is expected; in any other place the BOOL would be a second error.
///
/// Basis: bit-access/outside-and-no-bool.st.
pub(super) fn outside_read(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    read(
        fault,
        |expression| elementary(original, &expression.ty) == Some(ElementaryType::Bool),
        |place| bits(original, &place.ty).is_some(),
        |width| vec![width, width * 2, 1000],
    )
}

/// Plants a read of a bit of something without bits: a BOOL, a real, a duration, a text, an aggregate, an enumeration.
pub(super) fn none_read(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    read(
        fault,
        |_| true,
        |place| has_none(original, place),
        |_| vec![0, 1, 31],
    )
}

fn has_none(program: &Program, place: &Place) -> bool {
    bits(program, &place.ty).is_none() && !matches!(place.ty, Type::Block(_))
}

/// Replaces an expression, in a place that takes any value, by a bit of some place.
fn read(
    fault: &mut FaultSite<'_, '_>,
    gives_way: impl Fn(&Expression) -> bool,
    eligible: impl Fn(&Place) -> bool,
    numbers: impl Fn(u32) -> Vec<u32>,
) -> Option<()> {
    let original = fault.original;
    if !original.dialect.rules().documents.bits {
        return None;
    }
    let (number, site, _) = fault.pick_expression(|site, expression| {
        stands_for_any_value(site, expression) && gives_way(expression)
    })?;
    let place = fault.place(site.unit, |place, _| eligible(place))?;
    let width = bits(original, &place.ty).unwrap_or_default();
    let bit = fault.choose(numbers(width))?;
    fault.replace(number, ExpressionKind::Bit(place, bit))
}

/// Plants a bit beyond the last one, written.
pub(super) fn outside_written(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let has_bits = |place: &Place| bits(original, &place.ty).is_some();
    written(fault, has_bits, |width| vec![width, width + 1, 99])
}

/// Plants a bit of what has no bits, written.
pub(super) fn none_written(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    written(fault, |place| has_none(original, place), |_| vec![0, 7])
}

fn written(
    fault: &mut FaultSite<'_, '_>,
    eligible: impl Fn(&Place) -> bool,
    numbers: impl Fn(u32) -> Vec<u32>,
) -> Option<()> {
    let original = fault.original;
    if !original.dialect.rules().documents.bits {
        return None;
    }
    fault.insert(
        |_, _| true,
        |fault, unit| {
            let place = fault.place(unit, |place, writable| writable && eligible(place))?;
            let bit = fault.choose(numbers(bits(original, &place.ty).unwrap_or_default()))?;
            let value = literal(ElementaryType::Bool);
            Some(Statement::Assign(AssignmentTarget::Bit(place, bit), value))
        },
    )
}
