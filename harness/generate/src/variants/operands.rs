//! Operands: the other way round, or in variables of their own.

use super::walk::{Body, FreeNames, bodies, expressions, lists, variable};
use crate::model::visit_mut::operands;
use crate::model::{
    AssignmentTarget, BinaryOperator, Expression, ExpressionKind, Place, Program, Statement, StatementKind,
    VariableId, VariableSection,
};
use crate::random::Random;
use std::mem;

/// The operator that gives the same with its operands the other way round, if there is one.
///
/// Basis: iec-61131-3: Table 71; for reals IEC 60559, by which addition and multiplication commute. An expression has no side
/// effects, so that no order of evaluation shows.
const fn mirrored(operator: BinaryOperator) -> Option<BinaryOperator> {
    use BinaryOperator as B;
    match operator {
        B::Add | B::Multiply | B::And | B::Or | B::Xor | B::Equal | B::NotEqual => Some(operator),
        B::Less => Some(B::Greater),
        B::LessOrEqual => Some(B::GreaterOrEqual),
        B::Greater => Some(B::Less),
        B::GreaterOrEqual => Some(B::LessOrEqual),
        B::Subtract | B::Divide | B::Modulo => None,
    }
}

/// Exchanges the operands of some operators. Says how many.
pub(super) fn swap(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    for body in bodies(program) {
        expressions(body.statements, &mut |expression| {
            if let ExpressionKind::Binary(operator, left, right) = &mut expression.kind
                && let Some(other) = mirrored(*operator)
                && !random.chance(1, 3)
            {
                *operator = other;
                mem::swap(left, right);
                count += 1;
            }
        });
    }
    count
}

/// Gives some operands of assigned values variables of their own, which are assigned just before. Says how many.
///
/// The variable has the operand's type, so that the operation keeps its own; where the whole value is an implicit conversion,
/// what is converted gets the variable. A literal is left where it is.
pub(super) fn split(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut names = FreeNames::of(program);
    let mut count = 0;
    for mut body in bodies(program) {
        let mut statements = mem::take(body.statements);
        lists(&mut statements, &mut |list| {
            let mut split = Vec::with_capacity(list.len());
            for mut statement in list.drain(..) {
                if let StatementKind::Assign(_, value) = &mut statement.kind {
                    for operand in operands(value) {
                        if is_worth_a_variable(operand) && !random.chance(1, 3) {
                            split.push(separate(operand, &mut body, &mut names));
                            count += 1;
                        }
                    }
                }
                split.push(statement);
            }
            *list = split;
        });
        *body.statements = statements;
    }
    count
}

const fn is_worth_a_variable(operand: &Expression) -> bool {
    !matches!(
        operand.kind,
        ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_) | ExpressionKind::Raw(_)
    )
}

/// The assignment of an operand to a new variable, which stands in its place from now on.
fn separate(operand: &mut Expression, body: &mut Body<'_>, names: &mut FreeNames) -> Statement {
    let ty = operand.ty.clone();
    let id: VariableId = body.add(variable(names.next("part"), ty.clone(), VariableSection::Local));
    let read = Expression {
        ty: ty.clone(),
        kind: ExpressionKind::Read(Place::whole(id, ty.clone())),
    };
    let value = mem::replace(operand, read);
    Statement {
        kind: StatementKind::Assign(AssignmentTarget::Place(Place::whole(id, ty)), value),
    }
}
