//! The generator from the outside, in one program: each of its own would be linked once more.

mod execute;
mod generator;
mod telling;
mod writer;
