//! The choices of each dialect in the points in which systems convert differently.

use stickler_types::{ConversionChoices, Dialect, DialectName};

/// Returns the conversion choices of a dialect, as its file states them.
///
/// Choices that no dialect makes describe dialects of the future, and serve to recognize the rules that a foreign compiler
/// follows.
#[must_use]
pub fn choices_of(dialect: DialectName) -> ConversionChoices {
    Dialect::of(dialect).conversions
}
