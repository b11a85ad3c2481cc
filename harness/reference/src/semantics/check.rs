//! From a syntax tree to a checked program.

use super::declare::declare;
use super::lowering::Lowering;
use super::model::{Model, SourceText};
use super::observation::{CheckedProgram, VariableTable};
use super::reporter::Reporter;
use super::trace::{Trace, TracedUse};
use crate::instruction::MachineProgram;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::SourceUnit;
use stickler_types::dialect::Dialect;

/// Checks names and types of a source text, and lowers it.
///
/// Takes the tree of `text`, the index of its lines, and the dialect. Gives a program, unless anything is wrong
/// or the text has no PROGRAM, and everything that is wrong in the order of the text.
pub fn check(
    unit: &SourceUnit<'_>,
    text: &str,
    lines: &LineIndex,
    dialect: &Dialect,
) -> (Option<CheckedProgram>, Vec<SpannedDiagnostic>) {
    let (checked, diagnostics, _) = lower(unit, text, lines, dialect, None);
    (checked, diagnostics)
}

/// Checks a source text as [`check`] does, and gives besides all places at which a value meets a type or a bit is read or written,
/// whether or not anything is wrong.
pub fn check_traced(
    unit: &SourceUnit<'_>,
    text: &str,
    lines: &LineIndex,
    dialect: &Dialect,
) -> (Option<CheckedProgram>, Vec<SpannedDiagnostic>, Vec<TracedUse>) {
    lower(unit, text, lines, dialect, Some(Trace::default()))
}

fn lower(
    unit: &SourceUnit<'_>,
    text: &str,
    lines: &LineIndex,
    dialect: &Dialect,
    trace: Option<Trace>,
) -> (Option<CheckedProgram>, Vec<SpannedDiagnostic>, Vec<TracedUse>) {
    let source = SourceText {
        unit,
        text,
        lines,
        dialect,
    };
    let mut reporter = Reporter::default();
    let (model, memory) = declare(source, &mut reporter);
    let mut lowering = Lowering::new(&model, memory, &mut reporter);
    lowering.emitter.keep(trace);
    let (program, uses) = lowering.lower();
    let checked = finish(model, program, &reporter);
    (checked, reporter.finish(), uses)
}

fn finish(model: Model<'_>, program: MachineProgram, reporter: &Reporter) -> Option<CheckedProgram> {
    if reporter.has_errors()
        || model.has_external_functions()
        || model.instances.iter().all(|instance| !instance.runs)
    {
        return None;
    }
    Some(CheckedProgram {
        program,
        directory: VariableTable::new(model),
    })
}
