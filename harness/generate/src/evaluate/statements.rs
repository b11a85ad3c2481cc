//! Execution of statements by the evaluator.

use super::cell::MemoryCell;
use super::evaluator::{Activation, ModelEvaluator};
use super::{EvaluationError, OpenQuestion, ill_formed};
use crate::model::{
    AssignmentTarget, CaseBranch, CaseLabel, Expression, ExpressionKind, ForLoop, Place, Statement, Type,
};
use stickler_types::{ElementaryType, Fault};

/// The way in which a list of statements ended.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    /// The list was executed to its end.
    Next,
    /// EXIT ended it, which ends the innermost loop.
    Exit,
    /// RETURN ended it, which ends the unit.
    Return,
}

impl<'p> ModelEvaluator<'p> {
    /// Executes statements in their order.
    pub fn statements(
        &mut self,
        unit: Activation<'p>,
        statements: &'p [Statement],
    ) -> Result<Flow, EvaluationError> {
        for statement in statements {
            let flow = self.statement(unit, statement)?;
            if flow != Flow::Next {
                return Ok(flow);
            }
        }
        Ok(Flow::Next)
    }

    fn statement(&mut self, unit: Activation<'p>, statement: &'p Statement) -> Result<Flow, EvaluationError> {
        self.step()?;
        self.deeper(|evaluator| evaluator.of_kind(unit, statement))
    }

