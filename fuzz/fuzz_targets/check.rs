//! Fuzz target `check`: see `stickler_generate::oracles::FuzzTarget::Check`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Check);
