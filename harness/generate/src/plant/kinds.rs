//! The kinds of errors: one function a kind, and the table of them all.

mod bits;
mod blocks;
mod calls;
mod constants;
mod declarations;
mod left_out;
mod literals;
mod misfits;
mod names;
mod operands;
mod statements;
mod table;

pub(super) use table::KINDS;
