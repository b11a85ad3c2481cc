//! Errors in reading `stickler.toml`.

use std::io;
use std::path::PathBuf;

/// The error of a configuration file that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ConfigurationError {
    /// The file cannot be read.
    #[error("cannot read {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// The contents of the file are wrong.
    #[error("{}:{line}:{column}: {message}", path.display())]
    Mistake {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column, from 1, in Unicode scalar values.
        column: usize,
        /// A description of the mistake and of what to do, as a sentence without its full stop.
        message: String,
    },
}
