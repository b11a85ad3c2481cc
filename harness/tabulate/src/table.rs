//! A row table of the suite: its head as a person writes it, its calls, and the text of its rows.

use crate::call::{Call, CellWriter, of_column};
use crate::generate;
use serde::Deserialize;
use std::ops::Range;
use std::sync::Arc;
use stickler_suite::{Bases, Dialects, Generate, SourceKind, Sources};
use stickler_types::{DialectName, ElementaryType, WrittenValue};
use toml::Spanned;

/// The keys of a case file that matter here; the suite checks all of them.
#[derive(Deserialize)]
struct TableKeys {
    basis: Option<Bases>,
    #[serde(default)]
    dialects: Vec<String>,
    #[serde(default)]
    columns: Vec<String>,
    rows: Option<Spanned<Vec<Vec<String>>>>,
    generate: Option<Generate>,
    #[serde(default)]
    probe: Vec<ProbeKeys>,
}

#[derive(Deserialize)]
struct ProbeKeys {
    name: String,
    basis: Option<Bases>,
    dialects: Option<Vec<String>>,
    expect: Option<String>,
    observe: Option<toml::Value>,
    #[serde(default)]
    source: String,
}

/// The names that the tables of a folder may use.
#[derive(Clone, Debug, Default)]
pub struct TableNames {
    /// The dialects and groups.
    pub dialects: Dialects,
    /// The sources.
    pub sources: Arc<Sources>,
}

/// A table file.
#[derive(Clone, Debug)]
pub struct Table {
    /// The file's name without its extension.
    pub name: String,
    /// The text of the file.
    pub text: String,
    /// The dialects of the file.
    pub dialects: Vec<DialectName>,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The rows of the file.
    pub rows: Vec<Vec<String>>,
    /// The file's `[generate]` table.
    pub generate: Option<Generate>,
    /// The probes.
    pub probes: Vec<TableProbe>,
    /// The position of the value of `rows` in the text.
    span: Range<usize>,
    /// The sources that a basis may name.
    sources: Arc<Sources>,
}

/// A probe of a table.
#[derive(Clone, Debug)]
pub struct TableProbe {
    /// The name, which stands in ids.
    pub name: String,
    /// The claim of the probe; `None` where its marks alone state it.
    pub claim: Option<ProbeClaim>,
    /// The dialects in which it claims that.
    pub dialects: Vec<DialectName>,
    /// Whether it names them as `all`, so that a row is asked in those whose sources say so.
    pub is_of_all: bool,
    /// The sources that say so, as one text: a dialect's is the first that speaks for it.
    pub basis: String,
    /// Whether a row may be recorded instead: the variable is observed with its type.
    pub may_be_open: bool,
    /// The template of the program; empty for a probe whose programs are put together of places.
    pub source: String,
}

/// The claim of a probe about the result of a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProbeClaim {
    /// The result is that of the column `expected`: `expect = "{expected}"`.
    Value,
    /// No document says what the result is; it is recorded: `expect = "open"`.
    Open,
    /// The program is accepted and runs to its end, and the result is open: an `ok` mark, or `expect = "accepted"`.
    NeverFaults,
}

impl Table {
    /// Reads a table file.
    ///
    /// # Errors
    /// A sentence, where the text is no table file or names an unknown dialect.
    pub fn read(name: &str, text: &str, names: &TableNames) -> Result<Table, String> {
        let keys: TableKeys = toml::from_str(text).map_err(|error| error.to_string())?;
        let dialects = &names.dialects;
        let all = resolve(&keys.dialects, dialects)?;
        let own = keys.basis.unwrap_or_default();
        let probes = keys.probe.into_iter().map(|probe| {
            Ok(TableProbe {
                claim: ProbeClaim::of(&probe),
                is_of_all: Dialects::is_all(&probe.dialects.as_ref().unwrap_or(&keys.dialects).join(" ")),
                dialects: match &probe.dialects {
                    Some(names) => resolve(names, dialects)?,
                    None => all.clone(),
                },
                may_be_open: probe
                    .observe
                    .is_some_and(|observe| observe.as_str().is_some_and(|name| name.contains(" : "))),
                name: probe.name,
                basis: probe.basis.as_ref().unwrap_or(&own).text().to_owned(),
                source: probe.source,
            })
        });
        let probes = probes.collect::<Result<_, String>>()?;
        let (span, rows) = match keys.rows {
            Some(rows) => (rows.span(), rows.into_inner()),
            None => (0..0, Vec::new()),
        };
        Ok(Table {
            name: name.to_owned(),
            text: text.to_owned(),
            dialects: all,
            columns: keys.columns,
            rows,
            generate: keys.generate,
            probes,
            span,
            sources: Arc::clone(&names.sources),
        })
    }

    /// Returns how the cells of each column are written, or nothing where the rows are no calls of one function.
    fn cells(&self) -> Option<Vec<CellWriter>> {
        let names_types = ["from", "to"].iter().all(|name| self.column(name).is_some());
        let names_operand = self.generate.is_some() || self.column("input").is_some();
        if !names_types || !names_operand {
            return None;
        }
        self.columns.iter().map(|name| of_column(name)).collect()
    }

    /// Returns whether the rows are calls of one function, so that this crate computes their cells.
    pub fn is_of_calls(&self) -> bool {
        self.cells().is_some()
    }

