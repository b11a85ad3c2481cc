//! The folder that holds the tables, the rows that it must have, and the results that IEC 60559 and two's complement suggest where a table only
//! records them.

use crate::call::Call;
use crate::table::{ProbeClaim, Table, TableNames};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use stickler_suite::{Suite, Wanted};
use stickler_types::{DialectName, ElementaryType, Value};

/// The folder of the case files, seen from the root of the repository.
const SUITE: &str = "conformance-cases";

/// The tables of a folder, seen from the folder of the case files.
const TABLES: &str = "conversion";

/// A table of calls together with its calls.
#[derive(Clone, Debug)]
pub struct CallTable {
    /// The path of the file.
    pub path: PathBuf,
    /// The file as it is.
    pub table: Table,
    /// The calls that it must have, one a row.
    pub calls: Vec<Call>,
    /// The rows that it must have.
    pub rows: Vec<Vec<String>>,
}

impl CallTable {
    /// Returns the text that the file must have.
    pub fn wanted(&self) -> String {
        self.table.with_rows(&self.rows)
    }

    /// Returns whether the file has other rows than it must have.
    pub fn differs(&self) -> bool {
        self.wanted() != self.table.text
    }
}

/// Reads every table file of `conformance-cases/conversion`, ordered by name; `root` is the repository.
///
/// # Errors
/// A message, where a file cannot be read or is no table.
pub fn tables(root: &Path) -> Result<Vec<(PathBuf, Table)>, String> {
    tables_in(root, TABLES)
}

/// Reads every table file of a folder of the case files, ordered by name; `root` is the repository.
pub(crate) fn tables_in(root: &Path, folder: &str) -> Result<Vec<(PathBuf, Table)>, String> {
    let names = names(root)?;
    let folder = root.join(SUITE).join(folder);
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let tables = paths.into_iter().map(|path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let table = Table::read(&name, &read(&path)?, &names);
        let table = table.map_err(|what| format!("{}: {what}", path.display()))?;
        Ok((path, table))
    });
    tables.collect()
}

/// Returns the dialects and the sources that the tables may name.
///
/// # Errors
/// A message, where one of the two files cannot be read or has a mistake.
pub fn names(root: &Path) -> Result<TableNames, String> {
    let suite = root.join(SUITE);
    let suite = Suite::load_files(&suite, Wanted::default(), |_, _| false);
    match suite.errors.first() {
        Some(mistake) => Err(mistake.to_string()),
        None => Ok(TableNames {
            dialects: suite.dialects,
            sources: suite.sources.into(),
        }),
    }
}

/// Reads every table of calls, and computes its calls and rows.
///
/// # Errors
/// A message, where a file cannot be read, or its head or a row claims what no document says.
pub fn call_tables(root: &Path) -> Result<Vec<CallTable>, String> {
    let mut tables = tables(root)?;
    tables.retain(|(_, table)| table.is_of_calls());
    let mut calls = HashMap::new();
    for (path, table) in &tables {
        let own = table
            .calls()
            .map_err(|what| format!("{}: {what}", path.display()))?;
        calls.insert(table.name.clone(), own);
    }
    let rows = tables.into_iter().map(|(path, table)| {
        let fail = |what: String| format!("{}: {what}", path.display());
        let calls = without_besides(&table, &calls).map_err(fail)?;
        if calls.is_empty() {
            return Err(fail("the table has no rows".to_owned()));
        }
        let rows = table.rows_of(&calls).map_err(fail)?;
        Ok(CallTable {
            path,
            table,
            calls,
            rows,
        })
    });
    rows.collect()
}

/// Returns the calls of a table without those of the tables that it stands beside.
fn without_besides(table: &Table, calls: &HashMap<String, Vec<Call>>) -> Result<Vec<Call>, String> {
    let besides = table.generate.iter().flat_map(|generate| &generate.besides);
    let mut others = HashSet::new();
    for name in besides {
        let calls = calls
            .get(name)
            .ok_or_else(|| format!("`besides` names `{name}`, which is no table of calls"))?;
        others.extend(calls.iter().map(Call::to_string));
    }
    let own = calls.get(&table.name).into_iter().flatten();
    Ok(own
        .filter(|call| !others.contains(&call.to_string()))
        .cloned()
        .collect())
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The result that IEC 60559 and two's complement suggest for a call of which a probe asserts nothing.
///
/// The suite records such a result and holds no engine to it. The reference says of itself that it does what they suggest, so
/// its own test holds it to this.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Suggestion {
    /// The table and the call, for a message.
    pub place: String,
    /// The dialect in which the probe asks.
    pub dialect: DialectName,
    /// The program; its variable `into` receives the result.
    pub program: String,
    /// The type of `into`.
    pub ty: ElementaryType,
    /// The result.
    pub value: Value,
}

impl CallTable {
    /// Returns the suggested result of each call that a probe only records.
    pub fn suggestions(&self) -> Vec<Suggestion> {
        let mut suggestions = Vec::new();
        let probes = self.table.probes.iter();
        for probe in probes.filter(|probe| probe.claim != Some(ProbeClaim::Value)) {
            for &dialect in &probe.dialects {
                let rows = self.calls.iter().zip(&self.rows);
                suggestions.extend(rows.filter_map(|(call, row)| {
                    Some(Suggestion {
                        place: format!("{}: {call}", self.table.name),
                        dialect,
                        program: self.filled(&probe.source, row),
                        ty: call.to(),
                        value: call.expected(dialect)?.value,
                    })
                }));
            }
        }
        suggestions
    }

    /// Replaces the placeholders of a template by the cells of a row.
    fn filled(&self, template: &str, row: &[String]) -> String {
        let cells = self.table.columns.iter().zip(row);
        cells.fold(template.to_owned(), |text, (column, cell)| {
            text.replace(&format!("{{{column}}}"), cell)
        })
    }
}
