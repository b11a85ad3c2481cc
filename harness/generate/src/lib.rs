//! Random well-typed programs, their variants, and what a fuzz target holds against what it is given.
//!
//! Architecture Invariant: this crate knows neither libFuzzer nor files nor threads. What is random comes from bytes.
#![forbid(unsafe_code)]

mod dialect;
pub mod evaluate;
pub mod features;
pub mod generator;
pub mod model;
pub mod oracles;
pub mod plant;
pub mod random;
pub mod reduce;
pub mod variants;
pub mod writer;