    fn of_kind(&mut self, unit: Activation<'p>, kind: &'p Statement) -> Result<Flow, EvaluationError> {
        match kind {
            Statement::Assign(target, value) => self.assignment(unit, target, value),
            Statement::If(branches, otherwise) => {
                for (condition, body) in branches {
                    if self.condition(unit, condition)? {
                        return self.statements(unit, body);
                    }
                }
                self.statements(unit, otherwise.as_deref().unwrap_or_default())
            }
            Statement::Case(selector, branches, otherwise) => {
                let selector = self.selector(unit, selector)?;
                for branch in branches {
                    if self.is_chosen(unit, branch, selector)? {
                        return self.statements(unit, &branch.body);
                    }
                }
                self.statements(unit, otherwise.as_deref().unwrap_or_default())
            }
            Statement::For(parts) => self.counted(unit, parts),
            Statement::While(condition, body) => {
                while self.condition(unit, condition)? {
                    match self.turn(unit, body)? {
                        Flow::Next => {}
                        Flow::Exit => break,
                        Flow::Return => return Ok(Flow::Return),
                    }
                }
                Ok(Flow::Next)
            }
            Statement::Repeat(body, until) => loop {
                match self.turn(unit, body)? {
                    Flow::Next => {}
                    Flow::Exit => break Ok(Flow::Next),
                    Flow::Return => break Ok(Flow::Return),
                }
                if self.condition(unit, until)? {
                    break Ok(Flow::Next);
                }
            },
            Statement::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                self.invoke(unit, *instance, inputs, outputs)?;
                Ok(Flow::Next)
            }
            Statement::Exit => Ok(Flow::Exit),
            Statement::Return => Ok(Flow::Return),
            Statement::Raw(_) => Err(EvaluationError::Raw),
        }
    }

    /// Executes one iteration of a loop; an empty body counts as a step.
    fn turn(&mut self, unit: Activation<'p>, body: &'p [Statement]) -> Result<Flow, EvaluationError> {
        self.step()?;
        self.statements(unit, body)
    }

    fn condition(
        &mut self,
        unit: Activation<'p>,
        condition: &'p Expression,
    ) -> Result<bool, EvaluationError> {
        Ok(self.plain(unit, condition)? != 0)
    }

    fn assignment(
        &mut self,
        unit: Activation<'p>,
        target: &'p AssignmentTarget,
        value: &'p Expression,
    ) -> Result<Flow, EvaluationError> {
        match target {
            AssignmentTarget::Place(place) => {
                let address = self.locate(unit, place)?;
                self.assign(unit, address, &place.ty, value)?;
            }
            AssignmentTarget::Bit(place, bit) => {
                let set = self.condition(unit, value)?;
                self.set_bit(unit, place, *bit, set)?;
            }
            AssignmentTarget::Result => {
                let (address, ty) = unit.result.ok_or(ill_formed("a result outside a function"))?;
                self.assign(unit, address, ty, value)?;
            }
        }
        Ok(Flow::Next)
    }

    /// Evaluates an expression into the cells from an address on.
    pub fn assign(
        &mut self,
        unit: Activation<'p>,
        address: usize,
        ty: &'p Type,
        value: &'p Expression,
    ) -> Result<(), EvaluationError> {
        if self.layout.size(ty)? == 1 {
            let cell = self.expression(unit, value)?;
            return self.store(address, cell);
        }
        let cells = self.cells(unit, value)?;
        let into = self.memory.get_mut(address..address + cells.len());
        into.ok_or(ill_formed("a place outside the memory"))?
            .clone_from_slice(&cells);
        Ok(())
    }

    /// Writes one bit of an integer or bit string, and leaves the others unchanged.
    ///
    /// Basis: ironplc-bit-access: Syntax (0 is the least significant bit).
    fn set_bit(
        &mut self,
        unit: Activation<'p>,
        place: &'p Place,
        bit: u32,
        set: bool,
    ) -> Result<(), EvaluationError> {
        let ty = self.elementary(&place.ty)?;
        let address = self.locate(unit, place)?;
        let MemoryCell::Plain(raw) = self.load(unit, address)? else {
            return Err(ill_formed("a bit of a text"));
        };
        if bit >= ty.bits() {
            return Err(ill_formed("a bit that the type does not have"));
        }
        let number = if set { raw | 1 << bit } else { raw & !(1 << bit) };
        self.store(address, MemoryCell::Plain(ty.wrap(i128::from(number))))
    }

    /// Evaluates the selector of a CASE: an integer, or the index of an enumerated value.
    fn selector(&mut self, unit: Activation<'p>, selector: &'p Expression) -> Result<i128, EvaluationError> {
        let raw = self.plain(unit, selector)?;
        Ok(match self.resolved(&selector.ty) {
            Type::Elementary(ty) => ty.integer_value(raw),
            _ => i128::from(raw),
        })
    }

    fn is_chosen(
        &mut self,
        unit: Activation<'p>,
        branch: &'p CaseBranch,
        selector: i128,
    ) -> Result<bool, EvaluationError> {
        for label in &branch.labels {
            let chosen = match label {
                CaseLabel::One(value) => self.selector(unit, value)? == selector,
                CaseLabel::Range(low, high) => {
                    (self.selector(unit, low)?..=self.selector(unit, high)?).contains(&selector)
                }
            };
            if chosen {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Executes a FOR loop: it ends when the limit has been passed, even where the type ends there. No document states which
    /// value the variable holds then; after EXIT and RETURN it holds the value of that iteration.
    ///
    /// Basis: iec-61131-3: 7.3.3.4.2.
    fn counted(&mut self, unit: Activation<'p>, parts: &'p ForLoop) -> Result<Flow, EvaluationError> {
        let (address, ty) = self.variable(unit, parts.variable)?;
        let ty = self.elementary(ty)?;
        let mut value = self.integer(unit, &parts.from)?;
        let to = self.integer(unit, &parts.to)?;
        let by = match &parts.by {
            Some(by) => self.integer(unit, by)?,
            None => 1,
        };
        if by == 0 {
            return Err(ill_formed("a FOR loop by 0"));
        }
        while if by > 0 { value <= to } else { value >= to } {
            if !holds(ty, value) {
                self.open(OpenQuestion::LoopVariable, unit, || {
                    format!("{value} does not fit {ty}")
                });
                break;
            }
            let raw = ty.wrap(value);
            self.store(address, MemoryCell::Plain(raw))?;
            match self.turn(unit, &parts.body)? {
                Flow::Next => {}
                Flow::Exit => return Ok(Flow::Next),
                Flow::Return => return Ok(Flow::Return),
            }
            self.check_unchanged(unit, parts, address, raw, to)?;
            value += by;
        }
        self.store(
            address,
            MemoryCell::Unsettled(ty.wrap(value), OpenQuestion::LoopVariable),
        )?;
        Ok(Flow::Next)
    }

    /// Raises a question if an iteration has changed the variable of its loop or the value of its limit, because systems
    /// differ in whether they read them again.
    fn check_unchanged(
        &mut self,
        unit: Activation<'p>,
        parts: &'p ForLoop,
        address: usize,
        raw: u64,
        to: i128,
    ) -> Result<(), EvaluationError> {
        let changed = self.memory.get(address) != Some(&MemoryCell::Plain(raw))
            || (!is_literal(&parts.to) && self.integer(unit, &parts.to)? != to);
        if changed {
            self.open(OpenQuestion::LoopChanged, unit, || {
                "in the body of the loop".to_owned()
            });
        }
        Ok(())
    }

    /// Evaluates an integer expression.
    pub fn integer(
        &mut self,
        unit: Activation<'p>,
        expression: &'p Expression,
    ) -> Result<i128, EvaluationError> {
        let ty = self.elementary(&expression.ty)?;
        Ok(ty.integer_value(self.plain(unit, expression)?))
    }

    /// Evaluates an expression that is no text to its raw form.
    pub fn plain(
        &mut self,
        unit: Activation<'p>,
        expression: &'p Expression,
    ) -> Result<u64, EvaluationError> {
        match self.expression(unit, expression)? {
            MemoryCell::Plain(raw) => Ok(raw),
            _ => Err(ill_formed("a text where a number stands")),
        }
    }
}

fn is_literal(expression: &Expression) -> bool {
    matches!(expression.kind, ExpressionKind::Literal(..))
}

fn holds(ty: ElementaryType, value: i128) -> bool {
    ty.integer_range()
        .is_some_and(|(least, greatest)| (least..=greatest).contains(&value))
}

/// The error of a division by zero.
pub(super) const DIVISION_BY_ZERO: EvaluationError = EvaluationError::Fault(Fault::DivisionByZero);
