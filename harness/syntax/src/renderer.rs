//! Syntax tree → source text in one spelling: names as declared, keywords in capitals, four spaces of indent, one
//! declaration a line, no comments.

mod declarations;
mod expressions;
mod names;
mod statements;
mod writer;

pub use writer::render;
