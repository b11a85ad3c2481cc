//! The kinds of errors: one function a kind, and the table of them all.

mod bits;
mod blocks;
mod calls;
mod constants;
mod declarations;
mod literals;
mod misfits;
mod names;
mod omitted_conversions;
mod operands;
mod statements;
mod table;

pub(super) use table::KINDS;
