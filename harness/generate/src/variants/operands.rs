//! Operands in reverse order; operands and literals in variables and constants; literals written with their types.

use super::walk::{FreeNames, each_pou, expressions, lists, variable};
use crate::model::visit_mut::operands;
use crate::model::{
    AssignmentTarget, BinaryOperator, Expression, ExpressionKind, InitialValue, LiteralForm, Place, Pou,
    Program, Statement, Variable, VariableId, VariableSection,
};
use crate::random::Random;
use std::mem;

/// Returns the operator that gives the same result with exchanged operands, if there is one.
///
/// Basis: iec-61131-3: Table 71; for reals IEC 60559, by which addition and multiplication commute. An expression has no
/// side effects, so the order of evaluation does not show.
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

/// Exchanges the operands of some operators. Returns the number of changes.
pub(super) fn swap(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    each_pou(program, |pou| {
        expressions(&mut pou.body, &mut |expression| {
            if let ExpressionKind::Binary(operator, left, right) = &mut expression.kind
                && let Some(other) = mirrored(*operator)
                && !random.chance(1, 3)
            {
                *operator = other;
                mem::swap(left, right);
                count += 1;
            }
        });
    });
    count
}

/// Moves some operands of assigned values to variables of their own, which are assigned just before. Returns the number of
/// changes.
///
/// The variable has the type of the operand, so that the operation keeps its type; where the whole value is an implicit
/// conversion, its operand gets the variable. A literal stays where it is.
pub(super) fn split(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut names = FreeNames::of(program);
    let mut count = 0;
    each_pou(program, |pou| {
        let mut statements = mem::take(&mut pou.body);
        lists(&mut statements, &mut |list| {
            let mut split = Vec::with_capacity(list.len());
            for mut statement in list.drain(..) {
                if let Statement::Assign(_, value) = &mut statement {
                    for operand in operands(value) {
                        if is_worth_a_variable(operand) && !random.chance(1, 3) {
                            split.push(separate(operand, pou, &mut names));
                            count += 1;
                        }
                    }
                }
                split.push(statement);
            }
            *list = split;
        });
        pou.body = statements;
    });
    count
}

const fn is_worth_a_variable(operand: &Expression) -> bool {
    !matches!(
        operand.kind,
        ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_) | ExpressionKind::Raw(_)
    )
}

/// Creates the assignment of an operand to a new variable, and replaces the operand by the variable.
fn separate(operand: &mut Expression, pou: &mut Pou, names: &mut FreeNames) -> Statement {
    let ty = operand.ty.clone();
    let id: VariableId = pou.declare(variable(names.next("part"), ty.clone(), VariableSection::Local));
    let read = Expression::read(Place::whole(id, ty.clone()));
    let value = mem::replace(operand, read);
    Statement::Assign(AssignmentTarget::Place(Place::whole(id, ty)), value)
}

/// Moves the values of some literals and enumerated values to variables that are never assigned: in VAR, so that a compiler
/// does not know them, or in VAR CONSTANT, so that it knows them in another way. Returns the number of changes.
///
/// The variable has the type of the literal, so that every operation keeps its type.
pub(super) fn hoist(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut names = FreeNames::of(program);
    let mut count = 0;
    each_pou(program, |pou| {
        let mut added: Vec<Variable> = Vec::new();
        let first = pou.variables.len();
        expressions(&mut pou.body, &mut |expression| {
            let is_value = matches!(
                expression.kind,
                ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_)
            );
            if !is_value || random.chance(1, 3) {
                return;
            }
            let section = if random.chance(1, 2) {
                VariableSection::Constant
            } else {
                VariableSection::Local
            };
            let ty = expression.ty.clone();
            let hoisted = Place::whole(VariableId(first + added.len()), ty.clone());
            let value = std::mem::replace(&mut expression.kind, ExpressionKind::Read(hoisted));
            added.push(Variable {
                initial: Some(InitialValue::Expression(Expression::new(ty.clone(), value))),
                ..variable(names.next("hoisted"), ty, section)
            });
        });
        count += added.len();
        pou.variables.append(&mut added);
    });
    count
}

/// Writes some untyped literals with their type. Returns the number of changes.
pub(super) fn type_all(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    each_pou(program, |pou| {
        expressions(&mut pou.body, &mut |expression| {
            if let ExpressionKind::Literal(_, form @ LiteralForm::Untyped) = &mut expression.kind
                && !random.chance(1, 4)
            {
                *form = LiteralForm::Typed;
                count += 1;
            }
        });
    });
    count
}
