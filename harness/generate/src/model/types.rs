//! The types of a program: elementary ones, those it declares, and function blocks.

use super::Expression;
use stickler_types::ElementaryType;

/// The type of a variable or an expression.
#[derive(Clone, PartialEq, Debug)]
pub enum Type {
    /// An elementary data type; texts have their default length.
    Elementary(ElementaryType),
    /// `ARRAY[low..high, …] OF element`, written where the variable is declared.
    Array(Box<ArrayType>),
    /// A type of [`super::Program::types`], by its place there.
    Declared(usize),
    /// A function block of [`super::Program::blocks`], by its place there; only variables of one.
    Block(usize),
}

/// An array type.
#[derive(Clone, PartialEq, Debug)]
pub struct ArrayType {
    /// The limits of each dimension, both inclusive; at least one, none empty.
    pub dimensions: Vec<(i64, i64)>,
    /// The type of an element; never a function block.
    pub element: Type,
}

/// `name : …;` in TYPE … END_TYPE.
#[derive(Clone, PartialEq, Debug)]
pub struct TypeDeclaration {
    /// Its name, unique in the program.
    pub name: String,
    /// What it stands for.
    pub kind: DeclaredKind,
}

/// The forms of a declared type.
#[derive(Clone, PartialEq, Debug)]
pub enum DeclaredKind {
    /// `STRUCT … END_STRUCT`: names, types and the initial values of the fields.
    Structure(Vec<(String, Type, Option<Expression>)>),
    /// `(RED, GREEN, …)`: the names of the values, unique in the program; the first is the default.
    Enumeration(Vec<String>),
    /// Another name for a type that is no declared one.
    Alias(Type),
}
