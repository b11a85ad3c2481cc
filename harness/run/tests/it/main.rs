//! Tests of the crate from outside: cases made by hand, and engines that only pretend.

mod caching;
mod defined;
mod examples;
mod fixtures;
mod inherited;
mod lacks;
mod packing;
mod scheduling;
mod suggestions;
mod suite;
mod words;
