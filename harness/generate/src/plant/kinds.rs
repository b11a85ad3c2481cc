//! The kinds of errors: the table of them all, and a function for each that no edit of the table describes.

mod bits;
mod blocks;
mod calls;
mod constants;
mod declarations;
mod edit;
mod literals;
mod misfits;
mod names;
mod omitted_conversions;
mod operands;
mod statements;
mod table;

pub(super) use table::KINDS;
