//! Typed programs: the generator builds them, the writer spells them, the evaluator computes them, and the variants change
//! them.
//!
//! Every expression carries its type, and every implicit conversion is a node of its own ([`ExpressionKind::Widen`]), so
//! that no reader of the model needs a rule of the language to know what a program means. Architecture Invariant: nothing
//! here knows the syntax tree of the reference.

mod expression;
mod lookup;
mod program;
mod statement;
mod visitor;

pub use expression::{
    Argument, BinaryOperator, Expression, ExpressionKind, LiteralForm, Place, PlaceSelector,
    StandardFunction, UnaryOperator,
};
pub use lookup::{PathStep, instance_of, subscripts};
pub use program::{
    ArrayType, DeclaredKind, InitialValue, Pou, Program, Type, TypeDeclaration, Unit, Variable, VariableId,
    VariableSection,
};
pub use statement::{AssignmentTarget, CaseBranch, CaseLabel, ForLoop, Statement};
pub(crate) use statement::{assign, controlled, integer, whole};
pub use visitor::{visit, visit_mut};
