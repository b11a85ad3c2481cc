//! The text that is being written, and the tree that it is written from.

use super::names::Names;
use crate::tree::{BinaryOperator, Expression, ExpressionId, ExpressionKind, SourceUnit};

/// Writes the whole of `unit`, the tree of `text`, in one spelling.
///
/// Every name that is declared in the text is written as its declaration spells it, keywords and elementary types
/// in capitals, other names and literals as they stand; comments are dropped; `.%Xn` comes back as `.n`;
/// parentheses stay where they were written. What the parser left out is missing here too, so that only a text
/// without diagnostics comes back whole. Rendering the result again changes nothing. Takes time in proportion to
/// the text.
///
/// Basis: harness/engines/README.md (`render`); ironplc-bit-access: Edition 3 Partial-Access Syntax (the renderer normalizes
/// both surface forms to `.n`).
pub fn render(unit: &SourceUnit, text: &str) -> String {
    let mut writer = Writer {
        unit,
        names: Names::new(unit),
        out: String::with_capacity(text.len() + text.len() / 4),
        indent: 0,
        dense: false,
        pou: None,
        spine: Vec::new(),
    };
    writer.source_unit();
    writer.out
}

/// The state of rendering.
pub(super) struct Writer<'u, 's> {
    pub(super) unit: &'u SourceUnit<'s>,
    pub(super) names: Names<'u, 's>,
    pub(super) out: String,
    pub(super) indent: usize,
    /// Whether the place is between brackets, where no spaces are written.
    pub(super) dense: bool,
    /// The start of the POU whose variables are in scope.
    pub(super) pou: Option<u32>,
    /// The operators of the chains that are being written, each with its right operand; shared by all, so that a chain allocates nothing.
    pub(super) spine: Vec<(BinaryOperator, ExpressionId)>,
}

impl<'u, 's> Writer<'u, 's> {
    pub(super) fn put(&mut self, text: &str) {
        self.out.push_str(text);
    }

    /// A keyword's own spelling, or another word in capitals.
    pub(super) fn capitals(&mut self, word: &str) {
        self.out
            .extend(word.chars().map(|character| character.to_ascii_uppercase()));
    }

    /// The indent of a line that begins here.
    pub(super) fn begin(&mut self) {
        for _ in 0..self.indent {
            self.out.push_str("    ");
        }
    }

    /// A whole line.
    pub(super) fn line(&mut self, text: &str) {
        self.begin();
        self.put(text);
        self.end();
    }

    /// The end of a line.
    pub(super) fn end(&mut self) {
        self.out.push('\n');
    }

    /// Runs `inner` with one more step of indent.
    pub(super) fn indented(&mut self, inner: impl FnOnce(&mut Self)) {
        self.indent += 1;
        inner(self);
        self.indent -= 1;
    }

    /// A comma, and a space unless it stands between brackets.
    pub(super) fn comma(&mut self) {
        self.put(if self.dense { "," } else { ", " });
    }

    /// Items with commas between them.
    pub(super) fn list<T>(
        &mut self,
        items: impl IntoIterator<Item = T>,
        mut write: impl FnMut(&mut Self, T),
    ) {
        for (index, item) in items.into_iter().enumerate() {
            if index > 0 {
                self.comma();
            }
            write(self, item);
        }
    }

    /// Runs `inner` between brackets.
    pub(super) fn between_brackets(&mut self, inner: impl FnOnce(&mut Self)) {
        let dense = std::mem::replace(&mut self.dense, true);
        self.put("[");
        inner(self);
        self.put("]");
        self.dense = dense;
    }

    /// An expression of the tree.
    pub(super) fn node(&self, id: ExpressionId) -> &'u ExpressionKind<'s> {
        let node: Option<&'u Expression<'s>> = self.unit.expressions.get(id.0 as usize);
        node.map_or(&ExpressionKind::Error, |expression| &expression.kind)
    }
}
