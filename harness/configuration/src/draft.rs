//! A dialect of `stickler.toml` while its table is read.

use std::ops::Range;
use stickler_types::{Definition, Stated};

/// A dialect whose table is being read.
pub(crate) struct Draft<'d> {
    pub(crate) definition: Definition,
    /// The source that the file cites for the overrides; it is appended to their bases.
    pub(crate) source: Option<String>,
    /// Formats a position in the file for messages.
    pub(crate) written: &'d dyn Fn(&Range<usize>) -> String,
}

impl Draft<'_> {
    /// Returns a statement that the file makes at a position, with its basis.
    pub(crate) fn stated<T>(&self, value: T, key: &str, at: &Range<usize>) -> Stated<T> {
        let place = (self.written)(at);
        let behind = self.source.as_ref().map(|source| format!("; {source}"));
        let behind = behind.unwrap_or_default();
        Stated {
            value,
            basis: format!("{}: {key} ({place}{behind})", self.definition.name),
        }
    }
}
