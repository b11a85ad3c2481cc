//! The values at which conversions go wrong, in three levels of detail.
//!
//! | what is wanted | function | how many values |
//! |---|---|---|
//! | a list that a person reads, of which the ids of cases are made | [`boundaries`] | some dozens |
//! | an engine that must be asked for each value | [`neighbourhoods`] with [`BoundaryDetail::Coarse`] | some thousands |
//! | exact arithmetic in this process | [`neighbourhoods`] with [`BoundaryDetail::Fine`] | some ten thousands |
//!
//! A list that depends on the called function, on both types of a pair or on the needs of a random program is kept by its
//! user, which takes the boundaries of one type from here.

mod listed;
mod neighbours;

pub use listed::{boundaries, ordinary, other_than, telling};
pub use neighbours::{BoundaryDetail, neighbourhoods};
