//! Conversion functions: asking an engine for what they give, and comparing that with exact arithmetic.
//!
//! [`sweep`] takes all inputs of a function, or a large sample of them, through the reference or through programs that
//! another engine executes.
//!
//! Architecture Invariant: this crate knows no terminal and no command line.
#![forbid(unsafe_code)]

mod literals;
mod random;
mod session;
pub mod sweep;

pub use random::Scattered;
pub use session::{Refusal, RefusalKind};
