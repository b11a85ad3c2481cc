//! Generation of functions and function blocks.

use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::scope::contains_text;
use crate::model::{AssignmentTarget, Pou, Statement, Type, VariableSection};
use stickler_types::ElementaryType;

/// The maximum number of statements of a function or function block, besides those that end it.
const MAX_STATEMENTS: usize = 7;

impl ProgramBuilder<'_, '_> {
    /// Generates the functions, each of which may call earlier ones.
    pub fn functions(&mut self) {
        if !self.has(Construct::Functions) {
            return;
        }
        for number in 0..=self.random.below(3) {
            // A text result could grow from call to call, and no document states on which day dates begin.
            let result = match self.small_type() {
                Type::Elementary(ty) if ty.is_text() || ty.is_date_or_time() => {
                    Type::Elementary(ElementaryType::Int)
                }
                ty => ty,
            };
            let most = 1 + self.random.below(MAX_STATEMENTS);
            self.begin(most);
            for _ in 0..=self.random.below(3) {
                let ty = self.small_type();
                let initial = self.initial(&ty);
                self.declare_variable("in", ty, VariableSection::Input, initial);
            }
            for _ in 0..self.random.below(3) {
                let ty = self.variable_type();
                self.declare_local(ty);
            }
            let mut body = self.body(most);
            body.extend(self.result(&result));
            self.function_costs.push(self.pou.cost);
            self.program.functions.push(Pou {
                name: format!("Fun{number}"),
                result: Some(result),
                variables: std::mem::take(&mut self.pou.variables),
                body,
            });
        }
    }

    /// Generates the last statement of a function, which assigns its result.
    fn result(&mut self, ty: &Type) -> Option<Statement> {
        self.begin_statement();
        let value = self.assigned(ty, self.pou.variables.len())?;
        self.spend(1);
        Some(Statement::Assign(AssignmentTarget::Result, value))
    }

    /// Generates the function blocks, each of which may have instances of earlier ones.
    pub fn blocks(&mut self) {
        if !self.has(Construct::Blocks) {
            return;
        }
        for number in 0..=self.random.below(2) {
            let most = 2 + self.random.below(MAX_STATEMENTS);
            self.begin(most);
            for _ in 0..self.random.below(3) {
                let ty = self.small_type();
                let initial = self.initial(&ty);
                self.declare_variable("in", ty, VariableSection::Input, initial);
            }
            if self.random.chance(1, 2) {
                self.declare_in_out();
            }
            for _ in 0..=self.random.below(2) {
                let ty = self.small_type();
                let initial = self.initial(&ty);
                self.declare_variable("out", ty, VariableSection::Output, initial);
            }
            for _ in 0..=self.random.below(3) {
                let ty = self.variable_type();
                self.declare_local(ty);
            }
            if number > 0 && self.random.chance(1, 3) {
                self.declare_instance(number - 1);
            }
            let body = self.body(most);
            self.block_costs.push(self.pou.cost);
            self.program.blocks.push(Pou {
                name: format!("Block{number}"),
                result: None,
                variables: std::mem::take(&mut self.pou.variables),
                body,
            });
        }
    }

    /// Declares an in-out; never a text, because the text of the caller could grow by it.
    fn declare_in_out(&mut self) {
        let ty = self.variable_type();
        if !contains_text(&ty, &self.program) && !matches!(ty, Type::Array(_)) {
            self.declare_variable("ref", ty, VariableSection::InOut, None);
        }
    }
}
