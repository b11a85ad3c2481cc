//! The state of an evaluation and its course: start, scans, and the values at the end.

use super::memory::{Address, MemoryCell};
use super::{Evaluated, Evaluation, EvaluationError, OpenPoint, OpenQuestion, ill_formed};
use crate::model::{Pou, Program, Type};
use stickler_types::ElementaryType;

/// The maximum number of statements and expressions that an evaluation executes, its start included.
pub const MAX_STEPS: u64 = 1_000_000;

/// The time that passes from one scan to the next, in nanoseconds.
pub const CYCLE: i64 = 4_000_000;

/// The maximum nesting of calls, statements and operators.
const MAX_DEPTH: u32 = 400;

/// Evaluates a program for a number of scans, by the documents; from one to the next passes a [`CYCLE`].
///
/// Accepts any model, well-formed or not, and any number of scans; 0 scans give the initial values.
///
/// # Errors
/// An [`EvaluationError`]: the program stops with a fault, takes too long, or is ill-formed.
///
/// Basis: rule: integer-overflow-wraps; iec-61131-3: 6.6 and 7.3 (calls and statements); `stickler_exact` for
/// conversions.
pub fn evaluate(program: &Program, scans: u32) -> Evaluated<Evaluation> {
    let mut evaluator = ModelEvaluator {
        program,
        memory: vec![MemoryCell::Plain(0)],
        images: vec![None; program.functions.len()],
        opened: Vec::new(),
        steps: 0,
        depth: 0,
        clock: 0,
        unit: Activation {
            pou: &program.main,
            at: vec![0],
        },
    };
    evaluator.start()?;
    for scan in 0..scans {
        evaluator.clock = i64::from(scan) * CYCLE;
        evaluator.statements(&program.main.body)?;
    }
    let values = evaluator.values()?;
    Ok(Evaluation {
        values,
        opened: evaluator.opened,
        steps: evaluator.steps,
    })
}

/// The state of an evaluation.
pub(super) struct ModelEvaluator<'p> {
    pub program: &'p Program,
    /// The variables of the main program with their instances, followed by those of the functions under execution.
    pub memory: Vec<MemoryCell>,
    /// The initial variables of each function, once it has been called.
    pub images: Vec<Option<MemoryCell>>,
    pub opened: Vec<OpenPoint>,
    pub steps: u64,
    pub depth: u32,
    /// The time since the start, in nanoseconds.
    pub clock: i64,
    /// The unit under execution.
    pub unit: Activation<'p>,
}

/// One activation of a program organization unit: its variables and their place in memory.
#[derive(Clone)]
pub(super) struct Activation<'p> {
    pub pou: &'p Pou,
    /// The place of the variables of the unit, and of the result of a function.
    pub at: Address,
}

impl Activation<'_> {
    /// Returns the place of a variable; behind the variables of a function stands its result.
    pub fn part(&self, number: usize) -> Address {
        [&self.at[..], &[number]].concat()
    }
}

impl<'p> ModelEvaluator<'p> {
    /// Counts one statement or expression.
    ///
    /// # Errors
    /// [`EvaluationError::StepLimit`] beyond [`MAX_STEPS`].
    pub fn step(&mut self) -> Evaluated<()> {
        self.steps += 1;
        if self.steps > MAX_STEPS {
            return Err(EvaluationError::StepLimit);
        }
        Ok(())
    }

    /// Runs a step that may nest further; refuses beyond [`MAX_DEPTH`] levels.
    pub fn deeper<T>(&mut self, inside: impl FnOnce(&mut Self) -> Evaluated<T>) -> Evaluated<T> {
        if self.depth >= MAX_DEPTH {
            return Err(ill_formed("a program nested too deeply"));
        }
        self.depth += 1;
        let result = inside(self);
        self.depth -= 1;
        result
    }

    /// Runs a step in another unit than the one under execution.
    pub fn within<T>(
        &mut self,
        unit: Activation<'p>,
        inside: impl FnOnce(&mut Self) -> Evaluated<T>,
    ) -> Evaluated<T> {
        let outer = std::mem::replace(&mut self.unit, unit);
        let result = inside(self);
        self.unit = outer;
        result
    }

    /// Returns an activation of a function block, whose variables are at this place.
    pub fn instance(&self, block: usize, at: Address) -> Evaluated<Activation<'p>> {
        let missing = ill_formed("an instance of an undeclared function block");
        let pou = self.program.blocks.get(block).ok_or(missing)?;
        Ok(Activation { pou, at })
    }

    /// Records a question that no document answers; each question is recorded once.
    pub fn open(&mut self, question: OpenQuestion, what: impl FnOnce() -> String) {
        if self.opened.iter().all(|opened| opened.question != question) {
            self.opened.push(OpenPoint {
                question,
                at: format!("{}: {}", self.unit.pou.name, what()),
            });
        }
    }

    /// Returns the type that an alias stands for; any other type itself.
    pub fn resolved(&self, ty: &'p Type) -> &'p Type {
        self.program.unaliased(ty)
    }

    /// Returns the elementary type that a type is or stands for.
    pub fn elementary(&self, ty: &'p Type) -> Evaluated<ElementaryType> {
        match self.resolved(ty) {
            Type::Elementary(elementary) => Ok(*elementary),
            _ => Err(ill_formed("an operation on something that is not elementary")),
        }
    }
}
