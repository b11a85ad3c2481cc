//! Values of constants whose type is known.

use crate::conversion::Conversion;
use std::sync::Arc;
use stickler_types::ElementaryType;

/// The value of a constant of an elementary type.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in super::super) enum Known {
    /// Its type and raw form.
    Plain(ElementaryType, u64),
    /// Its type and code units.
    Text(ElementaryType, Arc<[u16]>),
}

impl Known {
    /// Its type.
    pub(in super::super) const fn ty(&self) -> ElementaryType {
        match self {
            Known::Plain(ty, _) | Known::Text(ty, _) => *ty,
        }
    }

    /// The number of an integer.
    pub(in super::super) fn number(&self) -> Option<i128> {
        match self {
            Known::Plain(ty, raw) if ty.is_integer() => Some(ty.integer_value(*raw)),
            _ => None,
        }
    }

    /// What is left of it in a variable that takes so many code units.
    pub(in super::super) fn cut(self, capacity: u32) -> Known {
        match self {
            Known::Text(ty, units) if units.len() > capacity as usize => {
                Known::Text(ty, units[..capacity as usize].into())
            }
            known => known,
        }
    }

    /// The result of a conversion, as the machine computes it.
    pub(super) fn converted(&self, conversion: Conversion) -> Known {
        let to = conversion.to;
        match (self, to.is_text()) {
            (Known::Plain(_, raw), false) => Known::Plain(to, conversion.apply(*raw)),
            (Known::Plain(_, raw), true) => Known::Text(to, conversion.apply_to_text(*raw).into()),
            (Known::Text(_, units), false) => Known::Plain(to, conversion.apply_from_text(units)),
            (Known::Text(_, units), true) => Known::Text(to, conversion.text_to_text(units).into()),
        }
    }
}
