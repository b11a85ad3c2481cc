//! The syntax of Structured Text: source text → tokens → syntax tree → source text, one step a file, for everything that
//! reads, changes, compares or renders a program.
//!
//! Nothing here fails: each step gives its result and the diagnostics that came up on the way.
//!
//! | what | where |
//! |---|---|
//! | the tree of a text | [`parse`], [`tree`] |
//! | a walk over a tree, with the context of each part | [`visitor`] |
//! | the names that a text declares and uses | [`names`] |
//! | the words and signs of a text, also of one that no dialect parses | [`tokens`], [`words`] |
//! | the features of the language that a text uses | [`features`] |
//! | the parts by which several programs are joined to one, and their names | [`ProgramParts`], [`Renaming`] |
//! | a text with some of its parts replaced | [`Edits`] |
//! | a text in its one normal spelling | [`render`] |
//! | bytes that may be no text | [`decoding`] |
//! | places in a text, lines and columns | [`source`] |
//! | errors with their places | [`diagnostic`] |
//!
//! Architecture Invariant: this crate knows no types of values, no files, no cases and no engines; of a
//! [`Dialect`](stickler_types::Dialect) it asks only which words and signs the language has.

pub mod decoding;
pub mod diagnostic;
mod edits;
pub mod features;
mod keyword;
mod lexer;
pub mod names;
mod namespaces;
mod parser;
mod parts;
mod qualifiers;
mod renderer;
pub mod source;
#[cfg(test)]
mod syntax_tests;
pub mod token;
pub mod tree;
pub mod visitor;

pub use edits::{Edits, Renaming};
pub use namespaces::{Meaning, NamespaceId, Namespaces};
pub use parser::{MAX_NESTING, parse};
pub use parts::{DeclaredSection, Indivisible, ProgramParts};
pub use qualifiers::resolve_qualifiers;
pub use renderer::render;
pub use token::{Tokens, last_token, tokens, words};
