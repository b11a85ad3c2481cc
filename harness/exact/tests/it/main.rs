//! Tests of the crate's public functions, in one test program to save linking time.

mod basis;
mod calls;
mod catalogue;
mod round_trips;
mod small_sources;
