//! The error of reading a `results.json`.

use super::FORMAT;
use std::io;

/// An error of reading a `results.json`.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// The file cannot be read.
    #[error("cannot read the results")]
    Read(#[from] io::Error),
    /// The file is empty.
    #[error("the file is empty, so it is no results.json")]
    Empty,
    /// The file ends before the document does.
    #[error(
        "the file ends at line {line}, column {column}, before its document does: it was cut short, so copy it again"
    )]
    CutShort {
        /// The number of the last line, from 1.
        line: usize,
        /// The column at which the file ends, from 1.
        column: usize,
    },
    /// The file is no JSON.
    #[error("the file is no JSON, so it is no results.json")]
    NoJson(#[source] serde_json::Error),
    /// The document has no number of a format.
    #[error("the document is no results.json of Stickler: it has no number under the key `format`")]
    NoFormat,
    /// The document has an earlier version of the format.
    #[error(
        "the results have format {0}, which an earlier version of Stickler wrote; this one reads format {FORMAT}: run the cases \
         again with this version"
    )]
    Earlier(u32),
    /// The document has a later version of the format.
    #[error(
        "the results have format {0}, which a later version of Stickler wrote; this one reads format {FORMAT}"
    )]
    Later(u32),
    /// A part of the document is not as the schema says.
    #[error("{path}: {source}")]
    Schema {
        /// The path of the part in the document, such as `cases[3].verdict`.
        path: String,
        /// The error of parsing it, which says what was expected and found.
        source: serde_json::Error,
    },
    /// Parts of the document contradict each other, though each is as the schema says.
    #[error("{path}: expected {expected}, found {found}")]
    Contradiction {
        /// The path of the part in the document.
        path: String,
        /// The description of what was expected.
        expected: String,
        /// The description of what is there.
        found: String,
    },
}
