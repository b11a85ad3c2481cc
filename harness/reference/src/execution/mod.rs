//! The stack machine that runs a checked program.

mod arithmetic;
mod comparison;
mod counting;
mod duration;
mod machine;
mod memory;
mod power;
mod standard;
mod stop;

pub use machine::Machine;
pub use stop::{Inconsistency, RaisedFault, Stop};
