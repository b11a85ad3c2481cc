//! From a syntax tree to a checked program.

use super::declare::declare;
use super::lowering::Lowering;
use super::model::{Model, SourceText};
use super::observation::{CheckedProgram, VariableTable};
use super::reporter::Reporter;
use crate::diagnostic::SpannedDiagnostic;
use crate::dialect::Dialect;
use crate::instruction::MachineProgram;
use crate::source::LineIndex;
use crate::syntax::tree::SourceUnit;

/// Checks names and types of a source text, and lowers it.
///
/// Takes the tree of `text`, the index of its lines, and the dialect. Gives a program, unless anything is wrong
/// or the text has no PROGRAM, and everything that is wrong in the order of the text.
#[must_use]
pub fn check(
    unit: &SourceUnit<'_>,
    text: &str,
    lines: &LineIndex,
    dialect: &Dialect,
) -> (Option<CheckedProgram>, Vec<SpannedDiagnostic>) {
    let mut reporter = Reporter::default();
    let source = SourceText {
        unit,
        text,
        lines,
        dialect,
    };
    let (model, memory) = declare(source, &mut reporter);
    let program = Lowering::new(&model, memory, &mut reporter).lower();
    let checked = finish(model, program, &reporter);
    (checked, reporter.finish())
}

fn finish(model: Model<'_>, program: MachineProgram, reporter: &Reporter) -> Option<CheckedProgram> {
    if !reporter.is_empty() || model.instances.is_empty() {
        return None;
    }
    Some(CheckedProgram {
        program,
        directory: VariableTable::new(model),
    })
}