    /// Returns whether the rows have a cell of this name.
    pub(crate) fn has_column(&self, name: &str) -> bool {
        self.column(name).is_some()
    }

    /// Returns the one of several bases that a case of a dialect has.
    pub(crate) fn chosen<'b>(&self, bases: &'b str, dialect: DialectName) -> Option<&'b str> {
        self.sources.choose(bases, dialect)
    }

    /// Returns the kind of the source of a basis.
    pub(crate) fn kind_of(&self, basis: &str) -> Option<SourceKind> {
        self.sources.of(basis).map(|(source, _)| source.kind)
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// Returns the calls that the head generates, as far as the documents say of them what the probes claim; where it generates
    /// none, those of the rows.
    ///
    /// # Errors
    /// A sentence, where an entry of `[generate]` means nothing, or a row is no call of a conversion function.
    pub fn calls(&self) -> Result<Vec<Call>, String> {
        let Some(generate) = &self.generate else {
            let mut calls = Vec::new();
            for row in &self.rows {
                let call = self.call(row)?;
                // A call has a row for each of its results.
                if calls.last() != Some(&call) {
                    calls.push(call);
                }
            }
            return Ok(calls);
        };
        let mut calls = generate::calls(generate)?;
        calls.retain(|call| self.expected(call).is_ok());
        Ok(calls)
    }

    /// Returns the call of a row.
    fn call(&self, row: &[String]) -> Result<Call, String> {
        let cell = |name| {
            let at = self.column(name)?;
            row.get(at).map(String::as_str)
        };
        let call = || {
            let (from, to) = (cell("from")?, cell("to")?);
            let mut operands = vec![operand(from, cell("input")?)?];
            if let (Some(ty), Some(literal)) = (cell("with"), cell("second")) {
                operands.push(operand(ty, literal)?);
            }
            let function = cell("function").map_or_else(|| format!("{from}_TO_{to}"), str::to_owned);
            Call::new(&function, operands, ElementaryType::from_name(to)?)
        };
        call().ok_or_else(|| format!("{row:?} is no call of a conversion function"))
    }

    /// Returns the rows of these calls.
    ///
    /// # Errors
    /// A sentence that names the call, where a probe [claims](Table::expected) what no document says.
    pub fn rows_of(&self, calls: &[Call]) -> Result<Vec<Vec<String>>, String> {
        let cells = self.cells().unwrap_or_default();
        let mut rows = Vec::new();
        for call in calls {
            let expected = self.expected(call).map_err(|what| format!("{call}: {what}"))?;
            let row = |agreed| cells.iter().map(|cell| cell(call, agreed)).collect();
            rows.extend(expected.iter().map(row));
        }
        Ok(rows)
    }

    /// Returns the text of the file with other rows in place of its own; nothing else changes.
    pub fn with_rows(&self, rows: &[Vec<String>]) -> String {
        let (before, after) = (&self.text[..self.span.start], &self.text[self.span.end..]);
        format!("{before}{}{after}", aligned(rows))
    }
}

impl ProbeClaim {
    fn of(probe: &ProbeKeys) -> Option<ProbeClaim> {
        match probe.expect.as_deref() {
            Some("{expected}") => Some(ProbeClaim::Value),
            Some("open") => Some(ProbeClaim::Open),
            Some("accepted") => Some(ProbeClaim::NeverFaults),
            None if probe.source.contains("(*! ok *)") => Some(ProbeClaim::NeverFaults),
            _ => None,
        }
    }
}

fn operand(ty: &str, literal: &str) -> Option<WrittenValue> {
    WrittenValue::parse(ElementaryType::from_name(ty)?, literal).ok()
}

fn resolve(names: &[String], dialects: &Dialects) -> Result<Vec<DialectName>, String> {
    let mut all = Vec::new();
    for name in names {
        all.extend(dialects.resolve(name)?);
    }
    Ok(all)
}

/// Writes rows as a TOML array in which each cell is as wide as the widest of its column. Rows with texts of several lines, which are far apart,
/// are not aligned.
fn aligned(rows: &[Vec<String>]) -> String {
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(|cell| quoted(cell)).collect())
        .collect();
    let columns = rows.first().map_or(0, Vec::len);
    let has_lines = rows.iter().flatten().any(|cell| cell.contains('\n'));
    let widths: Vec<usize> = (0..columns)
        .map(|column| {
            let cells = rows.iter().filter(|_| !has_lines);
            let cells = cells.filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        })
        .collect();
    let mut out = String::from("[\n");
    for row in &rows {
        let mut text = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            text.push_str(&format!("{:<width$} ", format!("{cell},"), width = width + 1));
        }
        out.push_str(&format!("    [{}],\n", text.trim_end().trim_end_matches(',')));
    }
    out.push(']');
    out
}

/// Writes a TOML string on one line: between double quotes, or between single ones where that spares the reader escapes. A text of several lines
/// begins on a line of its own.
fn quoted(text: &str) -> String {
    if text.contains('\n') {
        return format!("\"\"\"\n{text}\"\"\"");
    }
    let needs_escapes = text.contains(['"', '\\']);
    if needs_escapes && !text.contains('\'') {
        return format!("'{text}'");
    }
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
