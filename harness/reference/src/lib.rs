//! The reference implementation of Structured Text that Stickler judges its own cases with.
//!
//! A source text goes through four rooms: [`syntax`] reads it into a tree, [`semantics`] checks the tree and
//! lowers it to an [`instruction::Program`], [`execution`] runs that program, and [`conversion`] holds every
//! rule about values that change their type. [`Dialect`] is the one place where a dialect's name becomes
//! behaviour. Nothing here panics on any input: each stage returns its result and its diagnostics.
//!
//! [`check`], [`run`] and [`render`] go through the rooms in order:
//!
//! ```
//! use stickler_reference::{Limits, run};
//! use stickler_types::{DialectName, Observation, Outcome, RunRequest, Value};
//!
//! let source = "PROGRAM main VAR big : DINT := 100000; small : INT; END_VAR
//!     small := DINT_TO_INT(big); END_PROGRAM";
//! let observe = [Observation::last("small", "INT")];
//! let request = RunRequest::once(DialectName::Matiec, source, &observe);
//! let small = Value::parse("INT#-31072").expect("a typed literal");
//! let values = vec![("small".to_owned(), small)];
//! assert_eq!(run(&request, Limits::default()), Ok(Outcome::Executed { values }));
//! ```
//!
//! Architecture Invariant: this crate knows no files, no threads, no cases and no engines.

pub mod conversion;
pub mod decoding;
pub mod diagnostic;
pub mod dialect;
pub mod execution;
mod face;
pub mod instruction;
mod raw;
pub mod semantics;
pub mod source;
pub mod syntax;

pub use dialect::{COMMON_CHOICES, Dialect};
pub use face::{Limits, RequestError, check, check_bytes, render, run, variables};
