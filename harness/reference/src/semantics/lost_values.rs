//! Warnings of values that may not arrive as they are: of implicit conversions, of operands that meet in another type, and of literals
//! that stand for the value of their bits.

use super::contexts::elementary_value;
use super::inferred::Inferred;
use super::literals::{real, untyped_integer};
use super::lowering::{LoweredValue, Lowering};
use super::promotion::integer_of;
use super::types::TypeId;
use crate::conversion::{implicit_warning, literal_warning};
use stickler_syntax::tree::{
    BinaryOperator, ExpressionId, ExpressionKind, Literal, LiteralKind, UnaryOperator,
};
use stickler_types::dialect::OperandTypes;
use stickler_types::{Code, ElementaryType};

impl Lowering<'_> {
    /// Warns of a value whose implicit conversion may lose something, where the dialect does.
    pub(super) fn warn_of_lost_value(&mut self, id: ExpressionId, from: TypeId, to: TypeId) {
        let dialect = self.model.source.dialect;
        let from = elementary_value(from, &self.model.types, dialect);
        let Some((from, to)) = from.zip(to.elementary()) else {
            return;
        };
        if let Some(code) = implicit_warning(from, to, dialect) {
            let message = format!("{from} converts implicitly to {to}, which may change the value");
            self.report(code, self.span(id), message);
        }
    }

    /// Warns of an untyped literal that its target does not hold, where the dialect takes it all the same.
    pub(super) fn warn_of_literal(&mut self, id: ExpressionId, value: LoweredValue, to: TypeId) {
        let dialect = self.model.source.dialect;
        let Some(to) = to.elementary().filter(|_| dialect.literals_by_width) else {
            return;
        };
        let code = match self.literal_number(id) {
            _ if value.ty == TypeId::ERROR => None,
            Some(number) => literal_warning(number, to, dialect),
            None if to == ElementaryType::Real && self.exceeds_real(id) => Some(Code::LossOfInformation),
            None => None,
        };
        if let Some(code) = code {
            let message = format!("{to} does not hold this value");
            self.report(code, self.span(id), message);
        }
    }

    /// Returns whether an expression is a real literal beyond the greatest REAL.
    fn exceeds_real(&self, id: ExpressionId) -> bool {
        let Some((literal, _)) = self.untyped_literal(id) else {
            return false;
        };
        literal.kind == LiteralKind::Real
            && real(literal, ElementaryType::Lreal).is_ok_and(|raw| f64::from_bits(raw) > f64::from(f32::MAX))
    }

    /// Warns of the operands of an infix operator whose sign may change where they meet.
    pub(super) fn warn_of_operands(
        &mut self,
        operator: BinaryOperator,
        (left, right): (ExpressionId, ExpressionId),
    ) {
        if self.model.source.dialect.operands != OperandTypes::Promoted {
            return;
        }
        let (first, second) = (self.infer(left), self.infer(right));
        let first_type = self.literal_beside(left, first, second);
        let second_type = self.literal_beside(right, second, first);
        let Some(common) = self.rules().meeting(operator, first_type, second_type) else {
            return;
        };
        for (id, operand) in [(left, first), (right, second)] {
            if let Some(from) = operand.elementary() {
                self.warn_of_lost_value(id, TypeId::of(from), TypeId::of(common));
            }
        }
    }

    /// Returns what an operand is beside another one: a literal that the other's type does not hold is of the unsigned type of that width.
    fn literal_beside(&self, id: ExpressionId, inferred: Inferred, other: Inferred) -> Inferred {
        let ty = other.elementary().filter(|&ty| ty.is_whole());
        let Some((ty, number)) = ty.zip(self.literal_number(id)) else {
            return inferred;
        };
        let unsigned = integer_of(ty.bits(), false);
        if !ty.holds(number) && unsigned.holds(number) {
            Inferred::from(unsigned)
        } else {
            inferred
        }
    }

    /// Returns the number of an untyped integer literal with the sign directly before it.
    pub(super) fn literal_number(&self, id: ExpressionId) -> Option<i128> {
        let (literal, negative) = self.untyped_literal(id)?;
        match literal.kind {
            LiteralKind::Integer | LiteralKind::BasedInteger => untyped_integer(literal.text(), negative),
            _ => None,
        }
    }

    /// Returns a literal without a type, and whether a minus sign stands before it.
    fn untyped_literal(&self, id: ExpressionId) -> Option<(&Literal<'_>, bool)> {
        let id = self.model.source.bare(id);
        let (id, negative) = match self.expression(id).kind {
            ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => (operand, true),
            _ => (id, false),
        };
        match &self.expression(id).kind {
            ExpressionKind::Literal(literal) if literal.prefix().is_none() => Some((literal, negative)),
            _ => None,
        }
    }
}
