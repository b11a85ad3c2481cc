//! The syntax tree: what the parser builds, the checker reads and the renderer writes back.
//!
//! Expressions live in one arena and are named by [`ExpressionId`], so that a chain of a million operators
//! can be built, walked along its left spine and dropped without recursion. Everything else nests no deeper
//! than the parser's nesting limit.

mod configuration;
mod declarations;
mod equality;
mod expressions;
mod literals;
mod name;
mod statements;
mod unit;

pub use configuration::{Configuration, ProgramInstance, Resource, Task};
pub use declarations::{
    ANY_ARGUMENTS, Access, ArrayElement, Declaration, Edge, Initializer, InitializerKind, Modifiers,
    PointerForm, Pou, PouKind, TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableBlock,
    VariableGroup, VariableKind,
};
pub use expressions::{Argument, BinaryOperator, Expression, ExpressionKind, UnaryOperator};
pub use literals::{Literal, LiteralKind, Prefixed};
pub use name::{CaseFolded, Name, own_instance};
pub use statements::{CaseBranch, CaseLabel, Statement, StatementKind};
pub use unit::{ExpressionId, SourceUnit};
