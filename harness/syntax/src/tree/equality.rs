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

impl PartialEq for Expression<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Expression { kind, span: _ } = self;
        *kind == other.kind
    }
}

impl PartialEq for Statement {
    fn eq(&self, other: &Self) -> bool {
        let Statement { kind, span: _ } = self;
        *kind == other.kind
    }
}

impl PartialEq for TypeSpecification<'_> {
    fn eq(&self, other: &Self) -> bool {
        let TypeSpecification { kind, span: _ } = self;
        *kind == other.kind
    }
}

impl PartialEq for Initializer<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Initializer { kind, span: _ } = self;
        *kind == other.kind
    }
}

impl PartialEq for VariableBlock<'_> {
    fn eq(&self, other: &Self) -> bool {
        let VariableBlock {
            kind,
            access,
            constant,
            retention,
            groups,
            span: _,
        } = self;
        (*kind, *access, *constant, retention.map(CaseFolded))
            == (
                other.kind,
                other.access,
                other.constant,
                other.retention.map(CaseFolded),
            )
            && *groups == other.groups
    }
}

impl PartialEq for Pou<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Pou {
            kind,
            modifiers,
            name,
            extends,
            implements,
            result,
            blocks,
            body,
            members,
            span: _,
            end: _,
        } = self;
        (kind, modifiers, name, extends, implements)
            == (
                &other.kind,
                &other.modifiers,
                &other.name,
                &other.extends,
                &other.implements,
            )
            && (result, blocks, body, members) == (&other.result, &other.blocks, &other.body, &other.members)
    }
}

impl PartialEq for Configuration<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Configuration {
            name,
            globals,
            configured,
            resources,
            span: _,
        } = self;
        (name, globals, resources, configured)
            == (&other.name, &other.globals, &other.resources, &other.configured)
    }
}
