//! Parses the text of a matrix: a line of columns, and a line for each row.

use std::sync::Arc;

use stickler_types::MatrixWord;

use crate::error::Mistake;
use crate::place::TextPlace;

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
