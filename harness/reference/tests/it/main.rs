//! The reference from the outside, in one program: each of its own would be linked once more.

mod conversion_properties;
mod dialects;
mod programs;
mod registry;
mod syntax_mutations;
