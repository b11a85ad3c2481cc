//! What the oracles ask of a syntax tree of the reference: its shape, and whether its places are right.

mod declarations;
mod expressions;
mod places;
mod shape;
mod statements;
mod visitor;
mod walk;

pub(super) use places::{hold_places, is_inside};
pub(super) use shape::shape;
