//! Statements.

use super::expressions::{Wanted, whole};
use super::maker::Maker;
use crate::model::{Statement, StatementKind, Target, Type, VariableId};

/// How deeply statements are nested at most.
const DEEPEST: usize = 3;

impl Maker<'_, '_> {
    /// At least one statement, at this depth of nesting.
    pub fn statements(&mut self, depth: usize) -> Vec<Statement> {
        let mut made = vec![self.statement(depth)];
        let most = if depth == 0 { self.statements_left } else { 4 };
        while made.len() < most && self.statements_left > 0 && self.random.chance(3, 4) {
            made.push(self.statement(depth));
        }
        made
    }

    fn statement(&mut self, depth: usize) -> Statement {
        self.statements_left = self.statements_left.saturating_sub(1);
        let kind = if depth < DEEPEST && self.statements_left > 0 && self.random.chance(1, 4) {
            let condition = self.condition(2);
            let body = self.statements(depth + 1);
            let otherwise = self.random.chance(1, 2).then(|| self.statements(depth + 1));
            StatementKind::If(vec![(condition, body)], otherwise)
        } else {
            self.assignment()
        };
        Statement { kind }
    }

    fn assignment(&mut self) -> StatementKind {
        let variable = VariableId(self.random.below(self.variables.len()));
        let ty = self.variables[variable.0].ty.clone();
        let value = match ty {
            Type::Elementary(ty) => self.value(ty, Wanted::Fitting, 3),
            _ => unreachable!("only elementary variables are made"),
        };
        StatementKind::Assign(Target::Place(whole(variable, ty)), value)
    }
}
