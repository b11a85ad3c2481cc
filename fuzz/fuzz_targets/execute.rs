//! Fuzz target `execute`: see `stickler_generate::oracles::FuzzTarget::Execute`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Execute);
