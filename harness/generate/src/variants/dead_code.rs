//! Dead code: statements that are never reached or change nothing, and variables that are never read.

use super::walk::{FreeNames, each_pou, has_loose_exit, lists, variable};
use crate::model::{
    Expression, LiteralForm, Program, Statement, Type, Variable, VariableId, VariableSection, assign,
    controlled, integer, whole,
};
use crate::random::Random;
use stickler_types::ElementaryType;

/// Inserts dead code beside some statements. Returns the number of insertions.
pub(super) fn insert(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut names = FreeNames::of(program);
    let mut count = 0;
    // Every dialect has one of them.
    let unread = match program.dialect.rules().may_name(ElementaryType::Lword) {
        true => ElementaryType::Lword,
        false => ElementaryType::Dword,
    };
    each_pou(program, |pou| {
        pou.declare(variable(
            names.next("unread"),
            Type::Elementary(unread),
            VariableSection::Local,
        ));
        let settled = settled_variables(&pou.variables, &pou.body);
        lists(&mut pou.body, &mut |list| {
            let mut longer = Vec::with_capacity(list.len());
            for statement in list.drain(..) {
                if !random.chance(1, 2)
                    && let Some(dead) = dead(&statement, &settled, random)
                {
                    longer.push(dead);
                    count += 1;
                }
                longer.push(statement);
            }
            *list = longer;
        });
        pou.body.push(Statement::Return);
        // Statements after the last RETURN are never reached.
        let first = pou.body.first().cloned();
        pou.body
            .extend(first.filter(|first| !has_loose_exit(std::slice::from_ref(first))));
        count += 1;
    });
    count
}

/// Returns the variables that may be assigned to themselves anywhere: elementary ones in VAR that control no loop.
fn settled_variables(variables: &[Variable], statements: &[Statement]) -> Vec<(VariableId, ElementaryType)> {
    let counting = controlled(statements);
    let settled = variables
        .iter()
        .enumerate()
        .filter_map(|(index, variable)| match variable.ty {
            Type::Elementary(ty) if variable.section == VariableSection::Local => {
                Some((VariableId(index), ty))
            }
            _ => None,
        });
    settled.filter(|(id, _)| !counting.contains(id)).collect()
}

/// Creates a dead statement: a copy of `beside` that is never reached, or an assignment of a variable to itself.
fn dead(
    beside: &Statement,
    settled: &[(VariableId, ElementaryType)],
    random: &mut Random<'_, '_>,
) -> Option<Statement> {
    let copy = vec![beside.clone()];
    let is_simple = !has_loose_exit(&copy);
    match random.below(5) {
        0 => random
            .pick(settled)
            .map(|&(id, ty)| assign(id, ty, whole(id, ty))),
        1 if is_simple => Some(Statement::While(truth(false), copy)),
        2 => Some(Statement::If(
            vec![(truth(true), Vec::new()), (truth(true), copy)],
            None,
        )),
        3 => Some(Statement::If(vec![(truth(true), Vec::new())], Some(copy))),
        _ => Some(Statement::If(vec![(truth(false), copy)], None)),
    }
}

fn truth(value: bool) -> Expression {
    integer(ElementaryType::Bool, i64::from(value), LiteralForm::Untyped)
}
