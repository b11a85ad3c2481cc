//! Random well-typed Structured Text programs, and what is done with them: evaluation, variants, planted faults, reduction,
//! and the oracles of the fuzz targets.
//!
//! | module | holds |
//! |---|---|
//! | [`model`] | a typed [`Program`](model::Program), and its visitors [`visit`](model::visit) and [`visit_mut`](model::visit_mut) |
//! | [`generator`] | [`program`](generator::program): bytes to a program, within [`GeneratorSettings`](generator::GeneratorSettings) |
//! | [`writer`] | [`write`](writer::write): a program to its text, in a [`Style`](writer::Style) |
//! | [`reader`] | [`read`](reader::read): a text back to its program |
//! | [`evaluate`] | [`evaluate`](evaluate::evaluate()): the values that documents give a program, or an [`EvaluationError`](evaluate::EvaluationError) |
//! | [`variants`] | other texts with the same values: [`Variant`](variants::Variant) |
//! | [`plant`] | programs with one error: [`Planted`](plant::Planted) |
//! | [`features`] | the features of the language that a program uses |
//! | [`reduce`] | the smallest program that still shows a defect: [`program`](reduce::program), [`OutcomeSymptom`](reduce::OutcomeSymptom) |
//! | [`oracles`] | the judgement of one fuzz input: [`FuzzTarget`](oracles::FuzzTarget), [`OracleFailure`](oracles::OracleFailure) |
//! | [`random`] | choices made by bytes |
//!
//! Architecture Invariant: this crate knows neither libFuzzer nor files nor threads. All randomness comes from bytes.

pub mod evaluate;
pub mod features;
pub mod generator;
pub mod model;
pub mod oracles;
pub mod plant;
pub mod random;
pub mod reader;
pub mod reduce;
pub mod variants;
pub mod writer;
