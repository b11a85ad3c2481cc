//! From source text to syntax tree and back.

pub mod tree;
