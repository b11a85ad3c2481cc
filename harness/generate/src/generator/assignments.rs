//! Assignments to variables, parts of variables, and bits.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::operations::has_bits;
use super::scope::contains_text;
use crate::model::{
    AssignmentTarget, BinaryOperator, Expression, ExpressionKind, Place, Statement, Type, VariableId,
};
use stickler_types::{ElementaryType, Family};

impl ProgramBuilder<'_, '_> {
    /// Generates an assignment to any writable place.
    pub fn assignment(&mut self) -> Option<Statement> {
        let place = self.target(|_| true)?;
        let ty = place.ty.clone();
        if self.random.chance(1, 3)
            && let Some(value) = self.accumulated(&place)
        {
            return Some(Statement::Assign(AssignmentTarget::Place(place), value));
        }
        let mut value = self.assigned(&ty, place.variable.0)?;
        // An assignment of a variable to itself shows nothing.
        if matches!(&value.kind, ExpressionKind::Read(read) if *read == place) {
            value = self.assigned(&ty, place.variable.0)?;
        }
        self.pou.hold(place.variable, &value);
        Some(Statement::Assign(AssignmentTarget::Place(place), value))
    }

    /// Generates the value of a place combined with another value, so that earlier assignments are not lost.
    fn accumulated(&mut self, place: &Place) -> Option<Expression> {
        let Type::Elementary(ty) = place.ty else {
            return None;
        };
        let operator = match ty.family() {
            Family::Signed | Family::Unsigned | Family::Real if self.has(Construct::Arithmetic) => {
                [BinaryOperator::Add, BinaryOperator::Subtract][self.random.below(2)]
            }
            Family::Boolean | Family::BitString if self.has(Construct::Logic) => BinaryOperator::Xor,
            _ => return None,
        };
        let held = Expression::read(place.clone());
        let added = self.value(ty, TypeContext::Operand, self.deepest - 1);
        Some(Expression::binary(operator, held, added, ty))
    }

    /// Generates a value for a place of type `ty` in a variable; `None` if there is no such value.
    pub fn assigned(&mut self, ty: &Type, variable: usize) -> Option<Expression> {
        if contains_text(ty, &self.program) {
            self.text_bound = VariableId(variable);
        }
        if let Type::Elementary(ty) = ty {
            return Some(self.value(*ty, TypeContext::Assigned, self.deepest));
        }
        if self.program.enumerated_values(ty).is_some() {
            let called = if self.random.chance(1, 4) {
                self.call(ty, 1)
            } else {
                None
            };
            return Some(called.unwrap_or_else(|| self.enumerated(ty)));
        }
        self.read(ty, false)
    }

    /// Generates an assignment to a bit.
    pub fn assigned_bit(&mut self) -> Option<Statement> {
        let place = self.target(has_bits)?;
        let bit = self.bit_number(&place.ty);
        let value = self.value(ElementaryType::Bool, TypeContext::Assigned, self.deepest);
        Some(Statement::Assign(AssignmentTarget::Bit(place, bit), value))
    }
}
