//! Evaluation of expressions of the model.

use super::arithmetic::Computed;
use super::evaluator::ModelEvaluator;
use super::memory::MemoryCell;
use super::statements::DIVISION_BY_ZERO;
use super::{Evaluated, EvaluationError, OpenQuestion, arithmetic, ill_formed};
use crate::model::{BinaryOperator, Expression, ExpressionKind, Place, Type, UnaryOperator};
use stickler_types::{ElementaryType, MomentUnits, Value};

impl<'p> ModelEvaluator<'p> {
    /// Evaluates an expression.
    pub fn expression(&mut self, expression: &'p Expression) -> Evaluated<MemoryCell> {
        self.step()?;
        self.deeper(|evaluator| evaluator.of_expression_kind(expression))
    }

    fn of_expression_kind(&mut self, expression: &'p Expression) -> Evaluated<MemoryCell> {
        match &expression.kind {
            ExpressionKind::Literal(value, _) => {
                if let &Value::Plain { ty, raw } = value
                    && ty.is_duration()
                    && raw.cast_signed() < 0
                    && self.counts_moments()
                {
                    self.open(OpenQuestion::MomentRange, || value.to_string());
                }
                MemoryCell::of_value(value.clone())
            }
            ExpressionKind::Enumerated(place) => Ok(MemoryCell::Plain(*place as u64)),
            ExpressionKind::Read(place) => {
                let address = self.locate(place)?;
                self.load(&address)
            }
            ExpressionKind::Reference(place) => Ok(MemoryCell::Reference(self.locate(place)?)),
            ExpressionKind::Bit(place, bit) => self.bit(place, *bit),
            ExpressionKind::Unary(operator, operand) => self.unary(*operator, operand),
            ExpressionKind::Binary(operator, left, right) => self.binary(*operator, left, right),
            ExpressionKind::Widen(operand) => {
                let from = self.elementary(&operand.ty)?;
                let to = self.elementary(&expression.ty)?;
                let cell = self.expression(operand)?;
                self.widened(cell, from, to)
            }
            ExpressionKind::Convert(signature, operand) => {
                let from = self.elementary(&operand.ty)?;
                let cell = self.expression(operand)?;
                self.converted(signature, cell, from)
            }
            ExpressionKind::Call(function, arguments) => {
                let result = self.call(*function, arguments)?;
                Ok(self.settled(result, "as the result of a call"))
            }
            ExpressionKind::Standard(function, arguments) => self.standard(*function, arguments),
            ExpressionKind::Raw(_) => Err(EvaluationError::Raw),
        }
    }

    fn bit(&mut self, place: &'p Place, bit: u32) -> Evaluated<MemoryCell> {
        let ty = self.elementary(&place.ty)?;
        let address = self.locate(place)?;
        match self.load(&address)? {
            MemoryCell::Plain(raw) if bit < ty.bits() => Ok(MemoryCell::Plain(raw >> bit & 1)),
            _ => Err(ill_formed("a bit that the type does not have")),
        }
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &'p Expression) -> Evaluated<MemoryCell> {
        let ty = self.elementary(&operand.ty)?;
        let raw = self.plain(operand)?;
        let computed = arithmetic::unary(operator, ty, raw)
            .ok_or(ill_formed("a prefix operator on a type that does not have it"))?;
        self.computed(computed, || format!("{operator:?} of {ty}"))
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &'p Expression,
        right: &'p Expression,
    ) -> Evaluated<MemoryCell> {
        let (a, b) = (self.expression(left)?, self.expression(right)?);
        let ty = match self.resolved(&left.ty) {
            Type::Elementary(ty) => *ty,
            // Enumerated values are equal if their indices are.
            Type::Declared(_) if matches!(operator, BinaryOperator::Equal | BinaryOperator::NotEqual) => {
                ElementaryType::Ulint
            }
            _ => return Err(ill_formed("an operator on a structure or array")),
        };
        if operator.is_comparison() {
            return self.comparison(operator, ty, &a, &b);
        }
        let (MemoryCell::Plain(a), MemoryCell::Plain(b)) = (a, b) else {
            return Err(ill_formed("arithmetic with a text"));
        };
        match arithmetic::binary(operator, ty, a, b) {
            arithmetic::Binary::Computed(computed) => {
                let computed = match ty.is_duration() && self.counts_moments() {
                    true => counted(ty, computed),
                    false => computed,
                };
                self.computed(computed, || format!("{operator:?} of {ty}"))
            }
            arithmetic::Binary::DivisionByZero => Err(DIVISION_BY_ZERO),
            arithmetic::Binary::Undefined => Err(ill_formed("an operator on a type that does not have it")),
        }
    }

    /// Returns whether durations are counts without a sign, so that a sum wraps.
    fn counts_moments(&self) -> bool {
        self.program.dialect.rules().conversions.moment_units == MomentUnits::Counts
    }

    fn comparison(
        &mut self,
        operator: BinaryOperator,
        ty: ElementaryType,
        a: &MemoryCell,
        b: &MemoryCell,
    ) -> Evaluated<MemoryCell> {
        use BinaryOperator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
        let Some(order) = arithmetic::compare(ty, a, b) else {
            // NaN is neither less, nor equal, nor greater (IEC 60559).
            self.open(OpenQuestion::NotANumber, || format!("{operator:?} of {ty}"));
            return Ok(MemoryCell::Plain(u64::from(operator == NotEqual)));
        };
        let holds = match operator {
            Equal => order.is_eq(),
            NotEqual => order.is_ne(),
            Less => order.is_lt(),
            LessOrEqual => order.is_le(),
            Greater => order.is_gt(),
            GreaterOrEqual => order.is_ge(),
            _ => false,
        };
        Ok(MemoryCell::Plain(u64::from(holds)))
    }

    /// Returns the cell of a computed value, and records its question.
    pub fn computed(
        &mut self,
        computed: arithmetic::Computed,
        what: impl FnOnce() -> String,
    ) -> Evaluated<MemoryCell> {
        if let Some(question) = computed.question {
            self.open(question, what);
        }
        Ok(MemoryCell::Plain(computed.raw))
    }
}

/// Stores a duration in the count of its type: a TIME in 32 bits of milliseconds. What an LTIME below zero is, is open.
///
/// Basis: codesys-recording: recordings/codesys.run.json; see [`MomentUnits::Counts`].
fn counted(ty: ElementaryType, computed: Computed) -> Computed {
    const MILLISECOND: i64 = 1_000_000;
    let nanoseconds = computed.raw.cast_signed();
    match ty {
        ElementaryType::Time => Computed {
            raw: ((nanoseconds / MILLISECOND).rem_euclid(1 << 32) * MILLISECOND).cast_unsigned(),
            ..computed
        },
        _ if nanoseconds < 0 => Computed {
            question: Some(OpenQuestion::MomentRange),
            ..computed
        },
        _ => computed,
    }
}
