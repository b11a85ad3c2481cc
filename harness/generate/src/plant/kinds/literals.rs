//! Literals and constant expressions outside the ranges of their types.

use super::super::fault_site::FaultSite;
use super::super::scope::elementary;
use super::super::walk::{ExpressionContext, ExpressionSite};
use crate::model::{Expression, ExpressionKind, Type};
use stickler_types::{Dialect, ElementaryType};

/// Plants an untyped integer literal outside the type of the other operand.
pub(super) fn integer_for_operand(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let range = |site: ExpressionSite, expression: &Expression| match site.context {
        // Beside a narrower operand that widens, the literal would make the whole narrower, and other literals with it wrong.
        ExpressionContext::Operand(_, Some(other)) if expression.ty == Type::Elementary(other) => {
            range_of_integer(other)
        }
        _ => None,
    };
    let (number, site, expression) =
        fault.pick_expression(|site, expression| range(site, expression).is_some())?;
    let (low, high) = range(site, &expression)?;
    let beyond = vec![high + 1, low - 1, high * 3, i128::from(u64::MAX) * 1000];
    let value = fault.choose(beyond)?;
    fault.replace(number, ExpressionKind::Raw(value.to_string()))
}

/// Returns the least and the greatest value of an integer type; `None` for a bit string or BOOL.
pub(super) fn range_of_integer(ty: ElementaryType) -> Option<(i128, i128)> {
    ty.integer_range().filter(|_| ty.is_integer())
}

/// Plants a based literal with more bits than its bit string has, where the dialect takes one.
///
/// Basis: ironplc-problem-codes: P2026; widening/literal-too-long-for-a-bit-string.toml.
pub(super) fn bits_for_target(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let everywhere = Dialect::of(original.dialect).integer_literal_as_bit_string;
    if !original.dialect.rules().documents.untyped_literals {
        return None;
    }
    let bits = |expression: &Expression| elementary(original, &expression.ty).filter(|ty| ty.is_bit_string());
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        let taken = match site.context {
            ExpressionContext::Initial => true,
            context => context.has_target() && everywhere,
        };
        taken && bits(expression).is_some()
    })?;
    let digits = usize::try_from(bits(&expression)?.bits() / 4).ok()?;
    fault.replace(number, ExpressionKind::Raw(format!("16#1{}", "0".repeat(digits))))
}

/// Plants a constant subscript outside the array.
///
/// Basis: language/diagnostics-constants.st.
pub(super) fn subscript(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let (number, site, _) =
        fault.pick_expression(|site, _| matches!(site.context, ExpressionContext::Subscript(..)))?;
    let ExpressionContext::Subscript(low, high) = site.context else {
        return None;
    };
    let value = fault.choose(vec![high.checked_add(1)?, low.checked_sub(1)?])?;
    fault.replace(number, ExpressionKind::Raw(value.to_string()))
}
