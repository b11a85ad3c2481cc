//! The operands at which conversions go wrong, by family.

pub mod edges;
pub mod integers;
pub mod moments;
pub mod reals;
pub mod texts;
