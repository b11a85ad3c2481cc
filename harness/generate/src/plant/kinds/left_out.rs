//! Conversion functions left out where nothing converts without them.
//!
//! Basis: stickler-design: §7 (*which code where*), §8; the documents on implicit conversion, as `stickler_exact::implicit` has
//! them.

use super::super::plot::Plot;
use super::super::scope::written;
use super::super::walk::Context;
use super::misfits::{converts, never};
use super::operands::calculates;
use crate::model::{Expression, ExpressionKind};

/// A conversion left out where a value is assigned.
pub(super) fn conversion_left_out_of_assignment(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let assigned = |context| matches!(context, Context::Assigned | Context::Result);
    left_out(plot, assigned, |argument| !is_call(argument))?;
    plot.suggested = true;
    Some(())
}

/// A conversion left out of an argument.
pub(super) fn conversion_left_out_of_argument(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let argument = |context| matches!(context, Context::Argument | Context::Input);
    left_out(plot, argument, |_| true)?;
    plot.suggested = true;
    Some(())
}

/// A conversion left out of a condition.
pub(super) fn conversion_left_out_of_condition(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let condition = |context| {
        matches!(
            context,
            Context::If | Context::ElsIf | Context::While | Context::Until
        )
    };
    left_out(plot, condition, |_| true)
}

/// A conversion left out of an operand.
pub(super) fn conversion_left_out_of_operand(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let operand = |context| matches!(context, Context::Operand(_, Some(_)));
    left_out(plot, operand, |_| true)
}

/// Puts the argument of a conversion function where its call stands.
fn left_out(
    plot: &mut Plot<'_, '_, '_>,
    context: fn(Context) -> bool,
    argument_fits: fn(&Expression) -> bool,
) -> Option<()> {
    let dialect = plot.original.dialect;
    let (number, _, expression) = plot.site(|site, expression| {
        let ExpressionKind::Convert(signature, argument) = &expression.kind else {
            return false;
        };
        let Some(from) = written(argument) else {
            return false;
        };
        let (into, free) = match site.context {
            Context::Operand(operator, Some(other)) => (
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
    plot.change(number, |place| *place = *argument);
    Some(())
}

/// Whether nothing but a call is written.
fn is_call(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Widen(operand) => is_call(operand),
        ExpressionKind::Call(..) | ExpressionKind::Convert(..) | ExpressionKind::Standard(..) => true,
        _ => false,
    }
}
