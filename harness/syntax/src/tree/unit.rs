//! The whole of a text, and the names of its expressions.

use super::{Configuration, Declaration, Expression, Pou, TypeDeclaration};

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

impl<'s> SourceUnit<'s> {
    /// Returns an expression by its id; `None` where it is one of another tree.
    pub fn expression(&self, id: ExpressionId) -> Option<&Expression<'s>> {
        self.expressions.get(id.0 as usize)
    }

    /// Returns the program organization units, in the order of the text.
    pub fn pous(&self) -> impl DoubleEndedIterator<Item = &Pou<'s>> {
        self.declarations
            .iter()
            .filter_map(|declaration| match declaration {
                Declaration::Pou(pou) => Some(pou),
                _ => None,
            })
    }

    /// Returns the configurations, in the order of the text.
    pub fn configurations(&self) -> impl Iterator<Item = &Configuration<'s>> {
        self.declarations.iter().filter_map(|one| match one {
            Declaration::Configuration(configuration) => Some(configuration),
            _ => None,
        })
    }

    /// Returns the declarations of types, in the order of the text.
    pub fn types(&self) -> impl Iterator<Item = &TypeDeclaration<'s>> {
        let types = self.declarations.iter().filter_map(|one| match one {
            Declaration::Types(types) => Some(types),
            _ => None,
        });
        types.flatten()
    }
}
