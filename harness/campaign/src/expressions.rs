//! Every expression of a program, visited once.

use stickler_generate::model::visit::{Visitor, walk_expression, walk_program};
use stickler_generate::model::{Expression, Program};

/// Calls `visit` with every expression of the program, outer ones before what stands in them.
pub(crate) fn each_expression(program: &Program, visit: &mut dyn FnMut(&Expression)) {
    walk_program(&mut Visiting(visit), program);
}

struct Visiting<'v>(&'v mut dyn FnMut(&Expression));

impl Visitor for Visiting<'_> {
    fn expression(&mut self, expression: &Expression) {
        (self.0)(expression);
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &Expression) {
        self.expression(expression);
    }
}
