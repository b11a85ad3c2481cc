//! The types that values of different types have in common.
//!
//! Basis: rule: mixed-operands (if one converts implicitly to the other, it does; no third type is sought);
//! rule: literal-as-operand (one takes the other's type).

use super::contexts::{Fit, ValueContext, fit};
use super::inferred::Inferred;
use super::pointer_types::fits_pointer;
use super::types::{TypeId, TypeTable};
use crate::conversion::{common_operand, of_operand};
use stickler_types::{Dialect, ElementaryType};

/// The rules of types in a text: the table of types and the dialect.
#[derive(Clone, Copy)]
pub(super) struct TypeRules<'a> {
    pub(super) types: &'a TypeTable,
    pub(super) dialect: &'a Dialect,
}

impl TypeRules<'_> {
    /// Returns what two untyped numbers are together; [`Inferred::Error`] where they do not go together.
    pub(super) fn untyped(self, left: Inferred, right: Inferred) -> Inferred {
        match (left, right) {
            (Inferred::Integer(left), Inferred::Integer(right)) => Inferred::Integer(left.max(right)),
            (Inferred::Real, Inferred::Real) => Inferred::Real,
            _ if self.dialect.integer_literal_as_real => Inferred::Real,
            _ => Inferred::Error,
        }
    }

    /// Returns the type that both operands take: the one's, if the other converts to it.
    pub(super) fn common(self, left: Inferred, right: Inferred) -> Option<TypeId> {
        match (left, right) {
            (Inferred::Known(left), Inferred::Known(right)) => self.common_of_known(left, right),
            (Inferred::Known(ty), other) | (other, Inferred::Known(ty)) => self.fits(other, ty).then_some(ty),
            (Inferred::Integer(left), Inferred::Integer(right)) => Some(TypeId::of(left.max(right).ty())),
            (Inferred::Real | Inferred::Integer(_), Inferred::Real | Inferred::Integer(_)) => {
                let real = TypeId::of(ElementaryType::Lreal);
                (self.fits(left, real) && self.fits(right, real)).then_some(real)
            }
            (Inferred::Text { wide, .. }, Inferred::Text { wide: other, .. }) => {
                (wide == other).then_some(TypeId::of(if wide {
                    ElementaryType::Wstring
                } else {
                    ElementaryType::String
                }))
            }
            _ => None,
        }
    }

    /// Returns the type that several values, none of which is an error, have in common: the one of theirs to which the
    /// others convert. What does not go with the others is left out of account, and is to be found by
    /// [`Self::goes_with`]; untyped values that do not go together give an error.
    pub(super) fn common_of_all(self, values: &[Inferred]) -> Inferred {
        let known = values
            .iter()
            .copied()
            .find(|value| matches!(value, Inferred::Known(_)));
        let values = values.iter().copied();
        match known {
            Some(known) => values.fold(known, |common, value| match self.unite(common, value) {
                Inferred::Error => common,
                united => united,
            }),
            None => values
                .reduce(|left, right| self.unite(left, right))
                .unwrap_or(Inferred::Error),
        }
    }

    /// Returns whether a value goes with others that have a type in common.
    pub(super) fn goes_with(self, value: Inferred, common: TypeId) -> bool {
        fit(
            value,
            common,
            ValueContext::CommonArgument,
            self.types,
            self.dialect,
        ) == Fit::Yes
    }

    fn unite(self, left: Inferred, right: Inferred) -> Inferred {
        match (left, right) {
            (Inferred::Enumerated, Inferred::Enumerated) => Inferred::Enumerated,
            (
                Inferred::Text { wide, single },
                Inferred::Text {
                    wide: other,
                    single: too,
                },
            ) if wide == other => Inferred::Text {
                wide,
                single: single && too,
            },
            _ if left.is_untyped_number() && right.is_untyped_number() => self.untyped(left, right),
            _ => self.common(left, right).map_or(Inferred::Error, Inferred::Known),
        }
    }

    /// Returns the type that two values of known types take.
    pub(super) fn common_of_known(self, left: TypeId, right: TypeId) -> Option<TypeId> {
        if left == right {
            return Some(left);
        }
        if self.types.pointer(left).and(self.types.pointer(right)).is_some() {
            let other = if left == TypeId::ADDRESS { right } else { left };
            return fits_pointer(left, right, self.types, self.dialect).then_some(other);
        }
        let (from, to) = (left.elementary()?, right.elementary()?);
        let rightward = of_operand(from, to, self.dialect).is_some();
        let leftward = of_operand(to, from, self.dialect).is_some();
        match (leftward, rightward) {
            (true, false) => Some(left),
            (false, true) => Some(right),
            (true, true) if common_operand(from, to, self.dialect) == from => Some(left),
            (true, true) => Some(right),
            (false, false) => None,
        }
    }

    fn fits(self, value: Inferred, ty: TypeId) -> bool {
        fit(value, ty, ValueContext::Operand, self.types, self.dialect) == Fit::Yes
    }
}

/// Returns the type that an untyped expression takes: the one that is wanted, where such an expression can have it, and
/// else the default.
pub(super) fn settle(untyped: Inferred, wanted: Option<TypeId>) -> Option<ElementaryType> {
    let wanted = wanted.and_then(TypeId::elementary);
    match untyped {
        Inferred::Integer(magnitude) => {
            let takes = |ty: &ElementaryType| ty.integer_range().is_some() || ty.is_real();
            Some(wanted.filter(takes).unwrap_or(magnitude.ty()))
        }
        Inferred::Real => Some(wanted.filter(|ty| ty.is_real()).unwrap_or(ElementaryType::Lreal)),
        _ => None,
    }
}
