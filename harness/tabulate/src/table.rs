//! A row table as the suite reads it, before it is text.

/// A row table: one file of a folder of the suite.
///
/// Its keys are those of the case format; `conformance-cases/README.md` explains them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Table {
    /// The file's name without its extension. Ids begin with it, so it never changes.
    pub name: String,
    /// The claim, in one line.
    pub title: String,
    /// Where the claim comes from, `source: section`.
    pub basis: String,
    /// The dialects and groups that the probes choose from.
    pub dialects: Vec<String>,
    /// A paragraph for a person; empty where there is none.
    pub summary: String,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The rows, each with a cell a column.
    pub rows: Vec<Vec<String>>,
    /// The templates of the programs.
    pub probes: Vec<Probe>,
}

/// A probe of a row table.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Probe {
    /// The probe's name, which stands in the ids.
    pub name: String,
    /// Its own title; empty where it has that of the file.
    pub title: String,
    /// Its own basis; empty where it has that of the file.
    pub basis: String,
    /// The observed variable, perhaps with its type; empty where marks alone say what must happen.
    pub observe: String,
    /// What the observed variable must hold; empty where marks alone say what must happen.
    pub expect: String,
    /// The dialects and groups that it narrows the file's to; empty where it has all of them.
    pub dialects: Vec<String>,
    /// A condition that rows must meet; empty where all do.
    pub only: String,
    /// The template of the program, without an empty line at its start.
    pub source: String,
}
