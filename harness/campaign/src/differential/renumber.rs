//! The numbers by which a program refers to its parts, moved behind those of another.

use stickler_generate::model::visit_mut::{
    VisitorMut, walk_expression, walk_place, walk_statement, walk_type,
};
use stickler_generate::model::{
    Expression, ExpressionKind, Place, Program, Statement, StatementKind, Type, Unit,
};

/// The distances by which each kind of number moves.
pub(super) struct Shift {
    types: usize,
    functions: usize,
    blocks: usize,
    variables: usize,
    /// Whether only the variables of main move, while functions and blocks keep their own.
    in_main: bool,
}

impl Shift {
    /// Returns the distances that move a program behind all parts of another.
    pub(super) fn behind(program: &Program) -> Shift {
        Shift {
            types: program.types.len(),
            functions: program.functions.len(),
            blocks: program.blocks.len(),
            variables: program.main.variables.len(),
            in_main: false,
        }
    }

    fn variables(&self) -> usize {
        if self.in_main { self.variables } else { 0 }
    }
}

impl VisitorMut for Shift {
    fn enter(&mut self, unit: Unit) {
        self.in_main = unit == Unit::Main;
    }

    fn statement(&mut self, statement: &mut Statement) {
        if let StatementKind::For { variable, .. }
        | StatementKind::Invoke {
            instance: variable, ..
        } = &mut statement.kind
        {
            variable.0 += self.variables();
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Call(function, _) = &mut expression.kind {
            *function += self.functions;
        }
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &mut Expression) {
        self.expression(expression);
    }

    fn place(&mut self, place: &mut Place) {
        place.variable.0 += self.variables();
        walk_place(self, place);
    }

    fn ty(&mut self, ty: &mut Type) {
        match ty {
            Type::Declared(index) => *index += self.types,
            Type::Block(index) => *index += self.blocks,
            Type::Elementary(_) | Type::Array(_) => {}
        }
        walk_type(self, ty);
    }
}
