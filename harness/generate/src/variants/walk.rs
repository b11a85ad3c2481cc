//! The parts of a program that variants change: bodies, lists of statements, expressions, and free names.

use crate::model::visit_mut::{self, VisitorMut, walk_expression, walk_statements};
use crate::model::{
    DeclaredKind, Expression, Pou, Program, Statement, Type, Unit, Variable, VariableSection, visit,
};
use std::collections::HashSet;

/// Calls a function with each unit of a program that has statements.
pub(super) fn each_pou(program: &mut Program, mut visit: impl FnMut(&mut Pou)) {
    for unit in Unit::all(program) {
        if let Some(pou) = unit.pou_mut(program) {
            visit(pou);
        }
    }
}

/// Source of names that are not used in a program.
pub(super) struct FreeNames {
    taken: HashSet<String>,
    next: usize,
}

impl FreeNames {
    pub fn of(program: &Program) -> FreeNames {
        let mut taken = HashSet::new();
        let mut take = |name: &str| {
            taken.insert(name.to_ascii_lowercase());
        };
        for declaration in &program.types {
            take(&declaration.name);
            if let DeclaredKind::Enumeration(names) = &declaration.kind {
                names.iter().for_each(|name| take(name));
            }
        }
        for pou in Unit::all(program)
            .into_iter()
            .filter_map(|unit| unit.pou(program))
        {
            take(&pou.name);
            pou.variables.iter().for_each(|variable| take(&variable.name));
        }
        FreeNames { taken, next: 0 }
    }

    /// Returns an unused name that begins with `word`.
    pub fn next(&mut self, word: &str) -> String {
        loop {
            self.next += 1;
            let name = format!("{word}_{}", self.next);
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

/// Creates a variable without an initial value.
pub(super) fn variable(name: String, ty: Type, section: VariableSection) -> Variable {
    Variable {
        name,
        ty,
        section,
        initial: None,
    }
}

/// Visits every expression of some statements, operands before the whole. CASE labels and BY values are skipped: only
/// literals may stand there.
pub(super) fn expressions(statements: &mut [Statement], visit: &mut dyn FnMut(&mut Expression)) {
    walk_statements(&mut Expressions(visit), statements);
}

struct Expressions<'v>(&'v mut dyn FnMut(&mut Expression));

impl VisitorMut for Expressions<'_> {
    fn expression(&mut self, expression: &mut Expression) {
        walk_expression(self, expression);
        (self.0)(expression);
    }

    fn literal(&mut self, _: &mut Expression) {}
}

/// Visits every list of statements in a list, inner lists before outer ones, and the list itself last.
pub(super) fn lists(statements: &mut Vec<Statement>, visit: &mut dyn FnMut(&mut Vec<Statement>)) {
    for list in statements.iter_mut().flat_map(visit_mut::bodies) {
        lists(list, visit);
    }
    visit(statements);
}

/// Returns whether an EXIT in these statements would leave an enclosing loop.
pub(super) fn has_loose_exit(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| {
        let mut inner = visit::bodies(statement).into_iter();
        matches!(statement, Statement::Exit) || !statement.is_loop() && inner.any(|body| has_loose_exit(body))
    })
}
