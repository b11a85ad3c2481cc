//! Changes to what the reference made of a program: its errors, its instructions, its tree.

use super::analysis::Analysis;
use stickler_reference::instruction::{Instruction, Label, MachineProgram};
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ExpressionId, ExpressionKind};
use stickler_types::Code;

/// A change to one place of a program.
#[derive(Clone, PartialEq, Debug)]
pub enum SourceChange {
    /// An error is reported that is none.
    Refuse(Span),
    /// The errors of these numbers are not reported.
    Admit(Vec<usize>),
    /// Instructions are replaced.
    Code {
        /// The label of the first instruction that is removed.
        at: Label,
        /// The number of instructions that are removed.
        removed: u32,
        /// The instructions that stand there instead.
        inserted: Vec<Instruction>,
    },
    /// The renderer writes another bit.
    Bit(ExpressionId),
}

/// Makes the changes of a saboteur.
pub fn apply<'c>(analysis: &mut Analysis<'_>, changes: impl IntoIterator<Item = &'c SourceChange>) {
    let mut admitted = Vec::new();
    let mut refused = Vec::new();
    let mut edits = Vec::new();
    for change in changes {
        match change {
            SourceChange::Refuse(span) => refused.push(SpannedDiagnostic::new(
                Code::AssignmentTypeMismatch,
                *span,
                "this is refused here",
            )),
            SourceChange::Admit(errors) => admitted.extend(errors),
            SourceChange::Code {
                at,
                removed,
                inserted,
            } => edits.push((*at, *removed, &inserted[..])),
            SourceChange::Bit(id) => {
                if let ExpressionKind::Bit { index, .. } = &mut analysis.unit.expressions[id.0 as usize].kind
                {
                    *index ^= 1;
                }
            }
        }
    }
    let mut number = 0;
    analysis.diagnostics.retain(|_| {
        number += 1;
        !admitted.contains(&&(number - 1))
    });
    if !admitted.is_empty() {
        // What was made of a program with errors is not fit to be run.
        analysis.program = None;
    }
    analysis.diagnostics.extend(refused);
    if let Some(checked) = &mut analysis.program {
        edit(&mut checked.program, edits);
    }
}

/// Replaces instructions, from the last to the first so that the labels of the others stay.
fn edit(program: &mut MachineProgram, mut edits: Vec<(Label, u32, &[Instruction])>) {
    program.text_constants.push(Box::default());
    edits.sort_by_key(|&(at, ..)| at);
    for (at, removed, inserted) in edits.into_iter().rev() {
        let (first, behind) = (at as usize, (at + removed) as usize);
        let line = program.lines.get(behind.saturating_sub(1)).copied().unwrap_or(0);
        program.code.splice(first..behind, inserted.iter().copied());
        let lines = std::iter::repeat_n(line, inserted.len());
        program.lines.splice(first..behind, lines);
        let count = u32::try_from(inserted.len()).unwrap_or(u32::MAX);
        let moved = |label: &mut Label| {
            if *label >= at + removed {
                *label = *label - removed + count;
            }
        };
        program.routines.iter_mut().for_each(moved);
        for instruction in &mut program.code {
            if let Instruction::Jump(label) | Instruction::JumpIfFalse(label) = instruction {
                moved(label);
            }
        }
    }
}
