//! A dialect while its table is read.

use crate::{Dialect, ElementaryType};
use std::ops::Range;

/// Formats a position in the file for messages.
pub(crate) type Written<'w> = &'w dyn Fn(&Range<usize>) -> String;

/// A dialect whose table is being read.
pub(crate) struct Draft<'d> {
    pub(crate) dialect: Dialect,
    /// The source that the file cites for the overrides; it is appended to their bases.
    pub(crate) source: Option<String>,
    /// Formats a position in the file for the basis of a statement; `None` where documents are the basis.
    pub(crate) written: Option<Written<'d>>,
    /// Returns whether a conversion function for a pair of types exists, in a dialect that has all types.
    pub(crate) converts: fn(ElementaryType, ElementaryType) -> bool,
}

impl Draft<'_> {
    /// Returns the basis of a statement that the file makes at a position.
    pub(crate) fn basis(&self, key: &str, at: &Range<usize>) -> Option<String> {
        let place = (self.written?)(at);
        let behind = self.source.as_ref().map(|source| format!("; {source}"));
        let behind = behind.unwrap_or_default();
        Some(format!("{}: {key} ({place}{behind})", self.dialect.spelling))
    }
}
