//! The parts of a program that variants change: bodies, lists of statements, expressions, and free names.

use crate::model::visit_mut::{self, VisitorMut, walk_expression, walk_statements};
use crate::model::{
    DeclaredKind, Expression, Program, Statement, Type, Unit, Variable, VariableId, VariableSection, visit,
};
use std::collections::HashSet;

/// The variables and statements of a function, a function block or the main program.
pub(super) struct Body<'p> {
    pub variables: &'p mut Vec<Variable>,
    pub statements: &'p mut Vec<Statement>,
}

impl Body<'_> {
    /// Adds a variable after all others.
    pub fn add(&mut self, variable: Variable) -> VariableId {
        self.variables.push(variable);
        VariableId(self.variables.len() - 1)
    }
}

/// Calls a function with each body of a program.
pub(super) fn each_body(program: &mut Program, mut visit: impl FnMut(Body<'_>)) {
    for unit in Unit::all(program) {
        if let Some((variables, statements)) = unit.parts_mut(program) {
            visit(Body {
                variables,
                statements,
            });
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
        program.functions.iter().for_each(|function| take(&function.name));
        program.blocks.iter().for_each(|block| take(&block.name));
        for unit in Unit::all(program) {
            unit.variables(program)
                .iter()
                .for_each(|variable| take(&variable.name));
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
