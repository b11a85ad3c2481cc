//! The declarations of a program that are used.

use crate::model::visit::{Visitor, walk_expression, walk_place, walk_program, walk_statement, walk_type};
use crate::model::{
    Expression, ExpressionKind, Place, PlaceSelector, Program, Statement, StatementKind, Type, Unit,
    Variable, VariableId,
};

/// Whether each declaration of a program is used. An argument in a call is no use of its parameter.
#[derive(Clone, Debug)]
pub(super) struct DeclarationUsage {
    pub functions: Vec<bool>,
    pub blocks: Vec<bool>,
    pub types: Vec<bool>,
    pub main: Vec<bool>,
    /// The variables of each function.
    pub of_functions: Vec<Vec<bool>>,
    /// The variables of each function block.
    pub of_blocks: Vec<Vec<bool>>,
}

impl DeclarationUsage {
    /// Finds the used declarations of a program.
    pub fn of(program: &Program) -> DeclarationUsage {
        let mut gatherer = Gatherer {
            usage: DeclarationUsage::uniform(program, false),
            program,
            unit: Unit::Main,
        };
        walk_program(&mut gatherer, program);
        gatherer.usage
    }

    /// Creates a usage with the same entry for every declaration of a program.
    pub fn uniform(program: &Program, used: bool) -> DeclarationUsage {
        DeclarationUsage {
            functions: vec![used; program.functions.len()],
            blocks: vec![used; program.blocks.len()],
            types: vec![used; program.types.len()],
            main: vec![used; program.main.variables.len()],
            of_functions: (program
                .functions
                .iter()
                .map(|one| vec![used; one.variables.len()]))
            .collect(),
            of_blocks: (program.blocks.iter().map(|one| vec![used; one.variables.len()])).collect(),
        }
    }

    /// Returns the entries of the variables of a unit; an empty slice if there is no such unit.
    pub fn variables(&self, unit: Unit) -> &[bool] {
        let variables = match unit {
            Unit::Main => Some(&self.main),
            Unit::Function(index) => self.of_functions.get(index),
            Unit::Block(index) => self.of_blocks.get(index),
            Unit::Types => None,
        };
        variables.map_or(&[], Vec::as_slice)
    }

    /// Returns the entries of the variables of a unit for changes.
    pub fn variables_mut(&mut self, unit: Unit) -> Option<&mut Vec<bool>> {
        match unit {
            Unit::Main => Some(&mut self.main),
            Unit::Function(index) => self.of_functions.get_mut(index),
            Unit::Block(index) => self.of_blocks.get_mut(index),
            Unit::Types => None,
        }
    }
}

/// Returns a variable of a unit.
pub(super) fn variable_of(program: &Program, unit: Unit, variable: VariableId) -> Option<&Variable> {
    unit.variables(program).get(variable.0)
}

/// Returns the type of a variable of a unit.
pub(super) fn variable_type(program: &Program, unit: Unit, variable: VariableId) -> Option<&Type> {
    variable_of(program, unit, variable).map(|variable| &variable.ty)
}

/// Returns the function block of which a variable is an instance.
pub(super) fn instance_of(program: &Program, unit: Unit, variable: VariableId) -> Option<usize> {
    match variable_type(program, unit, variable)? {
        Type::Block(block) => Some(*block),
        _ => None,
    }
}

struct Gatherer<'p> {
    usage: DeclarationUsage,
    program: &'p Program,
    unit: Unit,
}

impl Gatherer<'_> {
    fn mark(&mut self, unit: Unit, variable: VariableId) {
        let variables = self.usage.variables_mut(unit);
        if let Some(used) = variables.and_then(|variables| variables.get_mut(variable.0)) {
            *used = true;
        }
    }

    fn mark_output(&mut self, instance: VariableId, output: VariableId) {
        if let Some(block) = instance_of(self.program, self.unit, instance) {
            self.mark(Unit::Block(block), output);
        }
    }
}

impl Visitor for Gatherer<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::For { variable, .. } => self.mark(self.unit, *variable),
            StatementKind::Invoke {
                instance, outputs, ..
            } => {
                self.mark(self.unit, *instance);
                for (output, _) in outputs {
                    self.mark_output(*instance, *output);
                }
            }
            _ => {}
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        if let ExpressionKind::Call(function, _) = &expression.kind
            && let Some(used) = self.usage.functions.get_mut(*function)
        {
            *used = true;
        }
        walk_expression(self, expression);
    }

    fn place(&mut self, place: &Place) {
        self.mark(self.unit, place.variable);
        if let Some(PlaceSelector::Output(output)) = place.path.first() {
            self.mark_output(place.variable, *output);
        }
        walk_place(self, place);
    }

    fn ty(&mut self, ty: &Type) {
        let used = match ty {
            Type::Declared(index) => self.usage.types.get_mut(*index),
            Type::Block(index) => self.usage.blocks.get_mut(*index),
            Type::Elementary(_) | Type::Array(_) => None,
        };
        if let Some(used) = used {
            *used = true;
        }
        walk_type(self, ty);
    }
}
