//! The type of a constant expression in a dialect in which its number decides of it.

use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::promotion::integer_of;
use super::types::TypeId;
use crate::conversion::implicit;
use stickler_syntax::tree::{ExpressionId, ExpressionKind};
use stickler_types::dialect::ConstantTypes;
use stickler_types::{Code, ElementaryType};

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
