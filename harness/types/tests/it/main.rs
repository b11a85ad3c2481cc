//! Tests of the crate's public types and values, in one test program to save linking time.

mod dates_and_times;
mod elementary_types;
mod literals;
mod values;
