//! `stickler.toml`: which engines there are besides those that Stickler knows, and where their programs are; which dialects there
//! are besides those of documented systems.
//!
//! The file stands in the working directory or in a folder above, as those of other tools do, so that a compiler's
//! repository names its compiler once. Each mistake in it is told with its line, and a word that is nearly one of those
//! that are known with that one.
//!
//! *Architecture invariant.* This crate reads and checks the file; what a description or a place means is decided where
//! engines are made, and what a dialect overrides means, where the rules are.
#![forbid(unsafe_code)]

mod dialects;
mod engines;
mod error;
mod file;
mod near;
mod override_tables;
mod table;

pub use engines::{Entry, Kind};
pub use error::ConfigurationError;
pub use file::{Configuration, FILE_NAME};
pub use near::{list, nearest};
