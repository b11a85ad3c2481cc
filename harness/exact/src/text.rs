//! Values as texts, and texts as values.
//!
//! No source says which form a text has, numbers in decimal digits aside; what stands here is by stickler-design: §8 open, and
//! the same for every implementation that Stickler describes. A text is a row of code units.

mod digits;
mod literal;
mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;
