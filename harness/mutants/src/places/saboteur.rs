//! Saboteurs: engines that are the reference but for one claim, which they break in one place; and the changes to what the reference made of a
//! program by which they do so.

use super::analysis::Analysis;
use super::claim::Rule;
use super::site::{Site, sites};
use std::fmt;
use stickler_engines::{ClosureEngine, Outcome, RunRequest, Session};
use stickler_reference::instruction::{Instruction, Label, MachineProgram};
use stickler_reference::{self as reference, Limits};
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ExpressionId, ExpressionKind};
use stickler_types::{Code, Diagnostic, Dialect, DialectName, ElementaryType};

/// A rule that is broken in one place and kept everywhere else.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Saboteur {
    /// The rule.
    pub rule: Rule,
    /// The place.
    pub place: BrokenPlace,
}

/// The place in which a saboteur breaks its rule.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum BrokenPlace {
    /// The origin of a value.
    Source(&'static str),
    /// The destination of a value.
    Target(&'static str),
    /// The statement or body around.
    Surrounding(&'static str),
    /// One pair of types in one target.
    Cell(ElementaryType, ElementaryType, &'static str),
    /// One bit of one type.
    Bit(ElementaryType, u64),
}

impl Saboteur {
    /// Returns the saboteurs that break a rule at a site.
    pub fn of(site: &Site) -> impl Iterator<Item = Saboteur> {
        let rule = site.rule;
        let standing = site.standing;
        let places = [
            standing.source.map(BrokenPlace::Source),
            standing.target.map(BrokenPlace::Target),
            standing.surrounding.map(BrokenPlace::Surrounding),
            site.pair
                .zip(standing.target)
                .map(|((from, to), target)| BrokenPlace::Cell(from, to, target)),
            site.bit.map(|(of, index)| BrokenPlace::Bit(of, index)),
        ];
        places
            .into_iter()
            .flatten()
            .map(move |place| Saboteur { rule, place })
    }

    /// Returns the changes that the saboteur makes at sites of a program.
    fn changes(self, sites: &[Site]) -> Vec<&SourceChange> {
        let broken = |site: &&Site| Saboteur::of(site).any(|saboteur| saboteur == self);
        sites.iter().filter(broken).map(|site| &site.change).collect()
    }
}

impl fmt::Display for Saboteur {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} in {}", self.rule, self.place)
    }
}

impl fmt::Display for BrokenPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BrokenPlace::Source(name) => write!(f, "source.{name}"),
            BrokenPlace::Target(name) => write!(f, "target.{name}"),
            BrokenPlace::Surrounding(name) => write!(f, "surrounding.{name}"),
            BrokenPlace::Cell(from, to, target) => {
                write!(f, "target.{target} from {} to {}", from.name(), to.name())
            }
            BrokenPlace::Bit(of, index) => write!(f, "{}.{index}", of.name()),
        }
    }
}

impl Saboteur {
    /// Returns the reference with the claim of the saboteur broken in its place.
    pub fn engine(self) -> ClosureEngine<'static> {
        let mut engine = ClosureEngine::new(&self.to_string(), move |reference, request| {
            self.run(reference, request)
        });
        engine.render = Some(Box::new(move |dialect, source| self.render(dialect, source)));
        engine
    }

    /// Returns a program with the changes of the saboteur; `None` where it changes nothing.
    fn sabotaged(self, source: &str, dialect: DialectName, rendered: bool) -> Option<Analysis<'_>> {
        let mut analysis = Analysis::new(source, Dialect::of(dialect));
        let sites = sites(&analysis, rendered);
        let changes = self.changes(&sites);
        if changes.is_empty() {
            return None;
        }
        apply(&mut analysis, changes);
        Some(analysis)
    }

    fn run(self, unchanged: &mut dyn Session, request: &RunRequest<'_>) -> Outcome {
        let Some(analysis) = self.sabotaged(request.source, request.dialect, false) else {
            return unchanged.run(request);
        };
        if analysis.is_rejected() {
            return Outcome::rejected(located(analysis));
        }
        let outcome = match &analysis.program {
            Some(program) => reference::execute(program, request, Limits::default()),
            None => Ok(Outcome::ACCEPTED),
        };
        match outcome {
            Ok(outcome) => outcome.with_warnings(located(analysis)),
            Err(error) => Outcome::Error {
                message: error.to_string(),
            },
        }
    }

    fn render(self, dialect: DialectName, source: &str) -> Outcome {
        let rendered = match self.sabotaged(source, dialect, true) {
            Some(analysis) if !analysis.is_rejected() => Ok(stickler_syntax::render(&analysis.unit, source)),
            Some(analysis) if self.rule.refuses_rendering() => Err(located(analysis)),
            _ => reference::render(source, dialect),
        };
        match rendered {
            Ok(text) => Outcome::Rendered { text },
            Err(diagnostics) => Outcome::Rejected { diagnostics },
        }
    }
}

fn located(analysis: Analysis<'_>) -> Vec<Diagnostic> {
    reference::locate(analysis.diagnostics, analysis.source, &analysis.lines)
}

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
