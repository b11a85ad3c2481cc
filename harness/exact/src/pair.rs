//! Which pairs of types have a conversion.

use stickler_types::{ElementaryType, Family};

/// Whether a value of one type has a meaning in the other; a type has one in itself.
///
/// Basis: ironplc-type-conversions: Explicit Conversion Functions ("for all type pairs"), as far as a pair makes sense: a
/// character is a number or a text, but neither true or false nor a duration or a date; and a day has no time of day.
pub(crate) const fn has_meaning(from: ElementaryType, to: ElementaryType) -> bool {
    is_number(from) && is_number(to)
}

const fn is_number(ty: ElementaryType) -> bool {
    matches!(
        ty.family(),
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Real
    )
}
