//! Reads `*.toml` files: tables that expand into a case for every cell or row × probe × value × dialect.

mod arranged;
mod budget;
mod cell;
mod expand_matrix;
mod expand_rows;
mod expansion;
mod inputs;
mod key_reader;
mod keys;
mod matrix;
mod neighbours;
mod probe;
mod probes;
mod read;
mod section;
mod types;
mod word;

pub(crate) use budget::Budget;
pub use keys::Generate;
pub(crate) use read::read;
