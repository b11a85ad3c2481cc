//! The reference implementation of Structured Text that Stickler judges its own cases with.
//!
//! A source text takes these steps; none of them panics on any input, and each returns its result and its diagnostics:
//!
//! - [`stickler_syntax::parse`] reads it to a [tree](stickler_syntax::tree::SourceUnit), which [`stickler_syntax::render`]
//!   writes back;
//! - [`semantics::check`] checks the tree and lowers it to a [`CheckedProgram`](semantics::CheckedProgram), whose
//!   instructions are in [`instruction`];
//! - [`execution::Machine`] runs that program.
//!
//! [`conversion`] holds every rule about values that change their type: [`implicit`](conversion::implicit) and the
//! catalogue of conversion [functions](conversion::function). What dialects choose differently is asked of a
//! [`Dialect`](stickler_types::Dialect).
//!
//! [`check`], [`run`] and [`render`] take these steps in order:
//!
//! ```
//! use stickler_reference::{Limits, run};
//! use stickler_types::{DialectName, Observation, Outcome, RunRequest, Value};
//!
//! let source = "PROGRAM main VAR big : DINT := 100000; small : INT; END_VAR
//!     small := DINT_TO_INT(big); END_PROGRAM";
//! let observe = [Observation::last("small", "INT")];
//! let request = RunRequest::once(DialectName::MATIEC, source, &observe);
//! let small = Value::parse("INT#-31072").expect("a typed literal");
//! let values = vec![("small".to_owned(), small)];
//! assert_eq!(run(&request, Limits::default()), Ok(Outcome::executed(values)));
//! ```
//!
//! Architecture Invariant: this crate knows no files, no threads, no cases and no engines.

pub mod addresses;
mod api;
pub mod conversion;
pub mod execution;
pub mod instruction;
mod library;
mod raw;
pub mod semantics;

pub use api::{Limits, RequestError, check, check_bytes, errors, execute, locate, render, run, variables};
pub use library::has_block;
pub use semantics::place_of_input;
