//! Assignments to variables, parts of variables, and bits.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::operations::has_bits;
use super::scope::{VisiblePlace, contains_text};
use crate::model::{
    AssignmentTarget, BinaryOperator, Expression, ExpressionKind, PathStep, Place, Statement, Type,
    VariableId, VariableSection,
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

    /// Generates a reference to a writable place of this type, outside instances of function blocks.
    fn reference(&mut self, to: &Type) -> Option<Expression> {
        let may_be_part = !self.lacks("reference-to-part");
        let suits = |seen: &VisiblePlace| {
            let is_output = |step: &PathStep| matches!(step, PathStep::Output(_));
            let is_there = seen.path.is_empty() || may_be_part;
            seen.ty == *to
                && seen.writable
                && is_there
                && !seen.path.iter().any(is_output)
                && !seen.is_followed()
        };
        let seen = self.choose(suits)?;
        Some(Expression::new(
            Type::Reference(Box::new(to.clone())),
            ExpressionKind::Reference(self.place(&seen, true)),
        ))
    }

    /// Declares references of main, and generates the statements that let them lead to something.
    pub fn references(&mut self) -> Vec<Statement> {
        let mut bound = Vec::new();
        if self.has(Construct::References) && self.program.reference_words().is_some() {
            for _ in 0..=self.random.below(2) {
                let to = match self.any_type() {
                    ty if ty.is_text() => continue,
                    ty => Type::Elementary(ty),
                };
                let Some(value) = self.reference(&to) else {
                    continue;
                };
                let ty = value.ty.clone();
                let reference = self.declare_variable("r", ty.clone(), VariableSection::Local, None);
                let target = AssignmentTarget::Place(Place::whole(reference, ty));
                bound.push(Statement::Assign(target, value));
            }
        }
        bound
    }

    /// Generates a value for a place of type `ty` in a variable; `None` if there is no such value.
    pub fn assigned(&mut self, ty: &Type, variable: usize) -> Option<Expression> {
        if contains_text(ty, &self.program) {
            self.text_bound = VariableId(variable);
        }
        if let Type::Reference(to) = ty {
            return self.reference(to);
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
