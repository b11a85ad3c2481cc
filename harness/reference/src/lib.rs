//! The reference implementation of Structured Text that Stickler judges its own cases with.
//!
//! A source text goes through four rooms: [`syntax`] reads it into a tree, [`semantics`] checks the tree and
//! lowers it to an [`instruction::Program`], [`execution`] runs that program, and [`conversion`] holds every
//! rule about values that change their type. [`Dialect`] is the one place where a dialect's name becomes
//! behaviour. Nothing here panics on any input: each stage returns its result and its diagnostics.
//!
//! Architecture Invariant: this crate knows no files, no threads, no cases and no engines.

pub mod conversion;
pub mod diagnostic;
pub mod dialect;
pub mod execution;
pub mod instruction;
mod raw;
pub mod semantics;
pub mod source;
pub mod syntax;

pub use dialect::Dialect;
