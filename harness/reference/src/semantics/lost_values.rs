//! Warnings of values that may not arrive as they are: of implicit conversions, of operands that meet in another type, and of literals
//! that stand for the value of their bits.

use super::inferred::Inferred;
use super::literals::untyped_integer;
use super::lowering::{LoweredValue, Lowering};
use super::operators::{integer_of, is_whole, prefixed};
use super::types::TypeId;
use crate::conversion::{implicit_warning, literal_warning};
use crate::dialect::OperandTypes;
use crate::syntax::tree::{BinaryOperator, ExpressionId, ExpressionKind, LiteralKind, UnaryOperator};
use stickler_types::ElementaryType;

impl Lowering<'_> {
    /// Warns of a value whose implicit conversion may lose something, where the dialect does.
    pub(super) fn warn_of_lost_value(&mut self, id: ExpressionId, from: TypeId, to: TypeId) {
        let Some((from, to)) = from.elementary().zip(to.elementary()) else {
            return;
        };
        if let Some(code) = implicit_warning(from, to, self.model.source.dialect) {
            let message = format!("{from} converts implicitly to {to}, which may change the value");
            self.report(code, self.span(id), message);
        }
    }

    /// Warns of an untyped literal that stands for the value of its bits, where the dialect does.
    pub(super) fn warn_of_literal(&mut self, id: ExpressionId, value: LoweredValue, to: TypeId) {
        let Some((number, to)) = self.literal_number(id).zip(to.elementary()) else {
            return;
        };
        if value.ty == TypeId::ERROR {
            return;
        }
        if let Some(code) = literal_warning(number, to, self.model.source.dialect) {
            let message = format!("{to} does not hold {number}, and takes the value that has its bits");
            self.report(code, self.span(id), message);
        }
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

    /// Warns of the operand of a prefix operator whose sign may change.
    pub(super) fn warn_of_operand(
        &mut self,
        operator: UnaryOperator,
        operand: ExpressionId,
        ty: ElementaryType,
    ) {
        let result = prefixed(operator, ty, self.model.source.dialect);
        self.warn_of_lost_value(operand, TypeId::of(ty), TypeId::of(result));
    }

    /// Returns what an operand is beside another one: a literal that the other's type does not hold is of the unsigned type of that width.
    fn literal_beside(&self, id: ExpressionId, inferred: Inferred, other: Inferred) -> Inferred {
        let ty = other.elementary().filter(|&ty| is_whole(ty));
        let Some((ty, number)) = ty.zip(self.literal_number(id)) else {
            return inferred;
        };
        let unsigned = integer_of(ty.bits(), false);
        if !holds(ty, number) && holds(unsigned, number) {
            Inferred::from(unsigned)
        } else {
            inferred
        }
    }

    /// Returns the number of an untyped integer literal with the sign directly before it.
    fn literal_number(&self, id: ExpressionId) -> Option<i128> {
        let (id, negative) = match self.expression(self.model.source.bare(id)).kind {
            ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => (operand, true),
            _ => (self.model.source.bare(id), false),
        };
        match &self.expression(id).kind {
            ExpressionKind::Literal(literal)
                if literal.prefix().is_none()
                    && matches!(literal.kind, LiteralKind::Integer | LiteralKind::BasedInteger) =>
            {
                untyped_integer(literal.text(), negative)
            }
            _ => None,
        }
    }
}

/// Returns whether an integer or bit string has a value of this number.
fn holds(ty: ElementaryType, number: i128) -> bool {
    ty.integer_range()
        .is_some_and(|(low, high)| (low..=high).contains(&number))
}
