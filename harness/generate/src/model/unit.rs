//! The program organization units of a program of the model.

use super::{Pou, Program, Statement, Variable};

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

    /// Returns the unit; `None` if the program has no such unit.
    #[must_use]
    pub fn pou(self, program: &Program) -> Option<&Pou> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => program.functions.get(index),
            Unit::Block(index) => program.blocks.get(index),
            Unit::Main => Some(&program.main),
        }
    }

    /// Returns the unit for changes; `None` if the program has no such unit.
    #[must_use]
    pub fn pou_mut(self, program: &mut Program) -> Option<&mut Pou> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => program.functions.get_mut(index),
            Unit::Block(index) => program.blocks.get_mut(index),
            Unit::Main => Some(&mut program.main),
        }
    }

    /// Returns the variables of the unit; an empty slice if the program has no such unit.
    #[must_use]
    pub fn variables(self, program: &Program) -> &[Variable] {
        self.pou(program).map_or(&[], |pou| &pou.variables)
    }

    /// Returns the statements of the unit; an empty slice if the program has no such unit.
    #[must_use]
    pub fn body(self, program: &Program) -> &[Statement] {
        self.pou(program).map_or(&[], |pou| &pou.body)
    }
}
