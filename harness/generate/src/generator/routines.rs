//! Generation of functions, function blocks and methods.

use super::builder::{ProgramBuilder, is_in};
use super::constructs::Construct;
use super::scope::contains_text;
use crate::model::{AssignmentTarget, Pou, Statement, Type, Variable, VariableSection};
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
            self.function(format!("Fun{number}"), None);
        }
    }

    /// Generates a function, or a method of a function block.
    fn function(&mut self, name: String, owner: Option<usize>) {
        // A text result could grow from call to call, and no document states on which day dates begin.
        let result = match self.small_type() {
            Type::Elementary(ty) if ty.is_text() || ty.is_date_or_time() => {
                Type::Elementary(ElementaryType::Int)
            }
            ty => ty,
        };
        let most = 1 + self.random.below(MAX_STATEMENTS);
        self.begin(most);
        let inputs = 1 + self.random.below(3);
        self.parameters("in", VariableSection::Input, inputs);
        let locals = self.random.below(3);
        self.locals(locals);
        let mut body = self.body(most);
        body.extend(self.result(&result));
        self.function_costs.push(self.pou.cost);
        let mut variables = std::mem::take(&mut self.pou.variables);
        if owner.is_some() {
            // No variable of a method hides one of its block.
            variables
                .iter_mut()
                .for_each(|variable| variable.name.insert_str(0, "m_"));
        }
        self.program.functions.push(Pou {
            name,
            result: Some(result),
            owner,
            variables,
            body,
            ..Pou::default()
        });
    }

    /// Declares so many inputs or outputs.
    fn parameters(&mut self, stem: &str, section: VariableSection, count: usize) {
        for _ in 0..count {
            let ty = self.small_type();
            let initial = self.initial(&ty);
            self.declare_variable(stem, ty, section, initial);
        }
    }

    /// Generates the last statement of a function, which assigns its result.
    fn result(&mut self, ty: &Type) -> Option<Statement> {
        self.begin_statement();
        let value = self.assigned(ty, self.pou.variables.len())?;
        self.spend(1);
        Some(Statement::Assign(AssignmentTarget::Result, value))
    }

    /// Picks the standard function blocks that the program has instances of.
    pub fn standard_blocks(&mut self) {
        if !self.has(Construct::StandardBlocks) {
            return;
        }
        for _ in 0..=self.random.below(3) {
            let (known, lacking) = (&self.program.blocks, &self.lacking);
            let is_there = |variable: &Variable| match variable.ty {
                Type::Elementary(ty) => !is_in(lacking, ty.name()),
                _ => true,
            };
            let suits = |block: &Pou| {
                let is_lacking = is_in(lacking, feature(&block.name));
                !is_lacking && block.variables.iter().all(is_there) && !known.contains(block)
            };
            if let Some(block) = self.random.pick_where(self.profile.standard_blocks(), suits) {
                self.program.blocks.push(block.clone());
                self.block_costs.push(8);
            }
        }
    }

    /// Generates the function blocks with their methods; each may have instances of earlier ones.
    pub fn blocks(&mut self) {
        if !self.has(Construct::Blocks) {
            return;
        }
        for number in 0..=self.random.below(2) {
            let most = 2 + self.random.below(MAX_STATEMENTS);
            self.begin(most);
            let inputs = self.random.below(3);
            self.parameters("in", VariableSection::Input, inputs);
            if self.random.chance(1, 2) {
                self.declare_in_out();
            }
            let outputs = 1 + self.random.below(2);
            self.parameters("out", VariableSection::Output, outputs);
            let locals = 1 + self.random.below(3);
            self.locals(locals);
            if !self.program.blocks.is_empty() && self.random.chance(1, 3) {
                let block = self.random.below(self.program.blocks.len());
                self.declare_instance(block);
            }
            let body = self.body(most);
            self.block_costs.push(self.pou.cost);
            self.program.blocks.push(Pou {
                name: format!("Block{number}"),
                variables: std::mem::take(&mut self.pou.variables),
                body,
                ..Pou::default()
            });
            if self.has(Construct::Methods) {
                let owner = self.program.blocks.len() - 1;
                for _ in 0..=self.random.below(3) {
                    self.function(format!("Met{}", self.program.functions.len()), Some(owner));
                }
            }
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

/// Returns the feature of the language that a standard function block belongs to.
fn feature(block: &str) -> &'static str {
    match block {
        "SR" | "RS" => "bistable-blocks",
        "R_TRIG" | "F_TRIG" => "edge-blocks",
        "CTU" | "CTD" | "CTUD" => "counter-blocks",
        _ => "timer-blocks",
    }
}
