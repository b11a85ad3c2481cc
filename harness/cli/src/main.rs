//! The conformance suite and fuzzer for IEC 61131-3 Structured Text.

fn main() {}
