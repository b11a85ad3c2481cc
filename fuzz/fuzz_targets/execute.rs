//! Fuzz target `execute`: see `stickler_generate::oracles::Target::Execute`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Execute);
