//! The reducer: makes a program that shows a defect as small as possible.
//!
//! | subject | function |
//! |---|---|
//! | anything, by passes and a predicate | [`minimise`], [`minimise_in_packs`] |
//! | a [`Program`](crate::model::Program) of the generator: every candidate is well-typed by construction | [`program`](program()), [`program_in_packs`] |
//! | any source text, by the syntax tree of the reference: no candidate is ill-formed unless the text was | [`text`](text()) |
//!
//! [`OutcomeSymptom`] says how the outcome of an engine differs from the expected one.

mod program;
mod search;
mod symptom;
mod text;

pub use program::{program, program_in_packs};
pub use search::{
    CandidateJudge, Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, Sites, StopReason,
    minimise, minimise_in_packs,
};
pub use symptom::{OutcomeSymptom, UnknownSymptom};
pub use text::text;
