//! What a fuzz target holds against the bytes that it is given: one file an oracle, and [`Target`], which names them all.

pub mod differential;
pub mod execute;
mod failure;
mod parse;
mod target;
mod tree;
mod words;

pub use failure::{Failure, Tried};
pub use target::Target;
