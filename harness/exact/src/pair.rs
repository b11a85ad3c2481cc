//! The pairs of types that have a conversion.

use stickler_types::{ElementaryType, Family};

/// Returns whether a value of one type has a meaning in the other; a type has one in itself.
///
/// Numbers in this table are integers, bit strings, reals and BOOL.
///
/// | from | to |
/// |---|---|
/// | a number, a duration, a date, a time of day, both together | all of these |
/// | a character | integers, bit strings, characters; and these convert to characters |
/// | a text | everything; and everything to a text |
///
/// Basis: ironplc-type-conversions: Explicit Conversion Functions ("for all type pairs"), as far as a pair makes sense;
/// forgeiec-conversion-functions: The naming pattern; codesys-recording: fixtures/conversions/explicit-pairs.ts.
pub(crate) const fn has_meaning(from: ElementaryType, to: ElementaryType) -> bool {
    use Family::{Character, Text};
    match (from.family(), to.family()) {
        (Text, _) | (_, Text) | (Character, Character) => true,
        (Character, _) => to.is_whole(),
        (_, Character) => from.is_whole(),
        _ => true,
    }
}
