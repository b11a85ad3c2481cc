//! Literals and constant expressions outside the ranges of their types.

use super::super::fault_site::FaultSite;
use super::super::scope::elementary;
use super::super::walk::{ExpressionContext, ExpressionSite};
use super::operands::stands_for_any_value;
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

/// Plants a typed literal that its type does not hold.
///
/// Basis: language/literals-outside.toml; widening/typed-literal-that-does-not-fit.toml.
pub(super) fn typed_integer(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let (number, ty) = integer_site(fault)?;
    let (low, high) = ty.integer_range()?;
    let mut beyond = vec![high + 1];
    if low < 0 {
        beyond.push(low - 1);
    }
    let value = fault.choose(beyond)?;
    fault.replace(number, ExpressionKind::Raw(format!("{ty}#{value}")))
}

/// Picks a place for a value of an integer type without an implicit conversion.
pub(super) fn integer_site(fault: &mut FaultSite<'_, '_>) -> Option<(usize, ElementaryType)> {
    let original = fault.original;
    let integer = |expression: &Expression| elementary(original, &expression.ty).filter(|ty| ty.is_integer());
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        stands_for_any_value(site, expression) && integer(expression).is_some()
    })?;
    Some((number, integer(&expression)?))
}

/// Plants a real literal beyond its type.
///
/// Basis: language/literals-outside.toml.
pub(super) fn real(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let real = |expression: &Expression| elementary(original, &expression.ty).filter(|ty| ty.is_real());
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        let with_target = site.context.has_target() || site.context == ExpressionContext::Initial;
        with_target && real(expression).is_some()
    })?;
    let ty = real(&expression)?;
    let beyond = if ty == ElementaryType::Real {
        "1.0E39"
    } else {
        "1.0E309"
    };
    let texts = vec![beyond.to_owned(), format!("-{beyond}"), format!("{ty}#{beyond}")];
    let text = fault.choose(texts)?;
    fault.replace(number, ExpressionKind::Raw(text))
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
