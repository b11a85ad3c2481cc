//! Passes that forget variables and functions: every read becomes a literal, and every write is dropped.

use super::expressions::is_in_out;
use super::plain::plainest;
use super::statements::drop_exits;
use super::usage::{DeclarationUsage, instance_of};
use crate::model::visit_mut::{VisitorMut, walk_expression, walk_program, walk_statement, walk_statements};
use crate::model::{
    AssignmentTarget, Expression, ExpressionKind, Program, Statement, StatementKind, Unit, VariableId,
};
use std::mem;
use stickler_reduce::Sites;

/// Forgets functions: replaces calls by the plainest value of the result type.
pub(super) fn forget_functions(program: &mut Program, sites: &mut Sites) {
    let forgotten: Vec<bool> = program.functions.iter().map(|_| sites.here()).collect();
    let mut all = Sites::all();
    super::expressions::replace(program, &mut all, |expression, program| match &expression.kind {
        ExpressionKind::Call(function, _) if forgotten.get(*function) == Some(&true) => {
            plainest(program, &expression.ty)
        }
        _ => None,
    });
}

/// Forgets variables: drops statements that write one or pass it to a function block, and replaces its values by the
/// plainest of their type. A statement that reads the whole of a variable that is not elementary is dropped too.
pub(super) fn forget_variables(program: &mut Program, sites: &mut Sites) {
    let mut forgotten = DeclarationUsage::of(program);
    let DeclarationUsage {
        main,
        of_functions,
        of_blocks,
        ..
    } = &mut forgotten;
    let lists = [main].into_iter().chain(of_functions).chain(of_blocks);
    for used in lists.flatten().filter(|used| **used) {
        *used = sites.here();
    }
    let before = program.clone();
    walk_program(
        &mut Forget {
            forgotten,
            before: &before,
            unit: Unit::Main,
            impossible: false,
        },
        program,
    );
}

struct Forget<'p> {
    /// The variables to forget, in the form of a usage.
    forgotten: DeclarationUsage,
    before: &'p Program,
    unit: Unit,
    /// Whether something in the current statement cannot be replaced.
    impossible: bool,
}

impl Forget<'_> {
    fn forgets(&self, variable: VariableId) -> bool {
        self.forgotten.variables(self.unit).get(variable.0) == Some(&true)
    }

    fn forgets_target(&self, target: &AssignmentTarget) -> bool {
        match target {
            AssignmentTarget::Place(place) | AssignmentTarget::Bit(place, _) => self.forgets(place.variable),
            AssignmentTarget::Result => false,
        }
    }

    /// Returns whether a statement is dropped for what it writes, before its parts are visited.
    fn writes(&self, statement: &Statement) -> bool {
        match &statement.kind {
            StatementKind::Assign(target, _) => self.forgets_target(target),
            StatementKind::Invoke { instance, inputs, .. } => {
                let (before, unit) = (self.before, self.unit);
                let handed = inputs
                    .iter()
                    .filter(|input| is_in_out(before, unit, *instance, input.parameter))
                    .any(|input| matches!(&input.value.kind, ExpressionKind::Read(place) if self.forgets(place.variable)));
                handed || self.forgets(*instance) || instance_of(before, unit, *instance).is_none()
            }
            _ => false,
        }
    }
}

impl VisitorMut for Forget<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statements(&mut self, statements: &mut Vec<Statement>) {
        for mut statement in mem::take(statements) {
            if self.writes(&statement) {
                continue;
            }
            if let StatementKind::For { variable, body, .. } = &mut statement.kind
                && self.forgets(*variable)
            {
                walk_statements(self, body);
                drop_exits(body);
                statements.append(body);
                continue;
            }
            let outside = mem::take(&mut self.impossible);
            self.statement(&mut statement);
            if !mem::replace(&mut self.impossible, outside) {
                statements.push(statement);
            }
        }
    }

    fn statement(&mut self, statement: &mut Statement) {
        if let StatementKind::Invoke { outputs, .. } = &mut statement.kind {
            outputs.retain(|(_, place)| !self.forgets(place.variable));
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Read(place) | ExpressionKind::Bit(place, _) = &expression.kind
            && self.forgets(place.variable)
        {
            match plainest(self.before, &expression.ty) {
                Some(plain) => *expression = plain,
                None => self.impossible = true,
            }
            return;
        }
        walk_expression(self, expression);
    }
}
