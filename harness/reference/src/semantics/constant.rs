//! The values of constants, what names mean in constant expressions, and the type of such an expression in a dialect in which its
//! number decides of it.

use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::promotion::integer_of;
use super::types::TypeId;
use crate::conversion::implicit;
use std::sync::Arc;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::tree::{ExpressionId, ExpressionKind, Name};
use stickler_types::dialect::ConstantTypes;
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

impl Lowering<'_> {
    /// Returns the type of an operation on constants whose number the type of its operands does not hold; for untyped literals where the
    /// target does not hold it either.
    pub(super) fn constant_type(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        value: LoweredValue,
        to: TypeId,
    ) -> Option<ElementaryType> {
        if self.model.source.dialect.constant_types == ConstantTypes::OfOperands {
            return None;
        }
        let bare = &self.expression(self.model.source.bare(id)).kind;
        let (number, to) = value.constant.zip(to.elementary())?;
        if !matches!(bare, ExpressionKind::Binary { .. }) || !to.is_whole() {
            return None;
        }
        match inferred {
            Inferred::Integer(_) if self.literals_have_signs(id) => {
                least(number, true).filter(|ty| ty.bits() > to.bits())
            }
            _ => {
                let ty = inferred.elementary().filter(|&ty| !ty.holds(number))?;
                least(number, ty.is_signed())
            }
        }
    }

    /// Says that the type which a constant expression has by its number does not convert to its target.
    pub(super) fn refuses_constant(&mut self, id: ExpressionId, from: ElementaryType, to: TypeId) -> bool {
        let target = to.elementary();
        let fits = target.is_some_and(|to| implicit(from, to, self.model.source.dialect).is_some());
        if !fits {
            let message = format!(
                "the result is of {from}, and does not fit {}",
                self.model.types.name(to)
            );
            self.report(Code::ConstantExpressionOverflow, self.span(id), message);
        }
        !fits
    }

    /// Returns whether each untyped literal of an expression is by itself of a type with a sign, as 100 is a SINT, and 200 a USINT.
    fn literals_have_signs(&mut self, id: ExpressionId) -> bool {
        let Ok(parts) = self.constant_parts(id) else {
            return false;
        };
        parts.into_iter().all(|part| {
            self.literal_number(part).is_none_or(|number| {
                let bits = |is_signed| least(number, is_signed).map(ElementaryType::bits);
                bits(true).is_some() && (bits(false).is_none() || bits(true) <= bits(false))
            })
        })
    }
}

/// Returns the narrowest integer type with a sign, or without, that holds a number.
fn least(number: i128, is_signed: bool) -> Option<ElementaryType> {
    [8, 16, 32, 64]
        .map(|bits| integer_of(bits, is_signed))
        .into_iter()
        .find(|&ty| ty.holds(number))
}
