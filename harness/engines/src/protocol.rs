//! The wire protocol: JSON Lines over stdin and stdout, one request, one reply, in order.
//!
//! [`Request`] and [`Reply`] are the two directions, and [`serve`] answers requests with any [`Engine`](crate::Engine).
//! Tests compare the JSON Schemas of both with those that are published in `harness/engines/schemas/`. Basis:
//! harness/engines/README.md (the wire protocol).

mod answer;
mod lines;
mod reply;
mod request;
#[cfg(test)]
mod schema;
mod server;

pub use reply::{AcceptedReply, ErrorReply, ExecutedReply, FaultedReply, HelloReply};
pub use reply::{RejectedReply, RenderedReply, Reply, UnsupportedReply};
pub use request::{ClockMessage, HelloRequest, ProgramRequest, Request, RunMessage, SetMessage};
pub use server::serve;

/// The version of the protocol that this crate speaks.
pub const PROTOCOL: u32 = 1;

/// The longest request line that is read, in bytes; a longer one is skipped and answered by an error.
pub const MAX_LINE: usize = 64 << 20;
