//! Tests of the crate from outside: cases made by hand, and engines that only pretend.

mod baselines;
mod binding;
mod blessing;
mod caching;
mod fixtures;
mod inherited;
mod judging;
mod packing;
mod rendering;
mod scheduling;
mod selecting;
mod suggestions;
mod suite;
