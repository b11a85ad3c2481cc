//! Fuzz target `parse`: see `stickler_generate::oracles::FuzzTarget::Parse`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Parse);
