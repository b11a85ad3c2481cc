//! Tests of the generator from the outside, in one program, because each program of its own would be linked once more.

mod execute;
mod generator;
mod mutations;
mod operands;
mod telling;
mod writer;
