//! The units of a program that have variables and statements of their own.

use super::{Program, Variable};

/// Which program organization unit something stands in.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unit {
    /// `PROGRAM main`.
    Main,
    /// A function, by its place.
    Function(usize),
    /// A function block, by its place.
    Block(usize),
    /// None: the initial values of fields in TYPE … END_TYPE.
    Types,
}

impl Unit {
    /// Every unit that has variables.
    #[must_use]
    pub fn all(program: &Program) -> Vec<Unit> {
        let functions = (0..program.functions.len()).map(Unit::Function);
        let blocks = (0..program.blocks.len()).map(Unit::Block);
        functions.chain(blocks).chain([Unit::Main]).collect()
    }

    /// Its variables; none where the program has no such unit.
    #[must_use]
    pub fn variables(self, program: &Program) -> &[Variable] {
        match self {
            Unit::Types => &[],
            Unit::Function(number) => program
                .functions
                .get(number)
                .map_or(&[], |function| &function.variables),
            Unit::Block(number) => program.blocks.get(number).map_or(&[], |block| &block.variables),
            Unit::Main => &program.main.variables,
        }
    }

    /// The same, to declare more in.
    #[must_use]
    pub fn variables_mut(self, program: &mut Program) -> Option<&mut Vec<Variable>> {
        match self {
            Unit::Types => None,
            Unit::Function(number) => program
                .functions
                .get_mut(number)
                .map(|function| &mut function.variables),
            Unit::Block(number) => program.blocks.get_mut(number).map(|block| &mut block.variables),
            Unit::Main => Some(&mut program.main.variables),
        }
    }
}
