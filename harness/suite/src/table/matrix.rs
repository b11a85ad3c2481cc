//! Parses the text of a matrix: a line of columns, and a line for each row.

use std::sync::Arc;

use crate::error::Mistake;
use crate::ident;
use crate::place::TextPlace;
use crate::table::expansion::TableExpansion;
use crate::table::keys::{KeyReader, MatrixKey, MatrixTable};
use crate::template::{BasisTemplate, Template};
use crate::toml_text::TextOr;
use stickler_types::{DialectName, MatrixWord};
use toml::Spanned;

/// A parsed matrix.
#[derive(Debug)]
pub(crate) struct Matrix {
    /// The 1-based line of the case file on which the columns stand.
    pub(crate) line: u32,
    pub(crate) columns: Vec<Arc<str>>,
    pub(crate) rows: Vec<MatrixRow>,
}

/// A row of a matrix.
#[derive(Debug)]
pub(crate) struct MatrixRow {
    pub(crate) name: Arc<str>,
    /// The 1-based line of the case file.
    pub(crate) line: u32,
    /// The word for each column; `None` where there is no case.
    pub(crate) words: Vec<Option<MatrixWord>>,
}

impl Matrix {
    /// Reads a matrix that stands at `place`.
    pub(crate) fn read(text: &str, place: TextPlace) -> Result<Matrix, Vec<Mistake>> {
        let lines = (1..)
            .zip(text.lines())
            .map(|(line, text)| (place.line(line), text.trim()));
        let mut lines = lines.filter(|(_, text)| !text.is_empty() && !text.starts_with('#'));
        let Some((first, columns)) = lines.next() else {
            return Err(vec![
                Mistake::new(place.first, "the matrix is empty").key("matrix"),
            ]);
        };
        let columns: Vec<Arc<str>> = columns.split_whitespace().map(Arc::from).collect();
        let mut mistakes = Vec::new();
        if let Some(twice) = repeated(&columns) {
            mistakes.push(Mistake::new(first, format!("there are two columns `{twice}`")).key("matrix"));
        }
        let mut rows = Vec::new();
        for (line, text) in lines {
            match read_row(text, line, columns.len()) {
                Ok(row) => rows.push(row),
                Err(message) => mistakes.push(Mistake::new(line, message).key("matrix")),
            }
        }
        let names: Vec<Arc<str>> = rows.iter().map(|row: &MatrixRow| Arc::clone(&row.name)).collect();
        if let Some(twice) = repeated(&names) {
            let line = rows
                .iter()
                .rfind(|row| row.name == twice)
                .map_or(first, |row| row.line);
            mistakes.push(Mistake::new(line, format!("there are two rows `{twice}`")).key("matrix"));
        }
        if mistakes.is_empty() {
            Ok(Matrix {
                line: first,
                columns,
                rows,
            })
        } else {
            Err(mistakes)
        }
    }
}

fn read_row(text: &str, line: u32, columns: usize) -> Result<MatrixRow, String> {
    let mut words = text.split_whitespace();
    let name: Arc<str> = words.next().unwrap_or_default().into();
    let words: Vec<Option<MatrixWord>> = words.map(read_word).collect::<Result<_, _>>()?;
    if words.len() != columns {
        return Err(format!(
            "row `{name}` has {} cells for {columns} columns",
            words.len()
        ));
    }
    Ok(MatrixRow { name, line, words })
}

fn read_word(word: &str) -> Result<Option<MatrixWord>, String> {
    if word == "-" {
        return Ok(None);
    }
    MatrixWord::from_word(word)
        .map(Some)
        .ok_or_else(|| format!("`{word}` is no word of a cell; there are yes, warn, no, open, = and -"))
}

/// Returns a name that occurs twice, if there is one.
fn repeated(names: &[Arc<str>]) -> Option<Arc<str>> {
    let mut sorted: Vec<&Arc<str>> = names.iter().collect();
    sorted.sort();
    sorted
        .windows(2)
        .find(|pair| pair[0] == pair[1])
        .map(|pair| Arc::clone(pair[0]))
}

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
    match key.get_ref() {
        TextOr::Text(text) => {
            let text = Spanned::new(key.span(), text);
            section(reader, table, None, &text).into_iter().collect()
        }
        TextOr::List(keys) => {
            let sections = keys.iter().filter_map(|key| {
                let text = Spanned::new(key.table.span(), key.table.get_ref());
                section(reader, table, Some(key), &text)
            });
            sections.collect()
        }
    }
}

fn section<'k>(
    reader: &mut KeyReader<'_, '_>,
    table: &TableExpansion<'_>,
    key: Option<&'k MatrixTable>,
    text: &Spanned<&String>,
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
    text: &Spanned<&String>,
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
