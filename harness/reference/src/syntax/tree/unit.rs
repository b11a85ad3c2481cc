//! The whole of a text, and what every part of its tree is made of.

use super::{Declaration, Expression};
use crate::source::Span;

/// The name of an expression in [`SourceUnit::expressions`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ExpressionId(pub u32);

/// A whole source text.
#[derive(Debug, Default)]
pub struct SourceUnit<'s> {
    /// Declarations in the order of the text.
    pub declarations: Vec<Declaration<'s>>,
    /// Every expression of the unit; an expression's operands stand before it.
    pub expressions: Vec<Expression<'s>>,
}

/// An identifier as written; identifiers compare without regard to ASCII case (6.1.2 of the standard).
#[derive(Clone, Copy, Debug)]
pub struct Name<'s> {
    /// The identifier as written.
    pub text: &'s str,
    /// Where it stands.
    pub span: Span,
}
