//! Tokens → syntax tree: recursive descent, one function a production, named after it. Parsing never fails: what
//! cannot be read is diagnosed once, where a person would look for it, and left out of the tree.

mod blocks;
mod configuration;
mod cursor;
mod declarations;
mod expressions;
mod initializers;
mod namespaces;
mod objects;
mod partial_access;
mod paths;
mod recovery;
mod state;
mod statements;
mod types;
mod unsupported;
mod variables;

pub use state::{MAX_NESTING, parse};
