//! The syntax of Structured Text: source text → tokens → syntax tree → source text, one step a file, for everything that
//! reads, changes, compares or renders a program.
//!
//! Nothing here fails: each step gives its result and the diagnostics that came up on the way.
//!
//! | what | where |
//! |---|---|
//! | the tree of a text | [`parse`], [`tree`] |
//! | a text in its one normal spelling | [`render`] |
//! | bytes that may be no text | [`decoding`] |
//! | places in a text, lines and columns | [`source`] |
//! | errors with their places | [`diagnostic`] |
//!
//! Architecture Invariant: this crate knows no types of values, no files, no cases and no engines; of a
//! [`Dialect`](stickler_types::Dialect) it asks only which words and signs the language has.

pub mod decoding;
pub mod diagnostic;
mod ending;
mod keyword;
mod lexer;
mod parser;
mod renderer;
pub mod source;
mod token;
pub mod tree;

pub use ending::last_token;
pub use parser::{MAX_NESTING, parse};
pub use renderer::render;
