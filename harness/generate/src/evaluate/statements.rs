//! Execution of statements by the evaluator.

use super::evaluator::ModelEvaluator;
use super::memory::MemoryCell;
use super::{Evaluated, EvaluationError, OpenQuestion, ill_formed};
use crate::model::{
    AssignmentTarget, CaseBranch, CaseLabel, Expression, ExpressionKind, ForLoop, Place, Statement, Type,
};
use stickler_types::Fault;

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
    pub fn statements(&mut self, statements: &'p [Statement]) -> Evaluated<Flow> {
        for statement in statements {
            let flow = self.statement(statement)?;
            if flow != Flow::Next {
                return Ok(flow);
            }
        }
        Ok(Flow::Next)
    }

    fn statement(&mut self, statement: &'p Statement) -> Evaluated<Flow> {
        self.step()?;
        self.deeper(|evaluator| evaluator.of_kind(statement))
    }

    fn of_kind(&mut self, kind: &'p Statement) -> Evaluated<Flow> {
        match kind {
            Statement::Assign(target, value) => self.assignment(target, value),
            Statement::If(branches, otherwise) => {
                for (condition, body) in branches {
                    if self.condition(condition)? {
                        return self.statements(body);
                    }
                }
                self.statements(otherwise.as_deref().unwrap_or_default())
            }
            Statement::Case(selector, branches, otherwise) => {
                let selector = self.selector(selector)?;
                for branch in branches {
                    if self.is_chosen(branch, selector)? {
                        return self.statements(&branch.body);
                    }
                }
                self.statements(otherwise.as_deref().unwrap_or_default())
            }
            Statement::For(parts) => self.counted(parts),
            Statement::While(condition, body) => {
                while self.condition(condition)? {
                    match self.turn(body)? {
                        Flow::Next => {}
                        Flow::Exit => break,
                        Flow::Return => return Ok(Flow::Return),
                    }
                }
                Ok(Flow::Next)
            }
            Statement::Repeat(body, until) => loop {
                match self.turn(body)? {
                    Flow::Next => {}
                    Flow::Exit => break Ok(Flow::Next),
                    Flow::Return => break Ok(Flow::Return),
                }
                if self.condition(until)? {
                    break Ok(Flow::Next);
                }
            },
            Statement::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                self.invoke(*instance, inputs, outputs)?;
                Ok(Flow::Next)
            }
            Statement::Exit => Ok(Flow::Exit),
            Statement::Return => Ok(Flow::Return),
            Statement::Raw(_) => Err(EvaluationError::Raw),
        }
    }

    /// Executes one iteration of a loop; an empty body counts as a step.
    fn turn(&mut self, body: &'p [Statement]) -> Evaluated<Flow> {
        self.step()?;
        self.statements(body)
    }

    fn condition(&mut self, condition: &'p Expression) -> Evaluated<bool> {
        Ok(self.plain(condition)? != 0)
    }

    fn assignment(&mut self, target: &'p AssignmentTarget, value: &'p Expression) -> Evaluated<Flow> {
        match target {
            AssignmentTarget::Place(place) => {
                let address = self.locate(place)?;
                let value = self.expression(value)?;
                self.store(&address, value)?;
            }
            AssignmentTarget::Bit(place, bit) => {
                let set = self.condition(value)?;
                self.set_bit(place, *bit, set)?;
            }
            AssignmentTarget::Result => {
                if self.unit.pou.result.is_none() {
                    return Err(ill_formed("a result outside a function"));
                }
                let value = self.expression(value)?;
                self.store(&self.unit.part(self.unit.pou.variables.len()), value)?;
            }
        }
        Ok(Flow::Next)
    }

    /// Writes one bit of an integer or bit string, and leaves the others unchanged.
    ///
    /// Basis: ironplc-bit-access: Syntax (0 is the least significant bit).
    fn set_bit(&mut self, place: &'p Place, bit: u32, set: bool) -> Evaluated<()> {
        let ty = self.elementary(&place.ty)?;
        let address = self.locate(place)?;
        let MemoryCell::Plain(raw) = self.load(&address)? else {
            return Err(ill_formed("a bit of a text"));
        };
        if bit >= ty.bits() {
            return Err(ill_formed("a bit that the type does not have"));
        }
        let number = if set { raw | 1 << bit } else { raw & !(1 << bit) };
        self.store(&address, MemoryCell::Plain(ty.wrap(i128::from(number))))
    }

    /// Evaluates the selector of a CASE: an integer, or the index of an enumerated value.
    fn selector(&mut self, selector: &'p Expression) -> Evaluated<i128> {
        let raw = self.plain(selector)?;
        Ok(match self.resolved(&selector.ty) {
            Type::Elementary(ty) => ty.integer_value(raw),
            _ => i128::from(raw),
        })
    }

    fn is_chosen(&mut self, branch: &'p CaseBranch, selector: i128) -> Evaluated<bool> {
        for label in &branch.labels {
            let chosen = match label {
                CaseLabel::One(value) => self.selector(value)? == selector,
                CaseLabel::Range(low, high) => {
                    (self.selector(low)?..=self.selector(high)?).contains(&selector)
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
    fn counted(&mut self, parts: &'p ForLoop) -> Evaluated<Flow> {
        let (address, ty) = self.variable(parts.variable)?;
        let ty = self.elementary(ty)?;
        let mut value = self.integer(&parts.from)?;
        let to = self.integer(&parts.to)?;
        let by = match &parts.by {
            Some(by) => self.integer(by)?,
            None => 1,
        };
        if by == 0 {
            return Err(ill_formed("a FOR loop by 0"));
        }
        while if by > 0 { value <= to } else { value >= to } {
            if !ty.holds(value) {
                self.open(OpenQuestion::LoopVariable, || {
                    format!("{value} does not fit {ty}")
                });
                break;
            }
            let raw = ty.wrap(value);
            self.store(&address, MemoryCell::Plain(raw))?;
            match self.turn(&parts.body)? {
                Flow::Next => {}
                Flow::Exit => return Ok(Flow::Next),
                Flow::Return => return Ok(Flow::Return),
            }
            self.check_unchanged(parts, &address, raw, to)?;
            value += by;
        }
        self.store(
            &address,
            MemoryCell::Unsettled(ty.wrap(value), OpenQuestion::LoopVariable),
        )?;
        Ok(Flow::Next)
    }

    /// Raises a question if an iteration has changed the variable of its loop or the value of its limit, because systems
    /// differ in whether they read them again.
    fn check_unchanged(
        &mut self,
        parts: &'p ForLoop,
        address: &[usize],
        raw: u64,
        to: i128,
    ) -> Evaluated<()> {
        let changed = *self.at(address)? != MemoryCell::Plain(raw)
            || (!is_literal(&parts.to) && self.integer(&parts.to)? != to);
        if changed {
            self.open(OpenQuestion::LoopChanged, || "in the body of the loop".to_owned());
        }
        Ok(())
    }

    /// Evaluates an integer expression.
    pub fn integer(&mut self, expression: &'p Expression) -> Evaluated<i128> {
        let ty = self.elementary(&expression.ty)?;
        Ok(ty.integer_value(self.plain(expression)?))
    }

    /// Evaluates an expression that is no text to its raw form.
    pub fn plain(&mut self, expression: &'p Expression) -> Evaluated<u64> {
        match self.expression(expression)? {
            MemoryCell::Plain(raw) => Ok(raw),
            _ => Err(ill_formed("a text where a number stands")),
        }
    }
}

fn is_literal(expression: &Expression) -> bool {
    matches!(expression.kind, ExpressionKind::Literal(..))
}

/// The error of a division by zero.
pub(super) const DIVISION_BY_ZERO: EvaluationError = EvaluationError::Fault(Fault::DivisionByZero);
