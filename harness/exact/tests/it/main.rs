//! Exact arithmetic from the outside, in one program: each of its own would be linked once more.

mod basis;
mod catalogue;
mod implicit;
mod round_trips;
mod small_sources;
mod values;
