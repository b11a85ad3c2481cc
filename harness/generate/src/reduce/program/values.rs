//! A pass that replaces expressions by the values that the evaluator computes.
//!
//! It cuts a program off from the computation of a value: `y := f(a[i] + b)` becomes `y := f(INT#70)`, and the statements
//! that computed `a`, `i` and `b` can go.

use super::expressions::walk_input;
use super::plain::literal_kind;
use crate::evaluate::evaluate;
use crate::model::visit_mut::{VisitorMut, walk_expression, walk_program};
use crate::model::{
    Argument, AssignmentTarget, Expression, ExpressionKind, Place, Program, Statement, StatementKind, Type,
    Unit, Variable, VariableId, VariableSection,
};
use std::mem;
use stickler_reduce::Sites;
use stickler_types::{ElementaryType, Value};

/// Replaces expressions in `PROGRAM main` by their values; in a loop by those of the last iteration.
pub(super) fn to_value(program: &mut Program, sites: &mut Sites) {
    let mut again = sites.again();
    let before = program.clone();
    let mut probed = program.clone();
    let mut probes = Vec::new();
    ValueReplacer::over(&mut probed, &before, sites, Work::Probe(&mut probes));
    if probes.is_empty() {
        return;
    }

    probed.main.variables.extend(probes);
    // The probes come after everything observed of the program itself.
    let values = evaluate(&probed, 1)
        .map(|evaluation| evaluation.values)
        .unwrap_or_default();
    let own = before.observed().len();

    let mut values = values.into_iter().skip(own).map(|(_, value)| value);
    ValueReplacer::over(program, &before, &mut again, Work::Put(&mut values));
}

/// The treatment of the chosen expressions.
enum Work<'w> {
    /// Inserts a statement before the enclosing one that stores the value of the expression in a new variable, collected
    /// here.
    Probe(&'w mut Vec<Variable>),
    /// Replaces the expression by the next of these values.
    Put(&'w mut dyn Iterator<Item = Value>),
}

/// One of two walks over the same expressions.
struct ValueReplacer<'w> {
    before: &'w Program,
    sites: &'w mut Sites,
    work: Work<'w>,
    /// Statements to insert before the current one.
    pending: Vec<Statement>,
    unit: Unit,
}

impl<'w> ValueReplacer<'w> {
    fn over(program: &mut Program, before: &'w Program, sites: &'w mut Sites, work: Work<'w>) {
        let mut walk = ValueReplacer {
            before,
            sites,
            work,
            pending: Vec::new(),
            unit: Unit::Types,
        };
        walk_program(&mut walk, program);
    }

    fn chosen(&mut self, expression: &mut Expression, ty: ElementaryType) {
        match &mut self.work {
            Work::Probe(probes) => {
                let probe = VariableId(self.before.main.variables.len() + probes.len());
                let place = Place::whole(probe, Type::Elementary(ty));
                probes.push(Variable {
                    name: format!("probe {}", probes.len()),
                    ty: Type::Elementary(ty),
                    section: VariableSection::Local,
                    initial: None,
                });
                self.pending.push(Statement {
                    kind: StatementKind::Assign(AssignmentTarget::Place(place), expression.clone()),
                });
            }
            Work::Put(values) => {
                if let Some(value) = values.next().filter(can_be_written) {
                    expression.kind = literal_kind(value);
                }
            }
        }
    }
}

impl VisitorMut for ValueReplacer<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statements(&mut self, statements: &mut Vec<Statement>) {
        if self.unit != Unit::Main {
            return;
        }
        for mut statement in mem::take(statements) {
            let outside = mem::take(&mut self.pending);
            self.statement(&mut statement);
            statements.append(&mut self.pending);
            statements.push(statement);
            self.pending = outside;
        }
    }

    fn expression(&mut self, expression: &mut Expression) {
        match (&expression.ty, &expression.kind) {
            _ if self.unit != Unit::Main => {}
            (_, ExpressionKind::Literal(..)) => {}
            (Type::Elementary(ty), _) if self.sites.here() => {
                let ty = *ty;
                self.chosen(expression, ty);
            }
            _ => walk_expression(self, expression),
        }
    }

    fn literal(&mut self, _: &mut Expression) {}

    fn input(&mut self, instance: VariableId, argument: &mut Argument) {
        let before = self.before;
        walk_input(self, before, self.unit, instance, argument);
    }

    fn variable(&mut self, _: &mut Variable) {}
}

/// Returns whether a literal can express a value: infinities and NaN have none.
fn can_be_written(value: &Value) -> bool {
    match value {
        Value::Plain { ty, raw } if *ty == ElementaryType::Real => f32::from_bits(*raw as u32).is_finite(),
        Value::Plain { ty, raw } if *ty == ElementaryType::Lreal => f64::from_bits(*raw).is_finite(),
        _ => true,
    }
}
