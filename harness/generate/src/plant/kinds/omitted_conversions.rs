//! Conversion functions omitted where no implicit conversion replaces them.
//!
//! Basis: rule: code-of-the-context; the documents on implicit conversion, as `stickler_exact::implicit`
//! has them.

use super::super::fault_site::FaultSite;
use super::super::scope::written;
use super::super::walk::ExpressionContext;
use super::misfits::{converts, never};
use super::operands::calculates;
use crate::model::{Expression, ExpressionKind};

/// Omits a conversion from an assigned value.
pub(super) fn conversion_left_out_of_assignment(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let assigned = |context| matches!(context, ExpressionContext::Assigned | ExpressionContext::Result);
    omit_conversion(fault, assigned, |argument| !is_call(argument))?;
    fault.suggested = true;
    Some(())
}

/// Omits a conversion from an argument.
pub(super) fn conversion_left_out_of_argument(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let argument = |context| matches!(context, ExpressionContext::Argument | ExpressionContext::Input);
    omit_conversion(fault, argument, |_| true)?;
    fault.suggested = true;
    Some(())
}

/// Omits a conversion from a condition.
pub(super) fn conversion_left_out_of_condition(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let condition = |context| {
        matches!(
            context,
            ExpressionContext::If
                | ExpressionContext::ElsIf
                | ExpressionContext::While
                | ExpressionContext::Until
        )
    };
    omit_conversion(fault, condition, |_| true)
}

/// Omits a conversion from an operand.
pub(super) fn conversion_left_out_of_operand(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let operand = |context| matches!(context, ExpressionContext::Operand(_, Some(_)));
    omit_conversion(fault, operand, |_| true)
}

/// Replaces a call of a conversion function by its argument.
fn omit_conversion(
    fault: &mut FaultSite<'_, '_>,
    context: fn(ExpressionContext) -> bool,
    argument_fits: fn(&Expression) -> bool,
) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        let ExpressionKind::Convert(signature, argument) = &expression.kind else {
            return false;
        };
        let Some(from) = written(argument) else {
            return false;
        };
        let (into, free) = match site.context {
            ExpressionContext::Operand(operator, Some(other)) => (
                other,
                never(other, from, dialect) && !calculates(operator, from, other),
            ),
            _ => (signature.result, true),
        };
        context(site.context)
            && argument_fits(argument)
            && free
            && never(from, into, dialect)
            && converts(from, into, dialect)
    })?;
    let ExpressionKind::Convert(_, argument) = expression.kind else {
        return None;
    };
    fault.change(number, |place| *place = *argument);
    Some(())
}

/// Returns whether an expression is written as a bare call.
fn is_call(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Widen(operand) => is_call(operand),
        ExpressionKind::Call(..) | ExpressionKind::Convert(..) | ExpressionKind::Standard(..) => true,
        _ => false,
    }
}
