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
            constant,
            retention,
            groups,
            span: _,
        } = self;
        (*kind, *constant, retention.map(CaseFolded))
            == (other.kind, other.constant, other.retention.map(CaseFolded))
            && *groups == other.groups
    }
}

impl PartialEq for Pou<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Pou {
            kind,
            name,
            result,
            blocks,
            body,
            span: _,
            end: _,
        } = self;
        (kind, name, result, blocks, body)
            == (
                &other.kind,
                &other.name,
                &other.result,
                &other.blocks,
                &other.body,
            )
    }
}

impl PartialEq for Configuration<'_> {
    fn eq(&self, other: &Self) -> bool {
        let Configuration {
            name,
            globals,
            resources,
            span: _,
        } = self;
        (name, globals, resources) == (&other.name, &other.globals, &other.resources)
    }
}

#[cfg(test)]
mod tests {
    use super::super::SourceUnit;
    use crate::parse;
    use stickler_types::{Dialect, DialectName};

    fn tree(text: &str) -> SourceUnit<'_> {
        let (unit, diagnostics) = parse(text, Dialect::of(DialectName::IRONPLC_ED3));
        assert_eq!(diagnostics, [], "{text}");
        unit
    }

    #[test]
    fn spelling_and_places_do_not_matter() {
        let one = tree(
            "TYPE Color : (Red); END_TYPE PROGRAM p VAR RETAIN b : INT := int#5; END_VAR x := a.%X3 + TRUE; END_PROGRAM",
        );
        let other = tree(
            "type COLOR : (red); end_type (* c *) program P var retain B : int := INT#5; end_var
             X:=A.3+true ; end_program",
        );
        assert_eq!(one, other);
    }

    #[test]
    fn everything_else_does() {
        let all = [
            "x := a + b;",
            "x := a - b;",
            "x := b + a;",
            "x := (a + b);",
            "x := a.3;",
            "x := a.4;",
            "x := c#a;",
            "x := c#b;",
            "x := 'a';",
            "x := 'A';",
            "x := 16#a;",
            "x := 16#A;",
            "x := INT#1;",
            "x := DINT#1;",
            "x := f(a, b);",
            "x := f(a := b);",
            "x := f(a => b);",
            "x := f(NOT a => b);",
            "IF a THEN b(); END_IF;",
            "IF a THEN ; ELSE b(); END_IF;",
            "FOR x := 1 TO 2 DO EXIT; END_FOR;",
            "FOR x := 1 TO 2 BY 1 DO EXIT; END_FOR;",
            "FOR x := 1 TO 2 DO END_FOR; EXIT;",
            "CASE x OF 1, 2: END_CASE;",
            "CASE x OF 1..2: END_CASE;",
            "VAR a : INT; END_VAR",
            "VAR a : DINT; END_VAR",
            "VAR a : INT := 0; END_VAR",
            "VAR a, b : INT; END_VAR",
            "VAR RETAIN a : INT; END_VAR",
            "VAR CONSTANT a : INT := 0; END_VAR",
            "VAR_INPUT a : INT; END_VAR",
            "VAR a : ARRAY[0..1] OF INT; END_VAR",
            "VAR a : ARRAY[0..2] OF INT; END_VAR",
        ];
        let texts = all.map(|inner| format!("PROGRAM p {inner} END_PROGRAM"));
        let trees: Vec<_> = texts.iter().map(|text| tree(text)).collect();
        for (index, first) in trees.iter().enumerate() {
            assert_eq!(
                trees.iter().position(|tree| tree == first),
                Some(index),
                "{}",
                all[index]
            );
        }
    }
}
