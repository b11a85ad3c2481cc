//! Fuzz target `literal`: see `stickler_generate::oracles::Target::Literal`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(Literal);
