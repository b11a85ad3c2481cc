//! Fuzz campaigns without libFuzzer: programs from a seed, engines side by side, findings that are kept.
//!
//! [`run`] gives out places of a seed's row to workers of a [`Bench`], takes their [`Verdict`]s in order, has what is
//! suspicious made small, and tells each [`Finding`] once. [`Store`] keeps findings in a folder.
//!
//! Architecture Invariant: this crate knows no terminal and no command line.
#![forbid(unsafe_code)]

mod bench;
pub mod finding;
mod fingerprint;
mod part;
mod plan;
mod run;
#[cfg(test)]
mod sample;
mod store;

pub use bench::{Bench, Suspicion, Verdict, Worker};
pub use finding::Finding;
pub use part::Part;
pub use plan::{Plan, Until};
pub use run::{Ended, Event, Progress, Summary, run};
pub use store::{Saved, Store, StoreError, load};
