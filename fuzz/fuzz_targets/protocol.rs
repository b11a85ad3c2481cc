//! Fuzz target `protocol`: see `stickler_generate::oracles::FuzzTarget::Protocol`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Protocol);
