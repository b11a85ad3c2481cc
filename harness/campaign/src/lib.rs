//! Fuzz campaigns without libFuzzer: programs from a seed, engines side by side, findings that are kept.
#![forbid(unsafe_code)]
