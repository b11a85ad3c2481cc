//! Operands that are promoted: the types in which a dialect computes with integers and bit strings, and those that results have
//! for the checker.
//!
//! Basis: rule: mixed-operands; the pages of the systems that promote operands, which the files of the dialects name.

use super::common::TypeRules;
use super::inferred::Inferred;
use super::operators::{Action, TypedOperation};
use super::types::TypeId;
use stickler_syntax::tree::UnaryOperator;
use stickler_types::dialect::{OperandTypes, ResultSigns};
use stickler_types::{Dialect, ElementaryType};

impl TypeRules<'_> {
    /// Returns the types in which a dialect that promotes operands computes with two integers or bit strings, one of which may be an
    /// untyped literal, which then takes the sign of the other.
    pub(super) fn promoted(self, left: Inferred, right: Inferred) -> Option<PromotedOperands> {
        (self.dialect.operands == OperandTypes::Promoted)
            .then(|| self.promoted_of(&[left, right]))
            .flatten()
    }

    /// Returns the types in which integers and bit strings are computed that a function takes, where it computes them as operators do; `None` where
    /// one of them is something else, or all are untyped literals.
    pub(super) fn promoted_arguments(self, arguments: &[Inferred]) -> Option<PromotedOperands> {
        let promoted = self
            .dialect
            .functions_promote
            .then(|| self.promoted_of(arguments))
            .flatten()?;
        // Arguments of one type give that type.
        let same = arguments
            .iter()
            .copied()
            .reduce(|first, next| match first == next {
                true => first,
                false => Inferred::Error,
            });
        Some(PromotedOperands {
            result: same.and_then(Inferred::elementary).unwrap_or(promoted.result),
            ..promoted
        })
    }

    fn promoted_of(self, operands: &[Inferred]) -> Option<PromotedOperands> {
        let (mut bits, mut literal, mut unsigned, mut is_signed) = (0, 0, 0, false);
        for operand in operands {
            match (operand, operand.elementary()) {
                (Inferred::Integer(magnitude), _) => literal = magnitude.ty().bits().max(literal),
                (_, Some(ty)) if ty.is_whole() => {
                    bits = ty.bits().max(bits);
                    is_signed |= ty.is_signed();
                    if !ty.is_signed() {
                        unsigned = ty.bits().max(unsigned);
                    }
                }
                _ => return None,
            }
        }
        (bits > 0).then(|| PromotedOperands {
            result: integer_of(bits, is_signed),
            computed: integer_of(bits.max(literal).max(32), is_signed),
            gives_up_sign: self.dialect.result_signs == ResultSigns::OfOperator && unsigned == bits,
        })
    }
}

/// The types of an operation on promoted operands.
#[derive(Clone, Copy)]
pub(super) struct PromotedOperands {
    /// The type that the operation has for the checker.
    pub(super) result: ElementaryType,
    /// The type in which it is computed.
    pub(super) computed: ElementaryType,
    /// Whether the result has no sign where bits are combined.
    gives_up_sign: bool,
}

impl PromotedOperands {
    /// Returns the types for an operation on bits.
    pub(super) fn bits(self) -> PromotedOperands {
        let is_signed = self.result.is_signed() && !self.gives_up_sign;
        PromotedOperands {
            result: integer_of(self.result.bits(), is_signed),
            ..self
        }
    }

    pub(super) fn of_numbers(self, action: Action) -> TypedOperation {
        self.operation(action, TypeId::of(self.computed), TypeId::of(self.result))
    }

    pub(super) fn operation(self, action: Action, computed: TypeId, result: TypeId) -> TypedOperation {
        let operand = TypeId::of(self.computed);
        TypedOperation {
            left: operand,
            right: operand,
            action,
            computed,
            result,
        }
    }
}

/// Returns the integer type with a sign or without.
pub(super) const fn integer_of(bits: u32, is_signed: bool) -> ElementaryType {
    use ElementaryType::{Dint, Int, Lint, Sint, Udint, Uint, Ulint, Usint};
    match (bits, is_signed) {
        (..=8, true) => Sint,
        (..=8, false) => Usint,
        (9..=16, true) => Int,
        (9..=16, false) => Uint,
        (17..=32, true) => Dint,
        (17..=32, false) => Udint,
        (_, true) => Lint,
        (_, false) => Ulint,
    }
}

/// Returns the type in which a dialect that promotes operands computes with one integer or bit string.
pub(super) const fn promoted(ty: ElementaryType) -> ElementaryType {
    let bits = if ty.bits() < 32 { 32 } else { ty.bits() };
    integer_of(bits, ty.is_signed())
}

/// Returns the type that the value of a prefix operator has for the checker.
pub(super) fn prefixed(operator: UnaryOperator, ty: ElementaryType, dialect: &Dialect) -> ElementaryType {
    let is_changed = dialect.result_signs == ResultSigns::OfOperator && ty.is_whole();
    match operator {
        UnaryOperator::Negate if is_changed => integer_of(ty.bits().max(16), true),
        UnaryOperator::Not if is_changed && ty.is_integer() => integer_of(ty.bits(), false),
        _ => ty,
    }
}
