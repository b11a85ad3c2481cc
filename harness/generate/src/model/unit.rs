//! The program organization units of a program of the model.

use super::{Program, Statement, Variable};

/// A program organization unit, by its place in the program.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Unit {
    /// `PROGRAM main`.
    Main,
    /// A function, by its index in [`Program::functions`].
    Function(usize),
    /// A function block, by its index in [`Program::blocks`].
    Block(usize),
    /// No unit: the initial values of fields in TYPE … END_TYPE.
    Types,
}

impl Unit {
    /// Returns every unit that has variables and statements, in the order of the text.
    #[must_use]
    pub fn all(program: &Program) -> Vec<Unit> {
        let functions = (0..program.functions.len()).map(Unit::Function);
        let blocks = (0..program.blocks.len()).map(Unit::Block);
        functions.chain(blocks).chain([Unit::Main]).collect()
    }

    /// Returns the variables and the statements of the unit; `None` if the program has no such unit.
    fn parts(self, program: &Program) -> Option<(&Vec<Variable>, &Vec<Statement>)> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => program
                .functions
                .get(index)
                .map(|one| (&one.variables, &one.body)),
            Unit::Block(index) => program.blocks.get(index).map(|one| (&one.variables, &one.body)),
            Unit::Main => Some((&program.main.variables, &program.main.body)),
        }
    }

    /// Returns the variables of the unit; an empty slice if the program has no such unit.
    #[must_use]
    pub fn variables(self, program: &Program) -> &[Variable] {
        self.parts(program).map_or(&[], |(variables, _)| variables)
    }

    /// Returns the statements of the unit; an empty slice if the program has no such unit.
    #[must_use]
    pub fn body(self, program: &Program) -> &[Statement] {
        self.parts(program).map_or(&[], |(_, body)| body)
    }

    /// Returns the variables and the statements of the unit for changes; `None` if the program has no such unit.
    #[must_use]
    pub fn parts_mut(self, program: &mut Program) -> Option<(&mut Vec<Variable>, &mut Vec<Statement>)> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => {
                let function = program.functions.get_mut(index)?;
                Some((&mut function.variables, &mut function.body))
            }
            Unit::Block(index) => {
                let block = program.blocks.get_mut(index)?;
                Some((&mut block.variables, &mut block.body))
            }
            Unit::Main => Some((&mut program.main.variables, &mut program.main.body)),
        }
    }

    /// Returns the variables of the unit for changes; `None` if the program has no such unit.
    #[must_use]
    pub fn variables_mut(self, program: &mut Program) -> Option<&mut Vec<Variable>> {
        self.parts_mut(program).map(|(variables, _)| variables)
    }
}
