//! Passes that drop statements, or replace them by the statements inside them.

use super::usage::variable_type;
use crate::model::visit::bodies;
use crate::model::visit_mut::{self, VisitorMut, walk_program, walk_statement, walk_statements};
use crate::model::{
    AssignmentTarget, Expression, InitialValue, Program, Statement, StatementKind, Type, Unit, VariableId,
};
use std::mem;
use stickler_reduce::Sites;

/// Drops statements from the body of `PROGRAM main`, with the statements inside them.
pub(super) fn drop_of_main(program: &mut Program, sites: &mut Sites) {
    program.main.body.retain(|_| !sites.here());
}

/// Drops statements in any list.
pub(super) fn drop_anywhere(program: &mut Program, sites: &mut Sites) {
    struct Drop<'s>(&'s mut Sites);
    impl VisitorMut for Drop<'_> {
        fn statements(&mut self, statements: &mut Vec<Statement>) {
            statements.retain(|_| !self.0.here());
            walk_statements(self, statements);
        }
    }
    walk_program(&mut Drop(sites), program);
}

/// Replaces a statement by one of its bodies: IF and CASE by each branch in turn, a loop by its body.
pub(super) fn splice(program: &mut Program, sites: &mut Sites) {
    struct Splice<'s>(&'s mut Sites);
    impl VisitorMut for Splice<'_> {
        fn statements(&mut self, statements: &mut Vec<Statement>) {
            for statement in mem::take(statements) {
                let body = bodies(&statement).into_iter().find(|_| self.0.here()).cloned();
                match body {
                    Some(mut body) => {
                        if statement.is_loop() {
                            drop_exits(&mut body);
                        }
                        statements.append(&mut body);
                    }
                    None => statements.push(statement),
                }
            }
            walk_statements(self, statements);
        }
    }
    walk_program(&mut Splice(sites), program);
}

/// Replaces a call of a function block that writes an output to a place by an assignment of the initial value of that output.
///
/// `FOR i := 1 TO 0 DO block(out => x); END_FOR;` then shows the same defect of loops without the block.
pub(super) fn calls_to_assignments(program: &mut Program, sites: &mut Sites) {
    struct BlockCalls<'p> {
        program: &'p Program,
        unit: Unit,
        sites: &'p mut Sites,
    }
    impl VisitorMut for BlockCalls<'_> {
        fn enter(&mut self, unit: Unit) {
            self.unit = unit;
        }

        fn statement(&mut self, statement: &mut Statement) {
            if let StatementKind::Invoke {
                instance, outputs, ..
            } = &statement.kind
            {
                let written = outputs.iter().find_map(|(output, place)| {
                    let value = initial_output(self.program, self.unit, *instance, *output)?;
                    self.sites.here().then(|| (place.clone(), value))
                });
                if let Some((place, value)) = written {
                    statement.kind = StatementKind::Assign(AssignmentTarget::Place(place), value);
                }
            }
            walk_statement(self, statement);
        }
    }
    let before = program.clone();
    let mut calls = BlockCalls {
        program: &before,
        unit: Unit::Main,
        sites,
    };
    walk_program(&mut calls, program);
}

/// Returns the initial value of an output of an instance, where it is a single value.
fn initial_output(
    program: &Program,
    unit: Unit,
    instance: VariableId,
    output: VariableId,
) -> Option<Expression> {
    let Type::Block(block) = variable_type(program, unit, instance)? else {
        return None;
    };
    match &program.blocks.get(*block)?.variables.get(output.0)?.initial {
        Some(InitialValue::Expression(value)) => Some(value.clone()),
        _ => None,
    }
}

/// Drops each EXIT that would leave the loop whose body these statements were.
pub(super) fn drop_exits(statements: &mut Vec<Statement>) {
    statements.retain(|statement| !matches!(statement.kind, StatementKind::Exit));
    for statement in statements.iter_mut().filter(|statement| !statement.is_loop()) {
        visit_mut::bodies(statement).into_iter().for_each(drop_exits);
    }
}

/// Drops branches of IF and CASE, and ELSE; of an IF the first branch stays, unless another can take its place.
pub(super) fn drop_branches(program: &mut Program, sites: &mut Sites) {
    struct Branches<'s>(&'s mut Sites);
    impl VisitorMut for Branches<'_> {
        fn statement(&mut self, statement: &mut Statement) {
            match &mut statement.kind {
                StatementKind::If(branches, otherwise) => {
                    retain_one(branches, self.0);
                    drop_else(otherwise, self.0);
                }
                StatementKind::Case(_, branches, otherwise) => {
                    retain_one(branches, self.0);
                    drop_else(otherwise, self.0);
                    for branch in branches {
                        retain_one(&mut branch.labels, self.0);
                    }
                }
                StatementKind::For { by, .. } if by.is_some() && self.0.here() => *by = None,
                StatementKind::Invoke { outputs, .. } => outputs.retain(|_| !self.0.here()),
                _ => {}
            }
            walk_statement(self, statement);
        }
    }
    walk_program(&mut Branches(sites), program);
}

/// Drops the chosen elements of a list, but never the last one.
fn retain_one<T>(list: &mut Vec<T>, sites: &mut Sites) {
    let mut left = list.len();
    if left > 1 {
        list.retain(|_| {
            let goes = sites.here() && left > 1;
            left -= usize::from(goes);
            !goes
        });
    }
}

fn drop_else(otherwise: &mut Option<Vec<Statement>>, sites: &mut Sites) {
    if otherwise.is_some() && sites.here() {
        *otherwise = None;
    }
}
