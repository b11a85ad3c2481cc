//! Accesses to bits that do not exist.
//!
//! Basis: ironplc-bit-access, which is why most kinds are for the dialects of IronPLC only; a kind with another basis names
//! it.

use super::super::fault_site::{FaultSite, literal};
use super::super::scope::elementary;
use super::operands::stands_for_any_value;
use crate::model::{AssignmentTarget, ExpressionKind, Place, Program, Statement, Type, Unit};
use stickler_types::ElementaryType;

/// Returns the number of bits of a type that has bits.
pub(super) fn bits(program: &Program, ty: &Type) -> Option<u32> {
    let ty = elementary(program, ty)?;
    (ty.is_integer() || ty.is_bit_string()).then(|| ty.bits())
}

/// Bits that a type does not have.
#[derive(serde::Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) struct MissingBits {
    /// Whether they lie beyond the last bit; otherwise the type has none: a BOOL, a real, a duration, a text, an aggregate, an
    /// enumeration.
    beyond_the_last: bool,
    /// Their numbers, counted from the first that the type does not have.
    numbers: Vec<u32>,
}

impl MissingBits {
    /// Plants a read. A bit beyond the last one is read where a BOOL is expected; in any other place the BOOL would be a second
    /// error.
    pub(super) fn read(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        let original = fault.original;
        let (number, site, _) = fault.pick_expression(|site, expression| {
            let is_bool = elementary(original, &expression.ty) == Some(ElementaryType::Bool);
            stands_for_any_value(site, expression) && (is_bool || !self.beyond_the_last)
        })?;
        let (place, bit) = self.choose(fault, site.unit, false)?;
        fault.replace(number, ExpressionKind::Bit(place, bit))
    }

    /// Plants an assignment.
    pub(super) fn write(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        fault.insert(
            |_, _| true,
            |fault, unit| {
                let (place, bit) = self.choose(fault, unit, true)?;
                let value = literal(ElementaryType::Bool);
                Some(Statement::Assign(AssignmentTarget::Bit(place, bit), value))
            },
        )
    }

    /// Picks a place and the number of a bit that it does not have; `None` also where the dialect has no access to bits.
    fn choose(&self, fault: &mut FaultSite<'_, '_>, unit: Unit, is_written: bool) -> Option<(Place, u32)> {
        let original = fault.original;
        if !original.dialect.rules().documents.bits {
            return None;
        }
        let place = fault.place(unit, |place, writable| {
            let has_bits = bits(original, &place.ty).is_some();
            (writable || !is_written)
                && has_bits == self.beyond_the_last
                && (has_bits || !matches!(place.ty, Type::Block(_)))
        })?;
        let first = bits(original, &place.ty).unwrap_or_default();
        let bit = first + fault.choose(self.numbers.clone())?;
        Some((place, bit))
    }
}
