//! From a syntax tree to a checked program and its diagnostics.

use super::declare::declare;
use super::lowering::Lowering;
use super::model::{Model, SourceText};
use super::observation::{CheckedProgram, VariableTable};
use super::trace::{Trace, TracedUse};
use crate::instruction::MachineProgram;
use stickler_syntax::diagnostic::{Diagnostics, SpannedDiagnostic};
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::SourceUnit;
use stickler_types::{Code, Dialect};

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

/// Collects diagnostics; can be muted while something is lowered once more.
#[derive(Debug, Default)]
pub(super) struct Reporter {
    diagnostics: Diagnostics,
    muted: bool,
    /// The number of errors so far, the muted ones included.
    errors: usize,
}

impl Reporter {
    /// Reports something wrong at a place.
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl Into<String>) {
        self.push(SpannedDiagnostic::new(code, span, message));
    }

    /// Reports a diagnostic that is already made, with its suggestion.
    pub(super) fn push(&mut self, diagnostic: SpannedDiagnostic) {
        self.errors += usize::from(diagnostic.code.severity().is_error());
        if !self.muted {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Mutes or unmutes; returns the state before.
    pub(super) fn mute(&mut self, muted: bool) -> bool {
        std::mem::replace(&mut self.muted, muted)
    }

    /// Returns how many errors have been reported so far, the muted ones included.
    pub(super) fn errors(&self) -> usize {
        self.errors
    }

    /// Returns whether an error has been reported that was not muted.
    pub(super) fn has_errors(&self) -> bool {
        self.diagnostics.has_errors()
    }

    /// Returns all diagnostics in the order of the text.
    pub(super) fn finish(self) -> Vec<SpannedDiagnostic> {
        self.diagnostics.into_list()
    }
}
