//! Source texts made smaller, by the reference's syntax tree and spans.
//!
//! A pass gives changes to the text, each of which the reference has been asked about where it matters; the search decides
//! which of them to make. Whoever wrote the text, and for which compiler: what the tree knows no name for is still lines
//! and words.
//!
//! | file | holds |
//! |---|---|
//! | `draft` | a text with the changes that can be made to it |
//! | `tree` | what the passes ask of the syntax tree |
//! | `words` | comments and words, found without a parser |
//! | `statements`, `expressions`, `values`, `declarations`, `arrays`, `chunks` | the passes |
//! | `method` | their order |

mod arrays;
mod chunks;
mod declarations;
mod draft;
mod expressions;
mod method;
mod statements;
#[cfg(test)]
mod tests;
mod tree;
mod values;
mod words;

pub use method::text;
