//! A typed program: what the generator makes, the writer spells, the evaluator computes, and the variants change.
//!
//! Every expression carries its type, and every implicit conversion is a node of its own ([`ExpressionKind::Widen`]), so
//! that no reader of the model needs a rule of the language to know what a program means. Architecture Invariant: nothing
//! here knows the reference's tree.

mod expression;
mod look;
mod program;
mod statement;
mod types;
mod unit;
mod visitor;

pub use expression::{
    Argument, BinaryOperator, Expression, ExpressionKind, LiteralForm, Place, Selector, StandardFunction,
    UnaryOperator,
};
pub use look::subscripts;
pub use program::{Block, Function, Initial, Main, Program, Section, Variable, VariableId};
pub use statement::{CaseBranch, CaseLabel, Statement, StatementKind, Target};
pub use types::{ArrayType, Declared, Type, TypeDeclaration};
pub use unit::Unit;
pub use visitor::{visit, visit_mut};
