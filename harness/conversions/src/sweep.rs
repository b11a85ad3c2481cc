//! The sweep of a conversion function: compares its results for every input, or a large sample, with exact arithmetic.
//!
//! [`agenda()`] turns the name of a function into [`Sweep`]s, one for each pair of types and each distinct rule of the
//! dialects; [`run()`] takes all inputs of one of them, a [`Domain`], through a [`Converter`] (on the reference that is its own
//! conversion) and gives [`SweepFindings`]. [`foreign`] does the same with an engine that only executes programs.

mod agenda;
mod comparison;
mod domain;
mod findings;
pub mod foreign;
mod reference;

pub use agenda::{AgendaError, Sweep, SweepMethod, agenda};
pub use comparison::{Converter, run};
pub use domain::{Domain, Operands, Sampling, TextOperands};
pub use findings::{Difference, MAX_DIFFERENCES, SweepFindings, SweepProgress};
pub use reference::ReferenceFunction;
