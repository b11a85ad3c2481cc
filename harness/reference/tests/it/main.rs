//! The reference from the outside, in one program: each of its own would be linked once more.

mod conversion_properties;
mod programs;
mod registry;
mod syntax_mutations;
