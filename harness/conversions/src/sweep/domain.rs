//! The inputs of a sweep: all values of a type, or chosen and sampled ones.

mod choose;
mod operands;
mod texts;

pub use choose::{Domain, Sampling};
pub use operands::{Operands, TextOperands};
