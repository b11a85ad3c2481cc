//! A table file as both kinds of expansion use it.

use crate::frame::FileContext;
use crate::table::keys::TableFile;
use crate::template::{BasisTemplate, Template};
use stickler_types::DialectName;

/// The number of mistakes in one file after which the rest is dropped, because they have one cause.
pub(crate) const MAX_MISTAKES: usize = 50;

/// A table file, as the expansions of both kinds of table use it.
pub(crate) struct TableExpansion<'a> {
    pub(crate) context: &'a FileContext<'a>,
    pub(crate) file: &'a TableFile,
    /// The dialects of the file; `None` if it does not name any.
    pub(crate) dialects: Option<Vec<DialectName>>,
    pub(crate) title: Template,
    pub(crate) basis: Option<BasisTemplate>,
}
