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

/// Omits a conversion from an operand.
pub(super) fn conversion_left_out_of_operand(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    omit_conversion(fault, |context| {
        matches!(context, ExpressionContext::Operand(_, Some(_)))
    })
}

/// Replaces a call of a conversion function by its argument. A bare call that is assigned would have another code.
pub(super) fn omit_conversion(
    fault: &mut FaultSite<'_, '_>,
    eligible: impl Fn(ExpressionContext) -> bool,
) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, site, expression) = fault.pick_expression(|site, expression| {
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
        let is_assigned = matches!(
            site.context,
            ExpressionContext::Assigned | ExpressionContext::Result
        );
        eligible(site.context)
            && !(is_assigned && is_call(argument))
            && free
            && never(from, into, dialect)
            && converts(from, into, dialect)
    })?;
    let ExpressionKind::Convert(_, argument) = expression.kind else {
        return None;
    };
    fault.change(number, |place| *place = *argument);
    fault.suggested = site.context.has_target();
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
