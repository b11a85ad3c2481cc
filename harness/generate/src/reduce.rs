//! The reducer for programs of the model: every candidate is well-typed by construction.
//!
//! [`OutcomeSymptom`] says how the outcome of an engine differs from the expected one, and [`deviation`] how from the values of the evaluator.

mod program;
mod symptom;

pub use program::program;
pub use symptom::{OutcomeSymptom, UnknownSymptom, deviation, diagnostic_line};
