//! Reads `stickler.toml`: additional engines, the paths of their programs, and user-defined dialects.
//!
//! The file is found in the working directory or in a folder above, like those of other tools, so that a compiler's
//! repository configures its compiler once. Each mistake is reported with its line, and a misspelled word with the known
//! word that is most similar.
//!
//! *Architecture invariant.* This crate reads and checks the file. The engines crate decides what a description or a path
//! means, and the crates with the rules decide what an override of a dialect means.

mod engines;
mod file;

pub use engines::{EngineEntry, EngineKind};
pub use file::{ConfigurationError, ConfigurationFile, FILE_NAME};
