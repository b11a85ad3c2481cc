//! Types of a program: elementary types, declared types and function blocks.

use super::Expression;
use stickler_types::ElementaryType;

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
