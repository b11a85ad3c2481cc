//! Operators with operands for which they are not defined.
//!
//! Basis: ironplc-problem-codes: P4049; rule: mixed-operands.

use super::super::fault_site::FaultSite;
use super::super::scope::types;
use super::super::walk::{ExpressionContext, ExpressionSite};
use super::misfits::{ALL_MISFIT_FORMS, MisfitForm, foreign, never, value};
use crate::model::{BinaryOperator, Expression, ExpressionKind, Type, UnaryOperator, Unit};
use stickler_types::{ElementaryType, Family};

/// Plants an operand of a type that has no common type with the other operand.
pub(super) fn operand(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, site, _) =
        fault.pick_expression(|site, _| matches!(site.context, ExpressionContext::Operand(_, Some(_))))?;
    let ExpressionContext::Operand(operator, Some(other)) = site.context else {
        return None;
    };
    let strange = |from| {
        never(from, other, dialect) && never(other, from, dialect) && !calculates(operator, from, other)
    };
    let shape = fault.choose(ALL_MISFIT_FORMS.to_vec())?;
    let kind = if shape == MisfitForm::Foreign {
        foreign(fault, strange)?
    } else {
        let from = fault.choose(types(dialect).filter(|&from| strange(from)).collect())?;
        value(fault, site.unit, from, shape)?
    };
    fault.replace(number, kind)
}

/// Returns whether the standard calculates with two different types: durations with numbers, dates and times of day with
/// durations.
///
/// Basis: iec-61131-3: Table 35.
pub(super) fn calculates(operator: BinaryOperator, one: ElementaryType, other: ElementaryType) -> bool {
    let of_moments = ElementaryType::is_moment;
    let number = |ty: ElementaryType| ty.is_integer() || ty.is_real();
    let both = |this: &dyn Fn(ElementaryType) -> bool, that: &dyn Fn(ElementaryType) -> bool| {
        this(one) && that(other) || this(other) && that(one)
    };
    match operator {
        BinaryOperator::Multiply | BinaryOperator::Divide => both(&of_moments, &number),
        BinaryOperator::Add | BinaryOperator::Subtract => both(&of_moments, &of_moments),
        _ => false,
    }
}

/// Plants an operand of a unary operator that is not defined for its type.
pub(super) fn only_operand(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, site, _) =
        fault.pick_expression(|site, _| matches!(site.context, ExpressionContext::UnaryOperand(_)))?;
    let ExpressionContext::UnaryOperand(operator) = site.context else {
        return None;
    };
    let from = fault.choose(types(dialect).filter(|&ty| undefined(operator, ty)).collect())?;
    let kind = fault.variable(site.unit, from)?;
    fault.replace(number, kind)
}

/// Returns whether an operator is not defined for a type. That unsigned integers have no negatives is stated nowhere.
///
/// Basis: iec-61131-3: Table 71; language/diagnostics-operators.st.
fn undefined(operator: UnaryOperator, ty: ElementaryType) -> bool {
    match operator {
        UnaryOperator::Not => ty != ElementaryType::Bool && !ty.is_bit_string(),
        UnaryOperator::Negate => !ty.is_integer() && !ty.is_real() && !ty.is_duration(),
    }
}

/// Plants an operation that the type of its operands does not have, in the place of a value.
pub(super) fn undefined_operation(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    use BinaryOperator as B;
    let dialect = fault.original.dialect;
    let (number, site, _) = fault.pick_expression(stands_for_any_value)?;
    let operators = vec![
        B::Add,
        B::Subtract,
        B::Multiply,
        B::Divide,
        B::Modulo,
        B::And,
        B::Or,
        B::Xor,
    ];
    let operator = fault.choose(operators)?;
    let without = |ty: &ElementaryType| match operator {
        B::Modulo => ty.is_real() || *ty == ElementaryType::Bool || ty.is_text(),
        B::And | B::Or | B::Xor => ty.is_integer() || ty.is_real() || ty.is_text() || ty.is_duration(),
        B::Multiply | B::Divide => {
            matches!(
                ty.family(),
                Family::Boolean | Family::BitString | Family::Duration
            ) || ty.is_text()
        }
        _ => matches!(ty.family(), Family::Boolean | Family::BitString) || ty.is_text(),
    };
    let ty = fault.choose(types(dialect).filter(without).collect())?;
    let kind = fault.variable(site.unit, ty)?;
    let operand = || Box::new(Expression::elementary(ty, kind.clone()));
    fault.replace(number, ExpressionKind::Binary(operator, operand(), operand()))
}

/// Returns whether a place takes any expression, so that the planted error is the only one: the context demands neither a
/// constant, nor a variable, nor a label.
pub(super) fn stands_for_any_value(site: ExpressionSite, _: &Expression) -> bool {
    site.unit != Unit::Types
        && !matches!(
            site.context,
            ExpressionContext::Initial
                | ExpressionContext::InOut
                | ExpressionContext::Label
                | ExpressionContext::Step
        )
}

/// Plants aggregates as operands: structures and arrays do not even compare.
pub(super) fn compared_aggregates(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let (number, site, _) = fault.pick_expression(stands_for_any_value)?;
    let place = fault.place(site.unit, |place, _| {
        original.fields(&place.ty).is_some() || matches!(original.unaliased(&place.ty), Type::Array(_))
    })?;
    let operand = || Box::new(Expression::read(place.clone()));
    let kind = ExpressionKind::Binary(BinaryOperator::Equal, operand(), operand());
    fault.replace(number, kind)
}
