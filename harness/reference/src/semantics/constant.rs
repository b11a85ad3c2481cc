//! The values of constants, and what names mean in constant expressions.

use std::sync::Arc;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::tree::Name;
use stickler_types::{Code, ElementaryType};

/// The value of a constant of an elementary type.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum ConstantValue {
    /// The type and raw form.
    Plain(ElementaryType, u64),
    /// The type and code units of a text.
    Text(ElementaryType, Arc<[u16]>),
}

impl ConstantValue {
    /// Returns the type.
    pub(super) const fn ty(&self) -> ElementaryType {
        match self {
            ConstantValue::Plain(ty, _) | ConstantValue::Text(ty, _) => *ty,
        }
    }

    /// Returns the number of an integer.
    pub(super) fn number(&self) -> Option<i128> {
        match self {
            ConstantValue::Plain(ty, raw) if ty.is_integer() => Some(ty.integer_value(*raw)),
            _ => None,
        }
    }

    /// Returns what a variable that takes so many code units keeps of the value.
    pub(super) fn cut(self, capacity: u32) -> ConstantValue {
        match self {
            ConstantValue::Text(ty, units) if units.len() > capacity as usize => {
                ConstantValue::Text(ty, units[..capacity as usize].into())
            }
            value => value,
        }
    }
}

/// The meaning of a name, or of an initial value, in a constant expression.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Constant {
    /// A constant with this value; of a text a short one, lest each use of a long one cost much.
    Known(ConstantValue),
    /// A constant whose value only the running program knows, or that is of no elementary type.
    Computed,
    /// A constant whose own value is wrong, which has been reported.
    Silent,
    /// A constant without a value.
    Missing,
    /// A variable.
    Variable,
    /// The name is not declared.
    Unknown,
}

impl Constant {
    /// Returns whether the value is known.
    pub(super) const fn is_known(&self) -> bool {
        matches!(self, Constant::Known(_))
    }

    /// Returns why `name`, which means this, stands for no integer; `None` where that has been reported.
    pub(super) fn refusal(&self, name: Name<'_>) -> Option<SpannedDiagnostic> {
        let (code, message) = match self {
            Constant::Silent => return None,
            Constant::Variable => (
                Code::VariableMustBeConst,
                "is a variable; a constant is needed here",
            ),
            Constant::Known(_) | Constant::Computed => (
                Code::ConstantNotIntegerType,
                "is no constant of an integer type with a value that is known here",
            ),
            Constant::Missing => (Code::ConstantMissingInitializer, "is a constant without a value"),
            Constant::Unknown => (Code::UndefinedConstantReference, "is not declared"),
        };
        Some(SpannedDiagnostic::new(
            code,
            name.span,
            format!("`{}` {message}", name.text),
        ))
    }
}
