//! Fuzz target `literal`: see `stickler_generate::oracles::FuzzTarget::Literal`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Literal);
