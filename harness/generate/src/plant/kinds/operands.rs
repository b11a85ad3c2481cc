//! Operators beside operands for which they are not defined.
//!
//! Basis: ironplc-problem-codes: P4049; stickler-design: §8 (*mixed operands*).

use super::super::plot::Plot;
use super::super::scope::types;
use super::super::walk::{Context, Site};
use super::misfits::{ALL_SHAPES, Shape, foreign, never, value};
use crate::model::{BinaryOperator, Expression, ExpressionKind, Type, UnaryOperator, Unit};
use stickler_types::{ElementaryType, Family};

/// An operand of a type that has nothing in common with the other's.
pub(super) fn operand(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let dialect = plot.original.dialect;
    let (number, site, _) = plot.site(|site, _| matches!(site.context, Context::Operand(_, Some(_))))?;
    let Context::Operand(operator, Some(other)) = site.context else {
        return None;
    };
    let strange = |from| {
        never(from, other, dialect) && never(other, from, dialect) && !calculates(operator, from, other)
    };
    let shape = plot.choose(ALL_SHAPES.to_vec())?;
    let kind = if shape == Shape::Foreign {
        foreign(plot, strange)?
    } else {
        let from = plot.choose(types(dialect).filter(|&from| strange(from)).collect())?;
        value(plot, site.unit, from, shape)?
    };
    plot.replace(number, kind);
    Some(())
}

/// Whether the standard calculates with two different types: durations with numbers, dates and times of day with durations.
///
/// Basis: iec-61131-3: Table 35.
pub(super) fn calculates(operator: BinaryOperator, one: ElementaryType, other: ElementaryType) -> bool {
    let of_moments = |ty: ElementaryType| ty.is_duration() || ty.is_date_or_time();
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

/// The operand of an operator with one, which is not defined for its type.
pub(super) fn only_operand(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let dialect = plot.original.dialect;
    let (number, site, _) = plot.site(|site, _| matches!(site.context, Context::UnaryOperand(_)))?;
    let Context::UnaryOperand(operator) = site.context else {
        return None;
    };
    let from = plot.choose(types(dialect).filter(|&ty| undefined(operator, ty)).collect())?;
    let kind = plot.variable(site.unit, from)?;
    plot.replace(number, kind);
    Some(())
}

/// Whether an operator is not defined for a type. That unsigned integers have no negatives is not said anywhere.
///
/// Basis: iec-61131-3: Table 71; language/diagnostics-operators.st.
fn undefined(operator: UnaryOperator, ty: ElementaryType) -> bool {
    match operator {
        UnaryOperator::Not => ty != ElementaryType::Bool && !ty.is_bit_string(),
        UnaryOperator::Negate => !ty.is_integer() && !ty.is_real() && !ty.is_duration(),
    }
}

/// An operation that its operands' type does not have, somewhere in the place of a value.
pub(super) fn undefined_operation(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    use BinaryOperator as B;
    let dialect = plot.original.dialect;
    let (number, site, _) = plot.site(stands_for_any_value)?;
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
    let operator = plot.choose(operators)?;
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
    let ty = plot.choose(types(dialect).filter(without).collect())?;
    let kind = plot.variable(site.unit, ty)?;
    let operand = || Box::new(Expression::elementary(ty, kind.clone()));
    plot.replace(number, ExpressionKind::Binary(operator, operand(), operand()));
    Some(())
}

/// Whether any expression may stand there, with an error of its own and no other: neither a constant, nor a variable, nor a
/// label is wanted.
pub(super) fn stands_for_any_value(site: Site, _: &Expression) -> bool {
    site.unit != Unit::Types
        && !matches!(
            site.context,
            Context::Initial | Context::InOut | Context::Label | Context::Step
        )
}

/// Aggregates where an operator wants elementary values: structures and arrays do not even compare.
pub(super) fn compared_aggregates(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, site, _) = plot.site(stands_for_any_value)?;
    let place = plot.place(site.unit, |place, _| {
        original.fields(&place.ty).is_some() || matches!(original.unaliased(&place.ty), Type::Array(_))
    })?;
    let operand = || {
        Box::new(Expression {
            ty: place.ty.clone(),
            kind: ExpressionKind::Read(place.clone()),
        })
    };
    let kind = ExpressionKind::Binary(BinaryOperator::Equal, operand(), operand());
    plot.replace(number, kind);
    Some(())
}
