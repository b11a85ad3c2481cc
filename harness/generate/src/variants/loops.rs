//! Loops: FOR turn after turn, and the first turn of the others in front of them.

use super::walk::{bodies, has_loose_exit, lists};
use crate::model::visit::bodies as bodies_of;
use crate::model::{
    AssignmentTarget, Expression, ExpressionKind, LiteralForm, Place, Program, Statement, StatementKind,
    Type, UnaryOperator, Variable, VariableId,
};
use crate::random::Random;
use stickler_types::{ElementaryType, Value};

/// A loop of more turns is left as it is.
const MAX_TURNS: usize = 6;
/// So many statements a program may get by this, so that loops in loops do not make it endless.
const MAX_ADDED_STATEMENTS: usize = 400;

/// Unrolls some loops. Says how many.
pub(super) fn unroll(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    let mut spent = 0;
    for body in bodies(program) {
        let variables = &*body.variables;
        lists(body.statements, &mut |list| {
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
    }
    count
}

/// A statement that is a loop, without it, or with one turn less; `None` where it is none that can be unrolled: EXIT in a copy of
/// the body would leave another loop, or none.
fn unrolled_loop(statement: &Statement, variables: &[Variable]) -> Option<Vec<Statement>> {
    match &statement.kind {
        StatementKind::For {
            variable,
            from,
            to,
            by,
            body,
        } if !has_loose_exit(body) => {
            let turns = turns(from, to, by.as_ref())?;
            let ty = &variables.get(variable.0)?.ty;
            let Type::Elementary(ty) = ty else { return None };
            let mut statements = Vec::new();
            for turn in turns {
                statements.push(assigned(*variable, *ty, turn));
                statements.extend_from_slice(body);
            }
            Some(statements)
        }
        StatementKind::While(condition, body) if !has_loose_exit(body) => {
            let mut inside = body.clone();
            inside.push(statement.clone());
            Some(vec![of_kind(StatementKind::If(
                vec![(condition.clone(), inside)],
                None,
            ))])
        }
        StatementKind::Repeat(body, until) if !has_loose_exit(body) => {
            let mut statements = body.clone();
            statements.push(of_kind(StatementKind::If(
                vec![(not(until), vec![statement.clone()])],
                None,
            )));
            Some(statements)
        }
        _ => None,
    }
}

/// The values that a FOR variable takes, where they can be read off the program and are few.
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

/// `variable := value;`
fn assigned(variable: VariableId, ty: ElementaryType, value: i128) -> Statement {
    let literal = Expression {
        ty: Type::Elementary(ty),
        kind: ExpressionKind::Literal(Value::plain(ty, ty.wrap(value)), LiteralForm::Typed),
    };
    of_kind(StatementKind::Assign(
        AssignmentTarget::Place(Place::whole(variable, Type::Elementary(ty))),
        literal,
    ))
}

/// `NOT condition`
pub(super) fn not(condition: &Expression) -> Expression {
    Expression {
        ty: condition.ty.clone(),
        kind: ExpressionKind::Unary(UnaryOperator::Not, Box::new(condition.clone())),
    }
}

fn of_kind(kind: StatementKind) -> Statement {
    Statement { kind }
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
