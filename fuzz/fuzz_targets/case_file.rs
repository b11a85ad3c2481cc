//! Fuzz target `case_file`: see `stickler_generate::oracles::FuzzTarget::CaseFile`.
#![cfg_attr(fuzzing, no_main)]
stickler_fuzz::target!(CaseFile);
