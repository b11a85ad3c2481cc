//! Conversions of values to texts, and of texts to values.
//!
//! No source states the form of a text, except for numbers in decimal digits; the forms here are open (rule:
//! not-stated), and the same for every implementation that Stickler describes. A text is a sequence of code units.

mod digits;
mod literal;
mod read;
mod write;

pub use read::nearest_decimal;
pub(crate) use read::read;
pub(crate) use write::write;
