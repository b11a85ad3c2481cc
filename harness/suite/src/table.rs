//! Reads `*.toml` files: tables that expand into a case for every cell or row × probe × value × dialect.

mod arranged;
mod cell;
mod expand_matrix;
mod expand_rows;
mod expansion;
mod inputs;
mod keys;
mod matrix;
mod probe;
mod probes;
mod read;
mod types;

pub(crate) use expansion::Budget;
pub use keys::Generate;
pub(crate) use read::read;
