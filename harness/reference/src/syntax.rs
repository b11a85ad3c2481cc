//! Source text → tokens → syntax tree → source text, one step a file. Nothing here fails: each step gives its
//! result and the diagnostics that came up on the way.

mod ending;
mod keyword;
mod lexer;
mod parser;
mod renderer;
mod token;
pub mod tree;

pub use ending::last_token;
pub use parser::{MAX_NESTING, parse};
pub use renderer::render;
