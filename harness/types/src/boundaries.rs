//! The values at which conversions go wrong, in three levels of detail.
//!
//! | what is wanted | function | how many values |
//! |---|---|---|
//! | a list that a person reads, of which the ids of cases are made | [`boundaries`] | some dozens |
//! | an engine that must be asked for each value | [`neighbourhoods`] with [`Detail::Coarse`] | some thousands |
//! | exact arithmetic in this process | [`neighbourhoods`] with [`Detail::Fine`] | some ten thousands |
//!
//! Lists that depend on the function that is called, on both types of a pair or on what a random program can bear stand with their
//! users; where they need the boundaries of one type, they take them from here.

mod listed;
mod neighbours;

pub use listed::{boundaries, ordinary, other_than};
pub use neighbours::{Detail, neighbourhoods};
