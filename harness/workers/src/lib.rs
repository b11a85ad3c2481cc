//! Divides work among the threads of one machine, and among several machines.
//!
//! A [`WorkerPool`] runs tasks on threads. Each thread has a worker of its own, such as the sessions of the engines that it
//! asks; results come back to the caller's thread, where a [`Reorder`] puts them back into the order of their tasks. A
//! [`Cancellation`] asks work to stop before its end. A [`Shard`] is the part of a run or a campaign that one of several
//! machines does.
//!
//! Architecture Invariant: this crate knows neither engines nor cases. What is done, and in which order, its users say.

mod cancellation;
mod pool;
mod reorder;
mod shard;

pub use cancellation::Cancellation;
pub use pool::{SpawnError, Supervisor, WorkerPool};
pub use reorder::Reorder;
pub use shard::{Shard, ShardError};
