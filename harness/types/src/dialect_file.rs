//! Reads what a dialect's file states: `conformance-cases/dialects/NAME.toml` of a documented system, and the tables `[dialects.NAME]`
//! of `stickler.toml`, which have the same keys.

mod definitions;
mod documented;
mod draft;
mod override_tables;
mod table;

pub use crate::near::{advice, list, nearest};
pub use definitions::definitions;
pub(crate) use documented::documented;
pub use documented::{DialectFile, read_documented};
pub use table::{ConfigurationMistake, mistake, read, table, text};
