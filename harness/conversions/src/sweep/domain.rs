//! Which inputs a sweep goes through.

mod choose;
mod neighbours;
mod operands;
mod sample;
mod texts;

pub use choose::{Domain, Sampling};
pub use neighbours::Detail;
pub use operands::{Operands, Texts};
