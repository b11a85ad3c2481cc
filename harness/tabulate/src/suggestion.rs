//! The results that IEC 60559 and two's complement suggest where a table only records them.

use crate::folder::CallTable;
use crate::table::ProbeClaim;
use stickler_types::{DialectName, ElementaryType, Value};

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
    #[must_use]
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
