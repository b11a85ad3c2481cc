//! Equality of trees: two texts that say the same have equal trees, wherever their parts stand and whatever the case of
//! their names and keywords is.
//!
//! Each node is taken apart by all its fields, so that a new field cannot be forgotten here.

use super::{
    CaseFolded, Configuration, Expression, Initializer, Literal, LiteralKind, Name, Pou, Prefixed, Statement,
    TypeSpecification, VariableBlock,
};

impl PartialEq for Name<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Name { text, span: _ } = *self;
        CaseFolded(text) == CaseFolded(other.text)
    }
}

impl PartialEq for Prefixed<'_> {
    fn eq(&self, other: &Self) -> bool {
        (self.prefix(), self.value()) == (other.prefix(), other.value())
    }
}

impl PartialEq for Literal<'_> {
    fn eq(&self, other: &Self) -> bool {
        let same_text = if self.kind == LiteralKind::Boolean {
            CaseFolded(self.text()) == CaseFolded(other.text())
        } else {
            self.text() == other.text()
        };
        self.kind == other.kind && self.prefix() == other.prefix() && same_text
    }
}

/// Compares nodes by all their fields but those behind `without`.
macro_rules! compare {
    ($($node:ident $(<$lifetime:lifetime>)? { $($field:ident),* } without $($place:ident),*;)*) => {$(
        impl PartialEq for $node $(<$lifetime>)? {
            fn eq(&self, other: &Self) -> bool {
                let $node { $($field,)* $($place: _),* } = self;
                $(*$field == other.$field)&&*
            }
        }
    )*};
}

compare! {
    Expression<'_> { kind } without span;
    Statement { kind } without span;
    TypeSpecification<'_> { kind } without span;
    Initializer<'_> { kind } without span;
    Configuration<'_> { name, globals, resources, configured } without span;
    Pou<'_> {
        kind, modifiers, name, using, extends, implements, result, blocks, body, members
    } without span, end;
    VariableBlock<'_> { kind, access, constant, retention, groups } without span;
}
