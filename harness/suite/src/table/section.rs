//! The matrices of a file, each with the keys of its own.

use stickler_types::DialectName;
use toml::Spanned;

use crate::ident;
use crate::place::TextPlace;
use crate::table::expansion::TableExpansion;
use crate::table::key_reader::KeyReader;
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
pub(super) fn read<'k>(
    reader: &mut KeyReader<'_, '_>,
    table: &TableExpansion<'_>,
    key: &'k MatrixKey,
) -> Vec<Section<'k>> {
    let texts: Vec<(Option<&MatrixTable>, &Spanned<String>)> = match key {
        MatrixKey::One(text) => vec![(None, text)],
        MatrixKey::Several(tables) => tables.iter().map(|table| (Some(table), &table.table)).collect(),
    };
    let sections = texts
        .into_iter()
        .filter_map(|(key, text)| section(reader, table, key, text));
    sections.collect()
}

fn section<'k>(
    reader: &mut KeyReader<'_, '_>,
    table: &TableExpansion<'_>,
    key: Option<&'k MatrixTable>,
    text: &Spanned<String>,
) -> Option<Section<'k>> {
    let own = reader.dialects(key.and_then(|key| key.dialects.as_ref()), "matrix.dialects");
    let dialects = dialects(reader, table, own, text)?;
    let title = reader.template(key.and_then(|key| key.title.as_ref()), "matrix.title");
    let basis = reader.basis(key.and_then(|key| key.basis.as_ref()), "matrix.basis");
    let name = key.and_then(|key| key.name.as_ref());
    if let Some(name) = name
        && let Err(message) = ident::check(name.get_ref())
    {
        reader.wrong(name, "matrix.name", message);
    }
    let context = reader.context;
    let place = TextPlace::of_toml_string(context.text, &context.lines, text.span().start);
    let matrix = Matrix::read(text.get_ref(), place).map_err(|mistakes| reader.mistakes.extend(mistakes));
    Some(Section {
        name: name.map(|name| name.get_ref().as_str()),
        matrix: matrix.ok()?,
        dialects,
        title,
        basis,
    })
}

/// Returns the dialects of the matrix that are also dialects of the file.
fn dialects(
    reader: &mut KeyReader<'_, '_>,
    table: &TableExpansion<'_>,
    own: Option<Vec<DialectName>>,
    text: &Spanned<String>,
) -> Option<Vec<DialectName>> {
    let dialects: Vec<DialectName> = match (&table.dialects, own) {
        (Some(all), Some(own)) => own.into_iter().filter(|dialect| all.contains(dialect)).collect(),
        (Some(all), None) => all.clone(),
        (None, Some(own)) => own,
        (None, None) => {
            let message = "the file has no dialects, and the matrix has none either";
            reader.wrong(text, "dialects", message);
            return None;
        }
    };
    if dialects.is_empty() {
        let message = "none of the matrix's dialects is one of the file's";
        reader.wrong(text, "matrix.dialects", message);
    }
    Some(dialects)
}
