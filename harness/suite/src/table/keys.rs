//! The keys of a table file, and the reader of those that files, matrices and probes have in common: templates, bases, conditions and dialects.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use crate::bases::Bases;
use crate::condition::{Condition, Testable};
use crate::error::Mistake;
use crate::frame::FileContext;
use crate::template::{BasisTemplate, Template};
use crate::toml_text::{Scalar, Strings, TextOr};
use stickler_types::DialectName;

/// The keys of a whole table file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableFile {
    pub(crate) title: Spanned<String>,
    pub(crate) basis: Option<Spanned<Bases>>,
    pub(crate) dialects: Option<Vec<Spanned<String>>>,
    pub(crate) summary: Option<String>,
    #[serde(default)]
    pub(crate) tags: Vec<String>,
    pub(crate) scans: Option<Spanned<u32>>,
    pub(crate) matrix: Option<MatrixKey>,
    #[serde(default)]
    pub(crate) types: BTreeMap<String, TypeKey>,
    pub(crate) columns: Option<Vec<Spanned<String>>>,
    pub(crate) rows: Option<Vec<Spanned<TableRow>>>,
    pub(crate) expect: Option<Spanned<String>>,
    pub(crate) asks: Option<Spanned<String>>,
    pub(crate) generate: Option<Spanned<Generate>>,
    #[serde(default)]
    pub(crate) probe: Vec<Spanned<ProbeKey>>,
}

/// The `[generate]` table of a row table: the calls of conversion functions that its rows are made of.
///
/// The suite reads the rows and only checks the keys; `stickler-tabulate` writes the rows.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Generate {
    /// The names of the functions, in which `{from}` and `{to}` stand for the types; an empty list stands for
    /// `{from}_TO_{to}`.
    #[serde(default)]
    pub functions: Vec<String>,
    /// The source types.
    pub from: Vec<String>,
    /// The target types.
    pub to: Vec<String>,
    /// The operands: literals, numbers beside a limit of a type, and names of lists.
    pub inputs: Vec<String>,
    /// The calls that are taken, by what becomes of the number: `narrowed`, `kept` or `with-a-sign`. `None` for all.
    pub only: Option<String>,
    /// The tables whose calls are left out.
    #[serde(default)]
    pub besides: Vec<String>,
}

/// One row of a table.
pub(crate) type TableRow = Vec<Spanned<Scalar>>;

/// `matrix = """…"""` or `[[matrix]]`.
pub(crate) type MatrixKey = Spanned<TextOr<MatrixTable>>;

/// One `[[matrix]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MatrixTable {
    pub(crate) name: Option<Spanned<String>>,
    pub(crate) dialects: Option<Vec<Spanned<String>>>,
    pub(crate) basis: Option<Spanned<Bases>>,
    pub(crate) title: Option<Spanned<String>>,
    pub(crate) table: Spanned<String>,
}

/// One `[types.NAME]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TypeKey {
    pub(crate) declaration: Spanned<String>,
    pub(crate) base: Option<Spanned<String>>,
    #[serde(default)]
    pub(crate) values: Vec<Spanned<Scalar>>,
    #[serde(default)]
    pub(crate) arrives: Vec<Spanned<String>>,
}

/// One `[[probe]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProbeKey {
    pub(crate) name: Spanned<String>,
    pub(crate) source: Option<Spanned<String>>,
    pub(crate) places: Option<Spanned<PlacesKey>>,
    pub(crate) observe: Option<Strings>,
    pub(crate) values: Option<Spanned<TextOr<Spanned<Scalar>>>>,
    pub(crate) expect: Option<Spanned<String>>,
    pub(crate) asks: Option<Spanned<String>>,
    pub(crate) only: Option<Spanned<String>>,
    pub(crate) dialects: Option<Vec<Spanned<String>>>,
    pub(crate) title: Option<Spanned<String>>,
    pub(crate) basis: Option<Spanned<Bases>>,
    pub(crate) summary: Option<String>,
    pub(crate) scans: Option<Spanned<u32>>,
    #[serde(default)]
    pub(crate) tags: Vec<String>,
}

/// The key `places` of a probe, whose programs are put together of places instead of being written out.
///
/// The texts stand for the words of `places.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlacesKey {
    pub(crate) sources: Option<Vec<Spanned<String>>>,
    pub(crate) targets: Option<Vec<Spanned<String>>>,
    pub(crate) surroundings: Option<Vec<Spanned<String>>>,
    pub(crate) from: Option<String>,
    pub(crate) to: Option<String>,
    pub(crate) value: Option<String>,
    pub(crate) typed: Option<String>,
    pub(crate) expression: Option<String>,
    pub(crate) variable: Option<String>,
    pub(crate) declarations: Option<String>,
    pub(crate) before: Option<String>,
    pub(crate) error: Option<String>,
    pub(crate) code: Option<String>,
    pub(crate) combinations: Option<usize>,
}

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
