//! What the design suggests where a table only records: the reference is held to it by a test of its own.

use crate::sheet::{Claim, Sheet, resolve};
use stickler_types::{DialectName, ElementaryType, Value};

/// What the design suggests for a call of which a probe asserts nothing.
///
/// The suite records such a value and holds nobody to it. The reference says of itself that it does what the design suggests, so
/// its own test may hold it to this.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Suggestion {
    /// The table and the call, for a message.
    pub place: String,
    /// The dialect in which the probe asks.
    pub dialect: DialectName,
    /// The program; the value arrives in its variable `into`.
    pub program: String,
    /// The type of `into`.
    pub ty: ElementaryType,
    /// The value.
    pub value: Value,
}

impl Sheet {
    /// What the design suggests for each call that a probe only records.
    ///
    /// # Errors
    /// As [`Sheet::table`].
    pub fn suggestions(&self) -> Result<Vec<Suggestion>, String> {
        let table = self.table()?;
        let mut suggestions = Vec::new();
        for (probe, written) in self.probes.iter().zip(&table.probes) {
            if probe.claim == Claim::Value {
                continue;
            }
            for dialect in resolve(probe.dialects_in(self))? {
                let rows = self.calls.iter().zip(&table.rows);
                suggestions.extend(rows.filter_map(|(call, row)| {
                    Some(Suggestion {
                        place: format!("{}: {call}", self.name),
                        dialect,
                        program: filled(&written.source, &table.columns, row),
                        ty: call.to(),
                        value: call.expected(dialect)?.value,
                    })
                }));
            }
        }
        Ok(suggestions)
    }
}

/// A template with the cells of a row for the names of their columns.
fn filled(template: &str, columns: &[String], row: &[String]) -> String {
    let cells = columns.iter().zip(row);
    cells.fold(template.to_owned(), |text, (column, cell)| {
        text.replace(&format!("{{{column}}}"), cell)
    })
}
