//! Fuzz target `differential`: see `stickler_generate::oracles::FuzzTarget::Differential`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Differential);
