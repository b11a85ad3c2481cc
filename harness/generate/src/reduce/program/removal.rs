//! Removal of declarations, with every later reference renumbered.

use super::usage::{DeclarationUsage, instance_of};
use crate::model::visit_mut::{
    VisitorMut, walk_expression, walk_place, walk_program, walk_statement, walk_type,
};
use crate::model::{
    Argument, Expression, ExpressionKind, Place, PlaceSelector, Program, Statement, StatementKind, Type,
    Unit, VariableId,
};

/// Removes every declaration that `keep` does not keep, with the arguments of removed parameters. Nothing that stays may
/// refer to a removed declaration.
pub(super) fn keep_only(program: &mut Program, keep: &DeclarationUsage) {
    let before = program.clone();
    walk_program(
        &mut Renumber {
            keep,
            program: &before,
            unit: Unit::Main,
        },
        program,
    );
    retain(&mut program.main.variables, &keep.main);
    for (function, keep) in program.functions.iter_mut().zip(&keep.of_functions) {
        retain(&mut function.variables, keep);
    }
    for (block, keep) in program.blocks.iter_mut().zip(&keep.of_blocks) {
        retain(&mut block.variables, keep);
    }
    retain(&mut program.functions, &keep.functions);
    retain(&mut program.blocks, &keep.blocks);
    retain(&mut program.types, &keep.types);
}

fn retain<T>(list: &mut Vec<T>, keep: &[bool]) {
    let mut keep = keep.iter();
    list.retain(|_| keep.next().copied().unwrap_or(true));
}

/// Returns the new index of an element of a list of which only some elements are kept.
fn renumbered(index: usize, keep: &[bool]) -> usize {
    keep.iter().take(index).filter(|kept| **kept).count()
}

struct Renumber<'p> {
    keep: &'p DeclarationUsage,
    /// The program before the removal.
    program: &'p Program,
    unit: Unit,
}

impl Renumber<'_> {
    fn renumber(&self, unit: Unit, variable: &mut VariableId) {
        variable.0 = renumbered(variable.0, self.keep.variables(unit));
    }

    fn parameters(&self, unit: Unit, arguments: &mut Vec<Argument>) {
        let keep = self.keep.variables(unit);
        arguments.retain_mut(|argument| {
            let kept = keep.get(argument.parameter.0).copied().unwrap_or(true);
            argument.parameter.0 = renumbered(argument.parameter.0, keep);
            kept
        });
    }
}

impl VisitorMut for Renumber<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statement(&mut self, statement: &mut Statement) {
        match &mut statement.kind {
            StatementKind::For { variable, .. } => self.renumber(self.unit, variable),
            StatementKind::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                if let Some(block) = instance_of(self.program, self.unit, *instance) {
                    self.parameters(Unit::Block(block), inputs);
                    for (output, _) in outputs {
                        self.renumber(Unit::Block(block), output);
                    }
                }
                self.renumber(self.unit, instance);
            }
            _ => {}
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Call(function, arguments) = &mut expression.kind {
            self.parameters(Unit::Function(*function), arguments);
            *function = renumbered(*function, &self.keep.functions);
        }
        walk_expression(self, expression);
    }

    fn place(&mut self, place: &mut Place) {
        if let Some(PlaceSelector::Output(output)) = place.path.first_mut()
            && let Some(block) = instance_of(self.program, self.unit, place.variable)
        {
            self.renumber(Unit::Block(block), output);
        }
        self.renumber(self.unit, &mut place.variable);
        walk_place(self, place);
    }

    fn ty(&mut self, ty: &mut Type) {
        match ty {
            Type::Declared(index) => *index = renumbered(*index, &self.keep.types),
            Type::Block(index) => *index = renumbered(*index, &self.keep.blocks),
            Type::Elementary(_) | Type::Array(_) => {}
        }
        walk_type(self, ty);
    }
}
