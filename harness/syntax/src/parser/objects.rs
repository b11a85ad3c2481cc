//! Object orientation: classes, interfaces, methods, properties, and the keywords before and behind the name of a POU. The words
//! are keywords only where they begin one of these, and remain names elsewhere.
//!
//! Basis: iec-61131-3: third edition, 6.6.5 to 6.6.8; codesys-pages: _cds_obj_property.

use super::state::{OpenBlock, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{Access, Modifiers, Name, Pou, PouKind, TypeSpecification, TypeSpecificationKind};
use stickler_types::Code;

impl<'s> Parser<'s, '_> {
    /// Returns whether the dialect has a feature; reports its word where it has not.
    pub(super) fn has(&mut self, feature: &str, span: Span, word: &str) -> bool {
        let has = !self.dialect.lacks(feature);
        let extension = "is an extension of the standard;";
        let standard = "is of the standard, and";
        let (code, what) = match feature {
            "property" | "var-inst" | "structure-extends" | "pointer-to-this" => {
                (Code::UnexpectedToken, extension)
            }
            "pointer"
            | "reference-to"
            | "reference-binding"
            | "short-circuit"
            | "var-stat"
            | "union"
            | "jump"
            | "assignment-expression" => (Code::SyntaxError, extension),
            "type-alias" | "type-initial-value" | "subrange" | "enumeration" | "octal-literal" => {
                (Code::SyntaxError, standard)
            }
            _ => (Code::Std2013Feature, "is of the third edition of the standard;"),
        };
        if !has {
            self.report(code, span, || {
                format!("`{word}` {what} the dialect does not have it")
            });
        }
        has
    }

    /// Reports that the dialect lacks a feature, where it does; says nothing of what stands inside something refused.
    pub(super) fn requires(&mut self, feature: &str, span: Span, word: &str) {
        self.refused = self.refused || !self.has(feature, span, word);
    }

    /// CLASS or INTERFACE begins a declaration here.
    pub(super) fn at_object(&self) -> Option<PouKind> {
        if self.kind() != TokenKind::Name || self.nth(1) != TokenKind::Name {
            None
        } else if self.at_word("CLASS") {
            Some(PouKind::Class)
        } else {
            self.at_word("INTERFACE").then_some(PouKind::Interface)
        }
    }

    /// FINAL, ABSTRACT, OVERRIDE and an access specifier, in any order.
    pub(super) fn modifiers(&mut self) -> Modifiers {
        let mut modifiers = Modifiers::default();
        while self.nth(1) == TokenKind::Name && self.modifier(&mut modifiers) {}
        modifiers
    }

    /// Moves over one modifier; says whether there was one.
    fn modifier(&mut self, modifiers: &mut Modifiers) -> bool {
        let span = self.token().span;
        let before = *modifiers;
        let flags = [
            (&mut modifiers.is_abstract, "abstract"),
            (&mut modifiers.is_final, "final"),
            (&mut modifiers.is_override, "override"),
        ];
        let flag = flags.into_iter().find(|(_, word)| self.at_word(word));
        let (is_new, feature) = match (self.access(), flag) {
            (Some(access), _) => (modifiers.access.replace(access).is_none(), "access-specifier"),
            (None, Some((flag, feature))) => (!std::mem::replace(flag, true), feature),
            (None, None) => return false,
        };
        let word = self.word();
        self.bump();
        self.requires(feature, span, word);
        let contradict =
            modifiers.is_abstract && (modifiers.is_final || modifiers.access == Some(Access::Private));
        if !is_new || contradict {
            *modifiers = before;
            self.report(Code::MemberQualifierInvalid, span, || {
                let reasons = ["stands here twice", "contradicts what stands before it"];
                format!("`{word}` {}", reasons[usize::from(is_new)])
            });
        }
        true
    }

    /// The access specifier that stands here.
    pub(super) fn access(&self) -> Option<Access> {
        let mut all = Access::ALL.into_iter();
        all.find(|access| self.at_word(access.as_str()))
    }

    /// EXTENDS or IMPLEMENTS (`word`) and the names behind it.
    pub(super) fn names_behind(&mut self, word: &str, feature: &str) -> Vec<Name<'s>> {
        let mut names = Vec::new();
        if self.nth(1) != TokenKind::Name || !self.at_word(word) {
            return names;
        }
        let start = self.bump().span;
        while let Ok(name) = self.name("a name") {
            if self.kind() != TokenKind::Dot {
                names.push(name);
            } else if let TypeSpecificationKind::Named(name) = self.qualified_type(name.span) {
                names.push(name);
            }
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        self.requires(feature, start, word);
        names
    }

    /// A method or property begins here: METHOD or PROPERTY, perhaps an access specifier before it.
    pub(super) fn at_member(&self) -> bool {
        self.kind() == TokenKind::Name
            && self.nth(1) == TokenKind::Name
            && matches!(self.blocks.last(), Some(OpenBlock::Pou | OpenBlock::Member))
            && (self.at_any_word(&["METHOD", "PROPERTY"])
                || self.access().is_some() && self.nth(2) == TokenKind::Name)
    }

    /// METHOD … END_METHOD or PROPERTY … END_PROPERTY.
    pub(super) fn member_declaration(&mut self) {
        let start = self.token().span;
        let access = self.access().filter(|_| self.nth(1) == TokenKind::Name);
        if access.is_some() && !self.at_any_word(&["METHOD", "PROPERTY"]) {
            self.bump();
        }
        let is_method = self.at_word("METHOD");
        if !is_method && !self.at_word("PROPERTY") {
            self.expected("`METHOD` or `PROPERTY`");
            return;
        }
        let keyword = self.bump().span;
        let refused = self.refused;
        let (feature, word, closer) = match is_method {
            true => ("method", "METHOD", TokenKind::EndMethod),
            false => ("property", "PROPERTY", TokenKind::EndProperty),
        };
        self.requires(feature, keyword, word);
        let mut modifiers = self.modifiers();
        modifiers.access = modifiers.access.or(access);
        let name = self.declared_name("a name");
        let result = self.eat(TokenKind::Colon).then(|| self.result_type());
        self.stray_semicolon();
        match (name, is_method) {
            (Ok(name), true) => {
                let method = self.part(PouKind::Method, start, (modifiers, name, result));
                self.members.push(method);
            }
            (Ok(name), false) => self.property(modifiers, name, result),
            (Err(_), _) => {
                self.skip_line();
                self.part_body(&mut Vec::new());
                self.close(closer);
            }
        }
        self.refused = refused;
    }

    /// GET … END_GET and SET … END_SET behind the head of a property, in either order.
    fn property(&mut self, modifiers: Modifiers, name: Name<'s>, mut ty: Option<TypeSpecification<'s>>) {
        if ty.is_none() {
            self.expected("`:` and a type");
        }
        let mut parts: [Option<Pou<'s>>; 2] = [None, None];
        while self.at_any_word(&["GET", "SET"]) {
            let setter = self.at_word("SET");
            let span = self.bump().span;
            let own = self.access().filter(|_| !self.starts_line());
            if own.is_some() {
                self.bump();
            }
            let access = own.or(modifiers.access);
            let modifiers = Modifiers { access, ..modifiers };
            let kind = if setter { PouKind::Setter } else { PouKind::Getter };
            let part = self.part(kind, span, (modifiers, name, None));
            if parts[usize::from(setter)].replace(part).is_some() {
                self.report(Code::SymbolDeclDuplicated, span, || {
                    format!("the property `{}` has this part already", name.text)
                });
            }
        }
        if parts.iter().all(Option::is_none) {
            self.expected("`GET` or `SET`");
            self.part_body(&mut Vec::new());
        }
        self.close(TokenKind::EndProperty);
        for mut part in parts.into_iter().flatten() {
            part.result = ty.take();
            self.members.push(part);
        }
    }

    /// The sections and the statements of a method or of a part of a property, and the keyword that closes it.
    fn part(
        &mut self,
        kind: PouKind,
        start: Span,
        (modifiers, name, result): (Modifiers, Name<'s>, Option<TypeSpecification<'s>>),
    ) -> Pou<'s> {
        let mut blocks = Vec::new();
        self.blocks.push(OpenBlock::Member);
        while self.at_section() {
            blocks.extend(self.variable_block());
            self.stray_semicolon();
        }
        self.blocks.pop();
        let late = std::mem::take(&mut self.late_sections);
        let body = self.part_body(&mut blocks);
        self.late_sections = late;
        let end = self.token().span;
        self.close(kind.closer());
        let has_no_body = modifiers.is_abstract || self.in_interface;
        if let (Some(first), true) = (body.first(), has_no_body) {
            self.report(Code::SyntaxError, first.span, || {
                "a member that is ABSTRACT or of an interface has no statements".to_owned()
            });
        }
        Pou {
            kind,
            modifiers,
            name,
            using: Vec::new(),
            extends: Vec::new(),
            implements: Vec::new(),
            result,
            blocks,
            body,
            members: Vec::new(),
            span: start.to(self.previous_span()),
            end,
        }
    }

    /// The statements of a part; a section between them, which is wrong there, goes to the others.
    fn part_body(&mut self, blocks: &mut Vec<crate::tree::VariableBlock<'s>>) -> Vec<crate::tree::Statement> {
        let body = self.block(OpenBlock::Member);
        blocks.append(&mut self.late_sections);
        body
    }

    /// `THIS^` or `SUPER^`, which is one name, with the place of both.
    pub(super) fn own_instance(&mut self) -> Option<Name<'s>> {
        let text = if self.at_word("THIS") { "THIS^" } else { "SUPER^" };
        if self.nth(1) != TokenKind::Caret || !self.at_any_word(&["THIS", "SUPER"]) {
            return None;
        }
        let span = self.token().span;
        self.bump();
        let span = span.to(self.token().span);
        let refused = self.refused;
        self.requires("pointer-to-this", span, text);
        self.refused = refused;
        Some(Name { text, span })
    }
}
