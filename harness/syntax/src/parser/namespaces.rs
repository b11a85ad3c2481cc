//! Namespaces: NAMESPACE … END_NAMESPACE, USING, and names that a namespace or a library qualifies. The words are keywords only where
//! they begin one of these, and remain names elsewhere.
//!
//! Basis: iec-61131-3: third edition, 6.9.

use super::state::{MAX_NESTING, Parser};
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{Declaration, ExpressionId, ExpressionKind, Name, Prefixed};

impl<'s> Parser<'s, '_> {
    /// Returns whether NAMESPACE, END_NAMESPACE or USING begins a declaration here.
    pub(super) fn at_namespace(&self) -> bool {
        self.kind() == TokenKind::Name
            && (self.nth(1) == TokenKind::Name && self.at_any_word(&["NAMESPACE", "USING"])
                || self.at_word("END_NAMESPACE"))
    }

    /// `NAMESPACE a.b`, `END_NAMESPACE`, or `USING a.b, c;`.
    pub(super) fn namespace(&mut self, declarations: &mut Vec<Declaration<'s>>) {
        let keyword = Name {
            text: self.word(),
            span: self.token().span,
        };
        if keyword.is("END_NAMESPACE") {
            if self.namespaces.pop().is_some() {
                declarations.push(Declaration::EndNamespace(keyword));
            } else {
                self.expected("a declaration (no NAMESPACE is open)");
            }
            self.bump();
            self.eat(TokenKind::Semicolon);
            return;
        }
        self.bump();
        (self.refused, self.open) = (false, 0);
        self.requires("namespace", keyword.span, keyword.text);
        if keyword.is("USING") {
            let mut names = Vec::new();
            self.using(&mut names);
            declarations.extend(names.into_iter().map(Declaration::Using));
            return;
        }
        if self.at_word("INTERNAL") && self.nth(1) == TokenKind::Name {
            let span = self.bump().span;
            self.unsupported(span, "namespaces that are INTERNAL");
        }
        let Some(name) = self.qualified_name() else {
            return;
        };
        let parts = name.text.split('.').count();
        if self.namespaces.iter().sum::<usize>() + parts > MAX_NESTING {
            self.too_deep();
            return;
        }
        self.namespaces.push(parts);
        declarations.push(Declaration::Namespace(name));
    }

    /// The names behind USING, up to a semicolon.
    fn using(&mut self, names: &mut Vec<Name<'s>>) {
        loop {
            names.extend(self.qualified_name());
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        if !self.eat(TokenKind::Semicolon) {
            self.missing("`;`");
        }
    }

    /// USING behind the name or the result of a POU, as often as it stands there.
    pub(super) fn using_in_head(&mut self, names: &mut Vec<Name<'s>>) {
        while self.at_word("USING") && self.nth(1) == TokenKind::Name {
            let word = self.bump().span;
            self.requires("namespace", word, "USING");
            self.using(names);
        }
    }

    /// A name, perhaps with those of namespaces or a library in front of it.
    fn qualified_name(&mut self) -> Option<Name<'s>> {
        let first = self.name("a name").ok()?;
        self.qualified_by(first.span)
    }

    /// `COLOR#RED` behind the names of namespaces.
    pub(super) fn qualified_value(&mut self, base: ExpressionId) -> ExpressionId {
        let span = self.span_of(base).to(self.bump().span);
        let text = span.text(self.text);
        let has = self.has("namespace", span, text);
        let kind = match has && self.is_joined(span) {
            true => ExpressionKind::EnumeratedValue(Prefixed::new(text, span.start)),
            false => ExpressionKind::Error,
        };
        self.push(kind, span)
    }

    /// A name of which the first part stands at `start` and has been read.
    pub(super) fn qualified_by(&mut self, start: Span) -> Option<Name<'s>> {
        while self.kind() == TokenKind::Dot && self.nth(1) == TokenKind::Name {
            self.bump();
            self.bump();
        }
        let span = start.to(self.previous_span());
        let text = span.text(self.text);
        self.is_joined(span).then_some(Name { text, span })
    }

    /// Returns whether nothing stands between the parts of a qualified name; reports it otherwise.
    fn is_joined(&mut self, span: Span) -> bool {
        let is_part = |byte: u8| matches!(byte, b'.' | b'_' | b'#') || byte.is_ascii_alphanumeric();
        let is_joined = span.text(self.text).bytes().all(is_part);
        if !is_joined {
            self.unsupported(
                span,
                "qualified names with blanks or comments between their parts",
            );
        }
        is_joined
    }
}
