//! The whole of a text, and the names of its expressions.

use super::{Declaration, Expression};

/// The name of an expression in [`SourceUnit::expressions`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ExpressionId(pub u32);

/// A whole source text.
#[derive(PartialEq, Debug, Default)]
pub struct SourceUnit<'s> {
    /// Declarations in the order of the text.
    pub declarations: Vec<Declaration<'s>>,
    /// Every expression of the unit; an expression's operands stand before it.
    pub expressions: Vec<Expression<'s>>,
}
