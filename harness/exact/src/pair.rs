//! The pairs of types that have a conversion.

use stickler_types::{ElementaryType, Family, MomentUnits};

/// Returns whether a value of one type has a meaning in the other; a type has one in itself.
///
/// Numbers in this table are integers, bit strings, reals and BOOL.
///
/// | from | to |
/// |---|---|
/// | a number | numbers, durations, dates, times of day, both together |
/// | a duration | numbers, durations, times of day |
/// | a time of day | numbers, durations, times of day |
/// | a date | numbers, dates, dates with a time |
/// | a date and time | numbers, dates, times of day, dates with a time |
/// | a character | integers, bit strings, characters; and these convert to characters |
/// | a text | everything; and everything to a text |
///
/// Where each type counts its own units, each duration, date and time of day has a meaning in each.
///
/// Basis: ironplc-type-conversions: Explicit Conversion Functions ("for all type pairs"), as far as a pair makes sense;
/// forgeiec-conversion-functions: The naming pattern; codesys-recording: fixtures/conversions/explicit-pairs.ts.
pub(crate) const fn has_meaning(from: ElementaryType, to: ElementaryType, units: MomentUnits) -> bool {
    use Family::{Boolean, Character, Date, DateAndTime, Duration, Real, Text, TimeOfDay};
    match (from.family(), to.family()) {
        (Text, _) | (_, Text) | (Character, Character) => true,
        (Character, Boolean | Real) | (Boolean | Real, Character) => false,
        (Character, _) => is_number(to),
        (_, Character) => is_number(from),
        (Duration | TimeOfDay, Date | DateAndTime)
        | (Date, Duration | TimeOfDay)
        | (DateAndTime, Duration) => {
            matches!(units, MomentUnits::Counts)
        }
        _ => true,
    }
}

/// Returns whether the type is an integer, a bit string, a real or BOOL.
pub(crate) const fn is_number(ty: ElementaryType) -> bool {
    matches!(
        ty.family(),
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Real
    )
}
