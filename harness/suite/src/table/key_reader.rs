//! Reads the keys that files, matrices and probes have in common: templates, bases, conditions and dialects.

use stickler_types::DialectName;
use toml::Spanned;

use crate::bases::Bases;
use crate::condition::{Condition, Testable};
use crate::error::Mistake;
use crate::frame::FileContext;
use crate::template::{BasisTemplate, Template};

/// Reads keys of a table, and collects what is wrong with them.
pub(super) struct KeyReader<'a, 'c> {
    pub(super) context: &'c FileContext<'c>,
    /// The placeholders of the file, and which of them conditions may test.
    pub(super) testable: Testable<'a>,
    pub(super) mistakes: Vec<Mistake>,
    /// The warnings about programs that can be used.
    pub(super) remarks: Vec<Mistake>,
}

impl<'a, 'c> KeyReader<'a, 'c> {
    pub(super) fn new(context: &'c FileContext<'c>, testable: Testable<'a>) -> KeyReader<'a, 'c> {
        KeyReader {
            context,
            testable,
            mistakes: Vec::new(),
            remarks: Vec::new(),
        }
    }

    pub(super) fn wrong<T>(&mut self, at: &Spanned<T>, key: &str, message: impl Into<String>) {
        self.mistakes.push(self.context.lines.mistake(at, key, message));
    }

    /// Reads a text with placeholders, which belongs to what is written at `at`.
    pub(super) fn text<T>(&mut self, at: &Spanned<T>, text: &str, key: &str) -> Option<Template> {
        let template = Template::parse(text, self.testable.names);
        template
            .map_err(|mistake| self.wrong(at, key, mistake.message))
            .ok()
    }

    pub(super) fn template(&mut self, text: Option<&Spanned<String>>, key: &str) -> Option<Template> {
        self.text(text?, text?.get_ref(), key)
    }

    pub(super) fn basis(&mut self, basis: Option<&Spanned<Bases>>, key: &str) -> Option<BasisTemplate> {
        let template = self.text(basis?, basis?.get_ref().text(), key)?;
        let line = self.context.lines.of(basis?);
        Some(BasisTemplate { template, line })
    }

    /// Reads a condition, which always holds where none is written.
    pub(super) fn condition(&mut self, only: Option<&Spanned<String>>, key: &str) -> Option<Condition> {
        let Some(only) = only else {
            return Some(Condition::default());
        };
        let words: Vec<&str> = only.get_ref().split_whitespace().collect();
        let condition = Condition::parse(&words, self.testable);
        condition.map_err(|message| self.wrong(only, key, message)).ok()
    }

    pub(super) fn dialects(
        &mut self,
        names: Option<&Vec<Spanned<String>>>,
        key: &str,
    ) -> Option<Vec<DialectName>> {
        Some(self.context.resolve(names?, key, &mut self.mistakes))
    }
}
