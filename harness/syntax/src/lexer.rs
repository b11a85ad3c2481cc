//! Text → tokens. Nothing is copied: a token is a kind and a span. Comments, pragmas and whitespace are
//! skipped; what cannot be read becomes a token of its own, about which the parser keeps silent, and a
//! diagnostic.

mod class;
mod number;
mod quoted;
mod scan;
mod trivia;
mod typed;

#[cfg(test)]
mod tests;

pub(super) use scan::{Lexer, lex};
