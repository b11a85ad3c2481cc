//! Passes that move values: of conditions to variables of their own, of variables to their readers.

use crate::model::visit::{self, Visitor};
use crate::model::visit_mut::{self, VisitorMut};
use crate::model::{
    AssignmentTarget, Expression, ExpressionKind, LiteralForm, Place, Program, Statement, StatementKind,
    Type, Unit, Variable, VariableId, VariableSection,
};
use std::collections::BTreeMap;
use std::mem;
use stickler_reduce::Sites;
use stickler_types::{ElementaryType, Value};

/// Replaces a statement of `PROGRAM main` that tests a condition or selects by a value: by an assignment of that value, or
/// of a part of it, to a new variable.
///
/// `IF f(1) = 0 THEN x := 1; END_IF;` becomes `y := f(1);`, which shows the defect as well if it is in `f`.
pub(super) fn hoist(program: &mut Program, sites: &mut Sites) {
    let mut body = mem::take(&mut program.main.body);
    let mut hoist = Hoist {
        sites,
        variables: &mut program.main.variables,
    };
    hoist.statements(&mut body);
    program.main.body = body;
}

struct Hoist<'p> {
    sites: &'p mut Sites,
    variables: &'p mut Vec<Variable>,
}

impl Hoist<'_> {
    /// Creates `new := value;` and declares the new variable.
    fn assignment(&mut self, value: Expression) -> Statement {
        let place = Place::whole(VariableId(self.variables.len()), value.ty.clone());
        let name = (0..=self.variables.len())
            .map(|number| format!("value{number}"))
            .find(|name| self.variables.iter().all(|variable| variable.name != *name));
        self.variables.push(Variable {
            name: name.unwrap_or_default(),
            ty: value.ty.clone(),
            section: VariableSection::Local,
            initial: None,
        });
        Statement {
            kind: StatementKind::Assign(AssignmentTarget::Place(place), value),
        }
    }
}

impl VisitorMut for Hoist<'_> {
    fn statements(&mut self, statements: &mut Vec<Statement>) {
        for statement in &mut *statements {
            let chosen = values(statement).into_iter().find(|_| self.sites.here());
            if let Some(value) = chosen {
                *statement = self.assignment(value);
            }
        }
        visit_mut::walk_statements(self, statements);
    }
}

/// Returns the values that a statement evaluates first, and their computed parts.
fn values(statement: &Statement) -> Vec<Expression> {
    let heads: Vec<&Expression> = match &statement.kind {
        StatementKind::If(branches, _) => branches.iter().map(|(condition, _)| condition).collect(),
        StatementKind::Case(selector, ..) => vec![selector],
        StatementKind::While(condition, _) | StatementKind::Repeat(_, condition) => vec![condition],
        _ => Vec::new(),
    };
    let mut parts = ComputedParts(Vec::new());
    for head in heads {
        parts.expression(head);
    }
    parts.0
}

struct ComputedParts(Vec<Expression>);

impl Visitor for ComputedParts {
    fn expression(&mut self, expression: &Expression) {
        let computed = !matches!(
            expression.kind,
            ExpressionKind::Literal(..)
                | ExpressionKind::Enumerated(_)
                | ExpressionKind::Read(_)
                | ExpressionKind::Raw(_)
        );
        if computed && matches!(expression.ty, Type::Elementary(_)) {
            self.0.push(expression.clone());
        }
        visit::walk_expression(self, expression);
    }
}

/// Replaces reads of variables that are assigned once by the assigned value.
pub(super) fn propagate(program: &mut Program, sites: &mut Sites) {
    let mut assigned = Assigned {
        values: BTreeMap::new(),
        unit: Unit::Main,
    };
    visit::walk_program(&mut assigned, program);
    let chosen = assigned
        .values
        .into_iter()
        .filter_map(|(place, value)| Some((place, value?)))
        .filter(|_| sites.here())
        .collect();
    let unit = Unit::Main;
    visit_mut::walk_program(&mut Propagate { chosen, unit }, program);
}

/// The value that each variable is assigned as a whole; `None` if it is assigned more than once, or with a value that reads
/// it.
struct Assigned {
    values: BTreeMap<(Unit, VariableId), Option<Expression>>,
    unit: Unit,
}

impl Visitor for Assigned {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statement(&mut self, statement: &Statement) {
        if let Some((variable, value)) = whole_assignment(statement) {
            let mut reads = Reads(variable, false);
            reads.expression(value);
            let once = (!reads.1).then(|| value.clone());
            self.values
                .entry((self.unit, variable))
                .and_modify(|known| *known = None)
                .or_insert(once);
        }
        visit::walk_statement(self, statement);
    }
}

fn whole_assignment(statement: &Statement) -> Option<(VariableId, &Expression)> {
    match &statement.kind {
        StatementKind::Assign(AssignmentTarget::Place(place), value) if place.path.is_empty() => {
            Some((place.variable, value))
        }
        _ => None,
    }
}

/// Finds out whether a variable is read.
struct Reads(VariableId, bool);

impl Visitor for Reads {
    fn place(&mut self, place: &Place) {
        self.1 |= place.variable == self.0;
        visit::walk_place(self, place);
    }
}

struct Propagate {
    chosen: BTreeMap<(Unit, VariableId), Expression>,
    unit: Unit,
}

impl VisitorMut for Propagate {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statements(&mut self, statements: &mut Vec<Statement>) {
        statements.retain(|statement| {
            whole_assignment(statement)
                .is_none_or(|(variable, _)| !self.chosen.contains_key(&(self.unit, variable)))
        });
        visit_mut::walk_statements(self, statements);
    }

    fn expression(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Read(place) = &expression.kind
            && place.path.is_empty()
            && let Some(value) = self.chosen.get(&(self.unit, place.variable))
        {
            *expression = value.clone();
            return;
        }
        visit_mut::walk_expression(self, expression);
    }
}

/// Ends each REPEAT after its first iteration. Code that is not executed may contain any condition; once it is executed, it
/// should terminate.
pub(super) fn end_repeats(program: &mut Program, sites: &mut Sites) {
    struct LoopVisitor<'s>(&'s mut Sites);
    impl VisitorMut for LoopVisitor<'_> {
        fn statement(&mut self, statement: &mut Statement) {
            if let StatementKind::Repeat(_, until) = &mut statement.kind
                && !is_true(until)
                && self.0.here()
            {
                let yes = Value::plain(ElementaryType::Bool, 1);
                until.kind = ExpressionKind::Literal(yes, LiteralForm::Untyped);
            }
            visit_mut::walk_statement(self, statement);
        }
    }
    visit_mut::walk_program(&mut LoopVisitor(sites), program);
}

/// Returns whether an expression is TRUE.
pub(super) fn is_true(expression: &Expression) -> bool {
    matches!(
        &expression.kind,
        ExpressionKind::Literal(Value::Plain { raw: 1, .. }, _)
    )
}
