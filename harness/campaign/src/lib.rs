//! Fuzz campaigns without libFuzzer: programs from a seed, engines side by side, findings that are kept.
//!
//! [`run`] gives out places of a seed's row to workers of a [`Bench`], takes their [`Verdict`]s in order, has what is
//! suspicious made small, and tells each [`Finding`] once. [`Store`] keeps findings in a folder.
//!
//! Architecture Invariant: this crate knows no terminal and no command line.
#![forbid(unsafe_code)]

mod basis;
mod bench;
mod commands;
mod differential;
mod expressions;
pub mod finding;
mod inputs;
mod merge;
mod oracles;
mod plan;
mod promote;
pub mod record;
mod replay;
mod run;
#[cfg(test)]
mod sample;
mod shrink;
mod store;
mod texts;
mod without;

pub use bench::{Bench, Suspicion, Verdict, Worker};
pub use commands::Commands;
pub use differential::{Differential, Entrant, Packs};
pub use finding::Finding;
pub use inputs::Inputs;
pub use merge::{Merged, merge};
pub use oracles::Oracles;
pub use plan::{Plan, Until};
pub use promote::{FOUND, PromoteError, Promoted, Words, promote};
pub use record::{Record, Request};
pub use replay::{Replayed, replay};
pub use run::{CampaignError, Ended, Event, Progress, Summary, run};
pub use store::{Saved, Store, StoreError, load};
pub use without::{UnknownWord, Without};
