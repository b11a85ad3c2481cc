//! The type of an expression before its surroundings are looked at.

use super::types::TypeId;
use stickler_types::ElementaryType;

/// The knowledge of an expression's type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Inferred {
    /// An expression that was not inferred yet.
    Pending,
    /// Something is wrong with the expression. Lowering it says what; nothing else is said about it.
    Error,
    /// A call that gives no value.
    Nothing,
    /// A type as [`super::types::TypeTable::value_type`] gives it.
    Known(TypeId),
    /// Made of untyped integer literals only.
    Integer(Magnitude),
    /// Made of untyped literals, a real one among them.
    Real,
    /// A text literal; of one character if `single`, which a character type takes too.
    Text { wide: bool, single: bool },
    /// The name of a value of more than one enumeration.
    Enumerated,
}

impl Inferred {
    /// The known elementary type.
    pub(super) fn elementary(self) -> Option<ElementaryType> {
        match self {
            Inferred::Known(ty) => ty.elementary(),
            _ => None,
        }
    }

    /// A literal expression that takes its type from its surroundings.
    pub(super) fn is_untyped_number(self) -> bool {
        matches!(self, Inferred::Integer(_) | Inferred::Real)
    }
}

impl From<ElementaryType> for Inferred {
    fn from(ty: ElementaryType) -> Inferred {
        Inferred::Known(TypeId::of(ty))
    }
}

/// The type that untyped integers take where nothing else gives them one: the first that holds them all.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Magnitude {
    Dint,
    Lint,
    Ulint,
}

impl Magnitude {
    /// The least that holds a number.
    pub(super) fn of(value: i128) -> Magnitude {
        if i32::try_from(value).is_ok() {
            Magnitude::Dint
        } else if i64::try_from(value).is_ok() {
            Magnitude::Lint
        } else {
            Magnitude::Ulint
        }
    }

    /// The type.
    pub(super) fn ty(self) -> ElementaryType {
        match self {
            Magnitude::Dint => ElementaryType::Dint,
            Magnitude::Lint => ElementaryType::Lint,
            Magnitude::Ulint => ElementaryType::Ulint,
        }
    }
}
