//! The stack machine that runs a checked program.

mod arithmetic;
mod comparison;
mod counting;
mod duration;
mod machine;
mod memory;
mod operations;
mod pointers;
mod power;
mod standard;
mod stop;
#[cfg(test)]
mod tests;

pub use machine::Machine;
pub use standard::{UnaryFunction, length};
pub use stop::{Inconsistency, RaisedFault, Stop};
