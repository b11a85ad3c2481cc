//! A whole program: its types, functions, function blocks and main program.

use super::{Expression, Statement, Type, TypeDeclaration};
use stickler_types::DialectName;

/// A program of one dialect, in the order in which it is written: types, functions, function blocks, `PROGRAM main`.
///
/// A declaration uses only what stands before it, so nothing is recursive.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// Whose rules it keeps.
    pub dialect: DialectName,
    /// TYPE … END_TYPE.
    pub types: Vec<TypeDeclaration>,
    /// The functions; one calls only those before it.
    pub functions: Vec<Function>,
    /// The function blocks; one has instances only of those before it.
    pub blocks: Vec<FunctionBlock>,
    /// `PROGRAM main`.
    pub main: MainProgram,
}

/// A function.
#[derive(Clone, PartialEq, Debug)]
pub struct Function {
    /// Its name, unique in the program.
    pub name: String,
    /// The type of its result, which starts as that type's default.
    pub result: Type,
    /// Inputs first, in the order of a positional call, then the others.
    pub variables: Vec<Variable>,
    /// Its statements; the result is [`super::Target::Result`].
    pub body: Vec<Statement>,
}

/// A function block.
#[derive(Clone, PartialEq, Debug)]
pub struct FunctionBlock {
    /// Its name, unique in the program.
    pub name: String,
    /// Its variables, which keep their values between calls.
    pub variables: Vec<Variable>,
    /// Its statements.
    pub body: Vec<Statement>,
}

/// `PROGRAM main`.
#[derive(Clone, PartialEq, Debug)]
pub struct MainProgram {
    /// Its variables, all [`VariableSection::Local`].
    pub variables: Vec<Variable>,
    /// Its statements.
    pub body: Vec<Statement>,
}

/// Which variable of its POU: its place in the list of variables.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct VariableId(pub usize);

/// A variable.
#[derive(Clone, PartialEq, Debug)]
pub struct Variable {
    /// Its name, unique in its POU, and no name of a POU, a type or an enumerated value.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Where it is declared.
    pub section: VariableSection,
    /// Its initial value; without one the type's default.
    pub initial: Option<Initializer>,
}

/// The section in which a variable is declared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableSection {
    /// VAR.
    Local,
    /// VAR CONSTANT: it has an initial value, and is assigned nowhere.
    Constant,
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT, of function blocks only.
    InOut,
}

/// An initial value.
#[derive(Clone, PartialEq, Debug)]
pub enum Initializer {
    /// A value of the variable's own type: a literal, perhaps widened, or an operation on such.
    Expression(Expression),
    /// `[…]`: as many values as the array has elements, the last subscript quickest.
    Array(Vec<Expression>),
    /// `(field := …)`: places of fields, and their values.
    Structure(Vec<(usize, Expression)>),
}
