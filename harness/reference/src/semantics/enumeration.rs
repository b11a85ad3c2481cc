//! Enumerations: their values, and the numbers these stand for.

use super::declare::Declarer;
use super::model::EnumeratedName;
use super::scope::NamedList;
use super::types::{DefaultValue, Enumeration, Extent, TypeId, TypeKind};
use stickler_syntax::tree::{CaseFolded, ExpressionId, ExpressionKind, Name};
use stickler_types::{Code, ElementaryType};

impl<'u> Declarer<'u, '_> {
    /// The type of `(RED, GREEN := 5, BLUE)`. A value without a number takes the one behind its neighbour's.
    pub(super) fn enumeration(
        &mut self,
        base: Option<Name<'u>>,
        values: &'u [(Name<'u>, Option<ExpressionId>)],
        name: &str,
    ) -> TypeId {
        let range = self.range_of(base);
        let bits = base.and_then(|base| self.model.source.dialect.elementary(base.text));
        let bits = bits.filter(|ty| ty.is_bit_string());
        let mut list = NamedList::new();
        let mut numbers = Vec::with_capacity(values.len());
        let mut next = Some(0_i128);
        for (value, written) in values {
            let number = written.map_or(next, |id| {
                bits.and_then(|bits| self.bits_of(id, bits))
                    .or_else(|| self.constant(id))
            });
            next = number.map(|number| number.saturating_add(1));
            let number = number.unwrap_or(0);
            if number < range.0 || number > range.1 {
                let message = format!("{number} does not lie in {}..{}", range.0, range.1);
                self.report(Code::ConstantOverflow, value.span, message);
            }
            // Numbers outside the range have just been refused.
            let number = i64::try_from(number).unwrap_or(0);
            if list.push(value.text, number) {
                numbers.push((value.text, number));
            } else {
                let message = format!("`{}` is already a value of this enumeration", value.text);
                self.report(Code::EnumTypeDeclDuplicateItem, value.span, message);
            }
        }
        let default = match numbers.first() {
            None | Some((_, 0)) => DefaultValue::Zero,
            Some((_, number)) => DefaultValue::Constant(number.cast_unsigned()),
        };
        let enumeration = Enumeration {
            name: name.into(),
            values: list,
        };
        let extent = Extent {
            default,
            ..Extent::PLAIN
        };
        let id = self
            .model
            .types
            .add(TypeKind::Enumeration(Box::new(enumeration)), extent);
        for (value, number) in numbers {
            self.enter(value, id, number);
        }
        id
    }

    /// Returns the number of a literal of the bit string that is the base of an enumeration: `BYTE#16#1E`.
    ///
    /// Basis: iec-61131-3: 6.4.4.3 of the third edition.
    fn bits_of(&self, id: ExpressionId, base: ElementaryType) -> Option<i128> {
        let ExpressionKind::Literal(literal) = &self.model.source.expression(id).kind else {
            return None;
        };
        let ty = ElementaryType::from_name(literal.prefix()?.text);
        let number = stickler_types::literal::integer(literal.text());
        number.ok().filter(|_| ty == Some(base))
    }

    /// The range that the numbers must lie in: that of the base type, or of LINT.
    fn range_of(&mut self, base: Option<Name<'u>>) -> (i128, i128) {
        const WIDEST: (i128, i128) = (i64::MIN as i128, i64::MAX as i128);
        let Some(name) = base else { return WIDEST };
        let ty = self.named(name);
        if ty == TypeId::ERROR {
            return WIDEST;
        }
        let range = self.model.elementary(ty).filter(|ty| ty.is_whole());
        match range.and_then(ElementaryType::integer_range) {
            Some((low, high)) => (low, high.min(WIDEST.1)),
            None => {
                let message = format!("`{}` is no integer type", name.text);
                self.report(Code::EnumBaseTypeNotAllowed, name.span, message);
                WIDEST
            }
        }
    }

    /// Makes a value known by its name alone: everywhere, or in the POU whose variable it is declared with.
    fn enter(&mut self, value: &'u str, ty: TypeId, number: i64) {
        let scope = match self.current {
            Some(pou) => &mut self.model.pous[pou].enumerated,
            None => &mut self.model.enumerated,
        };
        scope
            .entry(CaseFolded(value))
            .and_modify(|name| match *name {
                EnumeratedName::One(other, _) if other == ty => {}
                _ => *name = EnumeratedName::Several,
            })
            .or_insert(EnumeratedName::One(ty, number));
    }
}
