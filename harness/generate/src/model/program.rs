//! Whole programs: types, functions, function blocks and the main program, their variables, and the types of these.

use super::{Expression, Statement};
use stickler_types::{DialectName, ElementaryType, words};

/// A program of one dialect, in the order of its text: types, functions, function blocks, `PROGRAM main`.
///
/// A declaration uses only earlier ones, so nothing is recursive.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// The dialect whose rules the program keeps.
    pub dialect: DialectName,
    /// The declared types (TYPE … END_TYPE).
    pub types: Vec<TypeDeclaration>,
    /// The functions, and behind them the methods of function blocks; each calls only earlier functions.
    pub functions: Vec<Pou>,
    /// The function blocks, the standard ones that are used among them; each has instances only of earlier ones.
    pub blocks: Vec<Pou>,
    /// The main program, `PROGRAM main`.
    pub main: Pou,
}

impl Program {
    /// Returns the words for a type of references and for the reference to a variable that the dialect has; `None` where it has neither
    /// references nor pointers.
    pub fn reference_words(&self) -> Option<(&'static str, &'static str)> {
        let lacks = |features: [&str; 3]| features.iter().any(|key| self.dialect.rules().lacks(key));
        match lacks(["reference", "ref", "dereference"]) {
            false => Some(("REF_TO", "REF")),
            true if !lacks(["pointer", "adr", "pointer"]) => Some(("POINTER TO", "ADR")),
            true => None,
        }
    }

    /// Creates a program without declarations and statements.
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
    /// The function block, by its index, of which a function is a method; it uses none of the variables there.
    pub owner: Option<usize>,
    /// Whether it is a standard function block, of which the program has no text.
    pub standard: bool,
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

/// The type of a variable or an expression.
#[derive(Clone, PartialEq, Debug)]
pub enum Type {
    /// An elementary data type; texts have the default length.
    Elementary(ElementaryType),
    /// `ARRAY[low..high, …] OF element`, written where the variable is declared.
    Array(Box<ArrayType>),
    /// A type declared in [`super::Program::types`], by its index.
    Declared(usize),
    /// A function block of [`super::Program::blocks`], by its index; only variables have such a type.
    Block(usize),
    /// `REF_TO INT`, or `POINTER TO INT` where the dialect has no references; only variables of main have such a type.
    Reference(Box<Type>),
}

/// An array type.
#[derive(Clone, PartialEq, Debug)]
pub struct ArrayType {
    /// The lower and upper limit of each dimension, both inclusive; there is at least one dimension, and none is empty.
    pub dimensions: Vec<(i64, i64)>,
    /// The type of the elements; never a function block.
    pub element: Type,
}

/// A declaration `name : …;` in TYPE … END_TYPE.
#[derive(Clone, PartialEq, Debug)]
pub struct TypeDeclaration {
    /// The name of the type, unique in the program.
    pub name: String,
    /// The definition of the type.
    pub kind: DeclaredKind,
}

/// The definition of a declared type.
#[derive(Clone, PartialEq, Debug)]
pub enum DeclaredKind {
    /// `STRUCT … END_STRUCT`: names, types and initial values of the fields.
    Structure(Vec<(String, Type, Option<Expression>)>),
    /// `(RED, GREEN, …)`: the names of the values, unique in the program; the first value is the default.
    Enumeration(Vec<String>),
    /// Another name for a type that is not declared itself.
    Alias(Type),
}

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
    /// Returns every unit of which the text has variables and statements, the methods before all function blocks.
    pub fn all(program: &Program) -> Vec<Unit> {
        let functions = (0..program.functions.len()).map(Unit::Function);
        let blocks = program.blocks.iter().enumerate();
        let blocks = blocks
            .filter(|(_, block)| !block.standard)
            .map(|(index, _)| Unit::Block(index));
        functions.chain(blocks).chain([Unit::Main]).collect()
    }

    /// Returns the unit; `None` if the program has no such unit.
    pub fn pou(self, program: &Program) -> Option<&Pou> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => program.functions.get(index),
            Unit::Block(index) => program.blocks.get(index),
            Unit::Main => Some(&program.main),
        }
    }

    /// Returns the unit for changes; `None` if the program has no such unit.
    pub fn pou_mut(self, program: &mut Program) -> Option<&mut Pou> {
        match self {
            Unit::Types => None,
            Unit::Function(index) => program.functions.get_mut(index),
            Unit::Block(index) => program.blocks.get_mut(index),
            Unit::Main => Some(&mut program.main),
        }
    }

    /// Returns the variables of the unit; an empty slice if the program has no such unit.
    pub fn variables(self, program: &Program) -> &[Variable] {
        self.pou(program).map_or(&[], |pou| &pou.variables)
    }
}
