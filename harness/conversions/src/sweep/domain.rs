//! The inputs of a sweep.

mod choose;
mod operands;
mod sample;
mod texts;

pub use choose::{Domain, Sampling};
pub use operands::{Operands, Texts};
