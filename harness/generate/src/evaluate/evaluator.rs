//! The state of an evaluation and its course: start, scans, and the values at the end.

use super::cell::MemoryCell;
use super::layout::{Layout, Offsets};
use super::{Evaluation, EvaluationError, OpenPoint, OpenQuestion, ill_formed};
use crate::model::{Program, Type, Variable};
use std::rc::Rc;
use stickler_types::ElementaryType;

/// The maximum number of statements and expressions that an evaluation executes, its start included.
pub const MAX_STEPS: u64 = 1_000_000;

/// The maximum nesting of calls, statements and operators.
const MAX_DEPTH: u32 = 400;

/// Evaluates a program for a number of scans, by the documents.
///
/// Accepts any model, well-formed or not, and any number of scans; 0 scans give the initial values.
///
/// # Errors
/// An [`EvaluationError`]: the program stops with a fault, takes too long, or is ill-formed.
///
/// Basis: rule: integer-overflow-wraps; iec-61131-3: 6.6 and 7.3 (calls and statements); `stickler_exact` for
/// conversions.
pub fn evaluate(program: &Program, scans: u32) -> Result<Evaluation, EvaluationError> {
    let layout = Layout::new(program)?;
    let mut evaluator = ModelEvaluator {
        program,
        layout: &layout,
        memory: Vec::with_capacity(layout.main.size + 64),
        images: vec![None; program.functions.len()],
        opened: Vec::new(),
        steps: 0,
        depth: 0,
    };
    let main = Activation {
        name: "main",
        variables: &program.main.variables,
        offsets: &layout.main,
        base: 0,
        result: None,
    };
    evaluator.start(main)?;
    for _ in 0..scans {
        evaluator.statements(main, &program.main.body)?;
    }
    let values = evaluator.values(main)?;
    Ok(Evaluation {
        values,
        opened: evaluator.opened,
        steps: evaluator.steps,
    })
}

/// The state of an evaluation.
pub(super) struct ModelEvaluator<'p> {
    pub program: &'p Program,
    pub layout: &'p Layout,
    /// The variables of the main program with their instances, followed by those of the functions under execution.
    pub memory: Vec<MemoryCell>,
    /// The initial cells of each function, once it has been called.
    pub images: Vec<Option<Rc<[MemoryCell]>>>,
    pub opened: Vec<OpenPoint>,
    pub steps: u64,
    pub depth: u32,
}

/// One activation of a program organization unit: its variables and their place in memory.
#[derive(Clone, Copy)]
pub(super) struct Activation<'p> {
    pub name: &'p str,
    pub variables: &'p [Variable],
    pub offsets: &'p Offsets,
    /// The first cell of the unit.
    pub base: usize,
    /// The first cell and the type of the result of a function.
    pub result: Option<(usize, &'p Type)>,
}

impl<'p> ModelEvaluator<'p> {
    /// Counts one statement or expression.
    ///
    /// # Errors
    /// [`EvaluationError::StepLimit`] beyond [`MAX_STEPS`].
    pub fn step(&mut self) -> Result<(), EvaluationError> {
        self.steps += 1;
        if self.steps > MAX_STEPS {
            return Err(EvaluationError::StepLimit);
        }
        Ok(())
    }

    /// Runs a step that may nest further; refuses beyond [`MAX_DEPTH`] levels.
    pub fn deeper<T>(
        &mut self,
        inside: impl FnOnce(&mut Self) -> Result<T, EvaluationError>,
    ) -> Result<T, EvaluationError> {
        if self.depth >= MAX_DEPTH {
            return Err(ill_formed("a program nested too deeply"));
        }
        self.depth += 1;
        let result = inside(self);
        self.depth -= 1;
        result
    }

    /// Records a question that no document answers; each question is recorded once.
    pub fn open(&mut self, question: OpenQuestion, unit: Activation<'_>, what: impl FnOnce() -> String) {
        if self.opened.iter().all(|opened| opened.question != question) {
            self.opened.push(OpenPoint {
                question,
                at: format!("{}: {}", unit.name, what()),
            });
        }
    }

    /// Returns the type that an alias stands for; any other type itself.
    pub fn resolved(&self, ty: &'p Type) -> &'p Type {
        self.program.unaliased(ty)
    }

    /// Returns the elementary type that a type is or stands for.
    pub fn elementary(&self, ty: &'p Type) -> Result<ElementaryType, EvaluationError> {
        match self.resolved(ty) {
            Type::Elementary(elementary) => Ok(*elementary),
            _ => Err(ill_formed("an operation on something that is not elementary")),
        }
    }
}
