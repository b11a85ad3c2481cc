//! Whole programs: types, functions, function blocks and the main program.

use super::{Expression, Statement, Type, TypeDeclaration};
use stickler_types::{DialectName, words};

/// A program of one dialect, in the order of its text: types, functions, function blocks, `PROGRAM main`.
///
/// A declaration uses only earlier ones, so nothing is recursive.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// The dialect whose rules the program keeps.
    pub dialect: DialectName,
    /// The declared types (TYPE … END_TYPE).
    pub types: Vec<TypeDeclaration>,
    /// The functions; each calls only earlier ones.
    pub functions: Vec<Pou>,
    /// The function blocks; each has instances only of earlier ones.
    pub blocks: Vec<Pou>,
    /// The main program, `PROGRAM main`.
    pub main: Pou,
}

impl Program {
    /// Creates a program without declarations and statements.
    #[must_use]
    pub fn empty(dialect: DialectName) -> Program {
        Program {
            dialect,
            types: Vec::new(),
            functions: Vec::new(),
            blocks: Vec::new(),
            main: Pou {
                name: "main".to_owned(),
                ..Pou::default()
            },
        }
    }
}

/// A program organization unit (POU): a function, a function block, or the main program.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Pou {
    /// The name, unique in the program.
    pub name: String,
    /// The type of the result of a function, whose value starts as the default of that type; `None` for any other unit.
    pub result: Option<Type>,
    /// The variables. In a function the inputs come first, in the order of a positional call; those of a function block keep
    /// their values between calls; those of main are all [`VariableSection::Local`].
    pub variables: Vec<Variable>,
    /// The statements that a call, or one scan, executes. A function assigns its result by
    /// [`super::AssignmentTarget::Result`].
    pub body: Vec<Statement>,
}

/// A variable of a POU, by its index in the list of variables.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct VariableId(pub usize);

/// A variable.
#[derive(Clone, PartialEq, Debug)]
pub struct Variable {
    /// The name, unique in the POU, and different from the names of all POUs, types and enumerated values.
    pub name: String,
    /// The type of the variable.
    pub ty: Type,
    /// The section that declares the variable.
    pub section: VariableSection,
    /// The initial value; `None` for the default of the type.
    pub initial: Option<InitialValue>,
}

words! {
    /// The section in which a variable is declared.
    VariableSection {
        /// The section VAR.
        Local = "VAR",
        /// The section VAR CONSTANT: the variable has an initial value, and is never assigned.
        Constant = "VAR CONSTANT",
        /// The section VAR_INPUT.
        Input = "VAR_INPUT",
        /// The section VAR_OUTPUT.
        Output = "VAR_OUTPUT",
        /// The section VAR_IN_OUT, in function blocks only.
        InOut = "VAR_IN_OUT",
    }
}

/// The initial value of a variable.
#[derive(Clone, PartialEq, Debug)]
pub enum InitialValue {
    /// A value of the type of the variable: a literal, perhaps widened, or an operation on literals.
    Expression(Expression),
    /// `[…]`: as many values as the array has elements, the last subscript varying fastest.
    Array(Vec<Expression>),
    /// `(field := …)`: indices of fields and their values.
    Structure(Vec<(usize, Expression)>),
}
