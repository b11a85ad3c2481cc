//! Literals moved to variables and constants, or written with their types.

use super::walk::{FreeNames, each_pou, expressions, variable};
use crate::model::{
    Expression, ExpressionKind, InitialValue, LiteralForm, Place, Program, Variable, VariableId,
    VariableSection,
};
use crate::random::Random;

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
