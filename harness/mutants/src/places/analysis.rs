//! A program as the reference checks it, with a record of where its values meet types.

use super::standing::Standings;
use stickler_reference::semantics::{CheckedProgram, TracedUse, check_traced};
use stickler_syntax::diagnostic::{SpannedDiagnostic, has_errors};
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::{Expression, ExpressionId, SourceUnit};
use stickler_types::Dialect;

/// A program, checked.
#[derive(Debug)]
pub struct Analysis<'s> {
    /// The text.
    pub source: &'s str,
    /// The lines of the text.
    pub lines: LineIndex,
    /// The tree.
    pub unit: SourceUnit<'s>,
    /// The errors.
    pub diagnostics: Vec<SpannedDiagnostic>,
    /// The program that runs, where there are no errors.
    pub program: Option<CheckedProgram>,
    /// The places at which values meet types.
    pub uses: Vec<TracedUse>,
    /// The place in which each expression stands.
    pub standings: Standings,
}

impl<'s> Analysis<'s> {
    /// Reads and checks a program.
    pub fn new(source: &'s str, dialect: &Dialect) -> Analysis<'s> {
        let lines = LineIndex::new(source);
        let (unit, mut diagnostics) = stickler_syntax::parse(source, dialect);
        let (program, found, uses) = check_traced(&unit, source, &lines, dialect);
        diagnostics.extend(found);
        let standings = Standings::new(&unit, &lines);
        Analysis {
            source,
            lines,
            unit,
            diagnostics,
            program,
            uses,
            standings,
        }
    }

    /// Returns whether the text is rejected.
    pub fn is_rejected(&self) -> bool {
        has_errors(&self.diagnostics)
    }

    /// Returns an expression of the tree.
    pub fn expression(&self, id: ExpressionId) -> &Expression<'s> {
        &self.unit.expressions[id.0 as usize]
    }
}
