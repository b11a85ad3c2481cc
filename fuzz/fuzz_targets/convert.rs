//! Fuzz target `convert`: see `stickler_generate::oracles::FuzzTarget::Convert`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Convert);
