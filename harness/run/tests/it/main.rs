//! The crate from outside: cases made by hand, engines that only pretend.

mod baselines;
mod blessing;
mod fixtures;
mod judging;
mod packing;
mod remembering;
mod rendering;
mod scheduling;
mod selecting;
mod suggestions;
mod suite;
mod unstated;
