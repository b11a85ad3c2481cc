//! The matrices of a file, each with the keys of its own.

use stickler_types::DialectName;
use toml::Spanned;

use crate::error::Mistake;
use crate::ident;
use crate::place::TextPlace;
use crate::table::expansion::TableExpansion;
use crate::table::keys::{MatrixKey, MatrixTable};
use crate::table::matrix::Matrix;
use crate::template::{BasisTemplate, Template};

/// One matrix of a file.
pub(crate) struct Section<'a> {
    /// The part of the case ids before the name of the probe.
    pub(crate) name: Option<&'a str>,
    pub(crate) matrix: Matrix,
    pub(crate) dialects: Vec<DialectName>,
    pub(crate) title: Option<Template>,
    pub(crate) basis: Option<BasisTemplate>,
}

/// Reads the matrices; leaves out those with mistakes.
pub(crate) fn read<'a>(
    table: &TableExpansion<'_>,
    key: &'a MatrixKey,
    names: &[Box<str>],
    mistakes: &mut Vec<Mistake>,
) -> Vec<Section<'a>> {
    let texts: Vec<(Option<&MatrixTable>, &Spanned<String>)> = match key {
        MatrixKey::One(text) => vec![(None, text)],
        MatrixKey::Several(tables) => tables.iter().map(|table| (Some(table), &table.table)).collect(),
    };
    let mut reader = SectionReader {
        table,
        names,
        mistakes,
    };
    texts
        .into_iter()
        .filter_map(|(key, text)| reader.section(key, text))
        .collect()
}

struct SectionReader<'a, 't> {
    table: &'a TableExpansion<'t>,
    names: &'a [Box<str>],
    mistakes: &'a mut Vec<Mistake>,
}

impl SectionReader<'_, '_> {
    fn section<'k>(&mut self, key: Option<&'k MatrixTable>, text: &Spanned<String>) -> Option<Section<'k>> {
        let context = self.table.context;
        let start = text.span().start;
        let line = context.lines.line(start);
        let place = TextPlace::of_toml_string(context.text, &context.lines, start);
        let dialects = self.dialects(key, line)?;
        let title = key.and_then(|key| key.title.as_ref());
        let title =
            title.and_then(|title| self.template(title.get_ref(), title.span().start, "matrix.title"));
        let basis = key.and_then(|key| key.basis.as_ref());
        let basis = basis.and_then(|basis| {
            let start = basis.span().start;
            let template = self.template(basis.get_ref().text(), start, "matrix.basis")?;
            let line = context.lines.line(start);
            Some(BasisTemplate { template, line })
        });
        let name = key.and_then(|key| key.name.as_ref());
        if let Some(name) = name
            && let Err(message) = ident::check(name.get_ref())
        {
            self.wrong(name.span().start, "matrix.name", message);
        }
        let matrix = Matrix::read(text.get_ref(), place).map_err(|mistakes| self.mistakes.extend(mistakes));
        Some(Section {
            name: name.map(|name| name.get_ref().as_str()),
            matrix: matrix.ok()?,
            dialects,
            title,
            basis,
        })
    }

    /// Returns the dialects of the matrix that are also dialects of the file.
    fn dialects(&mut self, key: Option<&MatrixTable>, line: u32) -> Option<Vec<DialectName>> {
        let own = key.and_then(|key| key.dialects.as_ref());
        let own = own.map(|names| {
            self.table
                .context
                .resolve(names, "matrix.dialects", self.mistakes)
        });
        let dialects: Vec<DialectName> = match (&self.table.dialects, own) {
            (Some(all), Some(own)) => own.into_iter().filter(|dialect| all.contains(dialect)).collect(),
            (Some(all), None) => all.clone(),
            (None, Some(own)) => own,
            (None, None) => {
                let message = "the file has no dialects, and the matrix has none either";
                self.mistakes.push(Mistake::new(line, message).key("dialects"));
                return None;
            }
        };
        if dialects.is_empty() {
            let message = "none of the matrix's dialects is one of the file's";
            self.mistakes
                .push(Mistake::new(line, message).key("matrix.dialects"));
        }
        Some(dialects)
    }

    fn template(&mut self, text: &str, start: usize, key: &str) -> Option<Template> {
        Template::parse(text, self.names)
            .map_err(|mistake| self.wrong(start, key, mistake.message))
            .ok()
    }

    fn wrong(&mut self, start: usize, key: &str, message: String) {
        self.mistakes
            .push(Mistake::new(self.table.context.lines.line(start), message).key(key));
    }
}
