//! The reducer: a program that shows a defect made as small as it can be and still show it.
//!
//! | what | reduced by |
//! |---|---|
//! | anything, by passes and a predicate | [`minimise`] |
//! | a [`Program`](crate::model::Program) of the generator: every candidate is well-typed by construction | [`program`] |
//! | any source text, by the reference's syntax tree: no candidate is ill-formed unless the text was | [`text`] |
//! | how an engine's outcome differs from what must come | [`Symptom`] |

mod program;
mod search;
mod symptom;
mod text;

pub use program::program;
pub use search::{
    Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, Sites, StopReason, minimise,
};
pub use symptom::{Symptom, UnknownSymptom};
pub use text::text;
