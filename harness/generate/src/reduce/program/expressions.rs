//! Passes that replace expressions by plainer ones of the same type.

use super::plain::{Simplification, literal_kind, plainest};
use super::usage::instance_of;
use crate::model::visit::operands;
use crate::model::visit_mut::{
    VisitorMut, walk_expression, walk_place, walk_program, walk_statement, walk_variable,
};
use crate::model::{
    Argument, AssignmentTarget, Expression, ExpressionKind, InitialValue, LiteralForm, Place, Program,
    Statement, StatementKind, Type, Unit, Variable, VariableId, VariableSection,
};
use stickler_reduce::Sites;
use stickler_types::Value;

/// Replaces expressions by the plainest literal of their type, outermost first.
pub(super) fn to_plainest(program: &mut Program, sites: &mut Sites) {
    replace(program, sites, |expression, program| {
        if matches!(
            expression.kind,
            ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_)
        ) {
            return None;
        }
        plainest(program, &expression.ty)
    });
}

/// Replaces expressions by their first operand or argument of the same type.
pub(super) fn to_first_operand(program: &mut Program, sites: &mut Sites) {
    replace(program, sites, |expression, _| operand(expression, 0));
}

/// Replaces expressions by their second operand or argument of the same type.
pub(super) fn to_second_operand(program: &mut Program, sites: &mut Sites) {
    replace(program, sites, |expression, _| operand(expression, 1));
}

/// Replaces expressions by their third operand or argument of the same type.
pub(super) fn to_third_operand(program: &mut Program, sites: &mut Sites) {
    replace(program, sites, |expression, _| operand(expression, 2));
}

/// Returns the operand with an index among those of the same type as the whole.
fn operand(expression: &Expression, which: usize) -> Option<Expression> {
    operands(expression)
        .into_iter()
        .filter(|operand| operand.ty == expression.ty)
        .nth(which)
        .cloned()
        .map(with_prefix)
}

/// Adds the prefix to an untyped literal, which may only stand where it stood.
fn with_prefix(mut expression: Expression) -> Expression {
    if let ExpressionKind::Literal(value, LiteralForm::Untyped) = expression.kind {
        expression.kind = literal_kind(value);
    }
    expression
}

/// Replaces the chosen expressions among those that may be any of their type and have a replacement.
pub(super) fn replace(
    program: &mut Program,
    sites: &mut Sites,
    with: impl FnMut(&Expression, &Program) -> Option<Expression>,
) {
    let before = program.clone();
    walk_program(
        &mut Replacer {
            before: &before,
            unit: Unit::Main,
            sites,
            with,
        },
        program,
    );
}

struct Replacer<'p, 's, F> {
    before: &'p Program,
    unit: Unit,
    sites: &'s mut Sites,
    with: F,
}

impl<F: FnMut(&Expression, &Program) -> Option<Expression>> VisitorMut for Replacer<'_, '_, F> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn expression(&mut self, expression: &mut Expression) {
        match (self.with)(expression, self.before) {
            Some(plainer) if self.sites.here() => *expression = plainer,
            _ => walk_expression(self, expression),
        }
    }

    fn literal(&mut self, _: &mut Expression) {}

    fn input(&mut self, instance: VariableId, argument: &mut Argument) {
        let before = self.before;
        walk_input(self, before, self.unit, instance, argument);
    }
}

/// Visits an argument in the call of a function block: the argument of an in-out stays a variable, and only its subscripts
/// may change.
pub(super) fn walk_input(
    visitor: &mut impl VisitorMut,
    program: &Program,
    unit: Unit,
    instance: VariableId,
    argument: &mut Argument,
) {
    if !is_in_out(program, unit, instance, argument.parameter) {
        visitor.expression(&mut argument.value);
    } else if let ExpressionKind::Read(place) = &mut argument.value.kind {
        walk_place(visitor, place);
    }
}

/// Returns whether a parameter of an instance is an in-out.
pub(super) fn is_in_out(program: &Program, unit: Unit, instance: VariableId, parameter: VariableId) -> bool {
    instance_of(program, unit, instance)
        .and_then(|block| program.blocks.get(block)?.variables.get(parameter.0))
        .is_some_and(|variable| variable.section == VariableSection::InOut)
}

/// Makes literals 0, FALSE or empty.
pub(super) fn literals_to_zero(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::Zero);
}

/// Makes literals 1 or one character long.
pub(super) fn literals_to_one(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::One);
}

/// Halves literals.
pub(super) fn halve_literals(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::Half);
}

/// Takes a tenth off literals, and makes texts repetitions of one character.
pub(super) fn trim_literals(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::Tenth);
}

/// Makes literals the power of two below, because many limits are powers of two.
pub(super) fn literals_to_powers(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::Power);
}

/// Makes literals one more than the power of two below, just outside of many limits.
pub(super) fn literals_above_powers(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::AbovePower);
}

/// Makes literals one less, or one character shorter.
pub(super) fn lessen_literals(program: &mut Program, sites: &mut Sites) {
    literals(program, sites, Simplification::Less);
}

fn literals(program: &mut Program, sites: &mut Sites, step: Simplification) {
    replace(program, sites, |expression, _| {
        let ExpressionKind::Literal(value, form) = &expression.kind else {
            return None;
        };
        Some(Expression {
            ty: expression.ty.clone(),
            kind: ExpressionKind::Literal(step.of(value)?, *form),
        })
    });
}

/// Omits the prefix of integers and reals where the whole of an assignment or an initial value determines the type.
///
/// Bit strings keep it: whether they take an untyped literal depends on the dialect.
pub(super) fn drop_prefixes(program: &mut Program, sites: &mut Sites) {
    struct Prefixes<'s>(&'s mut Sites);
    impl Prefixes<'_> {
        fn whole(&mut self, expression: &mut Expression) {
            if let ExpressionKind::Literal(Value::Plain { ty, .. }, form) = &mut expression.kind
                && *form == LiteralForm::Typed
                && expression.ty == Type::Elementary(*ty)
                && (ty.is_integer() || ty.is_real())
                && self.0.here()
            {
                *form = LiteralForm::Untyped;
            }
        }
    }
    impl VisitorMut for Prefixes<'_> {
        fn statement(&mut self, statement: &mut Statement) {
            if let StatementKind::Assign(
                AssignmentTarget::Place(Place { .. }) | AssignmentTarget::Result,
                value,
            ) = &mut statement.kind
            {
                self.whole(value);
            }
            walk_statement(self, statement);
        }

        fn variable(&mut self, variable: &mut Variable) {
            if let Some(InitialValue::Expression(value)) = &mut variable.initial {
                self.whole(value);
            }
            walk_variable(self, variable);
        }
    }
    walk_program(&mut Prefixes(sites), program);
}
