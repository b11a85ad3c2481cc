//! Control flow: FOR unrolled, the first iteration of the other loops peeled off, and the two sides of an IF exchanged.

use super::walk::{each_pou, has_loose_exit, lists};
use crate::model::visit::bodies as bodies_of;
use crate::model::{
    Expression, ExpressionKind, LiteralForm, Program, Statement, Type, UnaryOperator, Variable, assign,
    integer,
};
use crate::random::Random;
use std::mem;
use stickler_types::Value;

/// The maximum number of iterations of an unrolled loop; longer loops stay unchanged.
const MAX_TURNS: usize = 6;
/// The maximum number of statements that unrolling adds to a program, so that nested loops do not explode.
const MAX_ADDED_STATEMENTS: usize = 400;

/// Unrolls some loops. Returns the number of changes.
pub(super) fn unroll(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    let mut spent = 0;
    each_pou(program, |pou| {
        let variables = &pou.variables;
        lists(&mut pou.body, &mut |list| {
            let mut unrolled = Vec::with_capacity(list.len());
            for statement in list.drain(..) {
                match unrolled_loop(&statement, variables) {
                    Some(statements)
                        if spent + size(&statements) <= MAX_ADDED_STATEMENTS && !random.chance(1, 4) =>
                    {
                        spent += size(&statements);
                        count += 1;
                        unrolled.extend(statements);
                    }
                    _ => unrolled.push(statement),
                }
            }
            *list = unrolled;
        });
    });
    count
}

/// Returns the statements that replace a loop: all its iterations, or the first one followed by the loop; `None` if the
/// statement cannot be unrolled, because EXIT in a copy of the body would leave another loop, or none.
fn unrolled_loop(statement: &Statement, variables: &[Variable]) -> Option<Vec<Statement>> {
    match statement {
        Statement::For(parts) if !has_loose_exit(&parts.body) => {
            let turns = turns(&parts.from, &parts.to, parts.by.as_ref())?;
            let ty = &variables.get(parts.variable.0)?.ty;
            let Type::Elementary(ty) = ty else { return None };
            let mut statements = Vec::new();
            for turn in turns {
                statements.push(assign(
                    parts.variable,
                    *ty,
                    integer(*ty, turn, LiteralForm::Typed),
                ));
                statements.extend_from_slice(&parts.body);
            }
            Some(statements)
        }
        Statement::While(condition, body) if !has_loose_exit(body) => {
            let mut inside = body.clone();
            inside.push(statement.clone());
            Some(vec![Statement::If(vec![(condition.clone(), inside)], None)])
        }
        Statement::Repeat(body, until) if !has_loose_exit(body) => {
            let mut statements = body.clone();
            statements.push(Statement::If(vec![(not(until), vec![statement.clone()])], None));
            Some(statements)
        }
        _ => None,
    }
}

/// Returns the values that a FOR variable takes; `None` if the limits are no literals or the values are too many.
fn turns(from: &Expression, to: &Expression, by: Option<&Expression>) -> Option<Vec<i128>> {
    let (mut value, to) = (literal(from)?, literal(to)?);
    let by = by.map_or(Some(1), literal)?;
    let mut turns = Vec::new();
    while by != 0 && if by > 0 { value <= to } else { value >= to } {
        if turns.len() == MAX_TURNS {
            return None;
        }
        turns.push(value);
        value += by;
    }
    Some(turns)
}

fn literal(expression: &Expression) -> Option<i128> {
    match &expression.kind {
        ExpressionKind::Literal(Value::Plain { ty, raw }, _) => Some(ty.integer_value(*raw)),
        _ => None,
    }
}

/// Creates `NOT condition`.
pub(super) fn not(condition: &Expression) -> Expression {
    Expression::unary(UnaryOperator::Not, condition.clone())
}

/// Counts statements, including those inside them.
fn size(statements: &[Statement]) -> usize {
    let inside = |statement| {
        bodies_of(statement)
            .into_iter()
            .map(|body| size(body))
            .sum::<usize>()
    };
    statements.iter().map(|statement| 1 + inside(statement)).sum()
}

/// Negates the condition of some IFs without ELSIF, and exchanges their THEN and ELSE branches. Returns the number of
/// changes.
pub(super) fn swap_branches(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    each_pou(program, |pou| {
        lists(&mut pou.body, &mut |list| {
            for statement in list {
                let Statement::If(branches, otherwise) = statement else {
                    continue;
                };
                if let [(condition, then)] = &mut branches[..]
                    && !random.chance(1, 4)
                {
                    *condition = not(condition);
                    let positive = mem::replace(then, otherwise.take().unwrap_or_default());
                    *otherwise = Some(positive);
                    count += 1;
                }
            }
        });
    });
    count
}
