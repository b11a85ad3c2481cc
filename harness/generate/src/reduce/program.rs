//! Reduction of programs of the model.
//!
//! Every candidate is well-typed, because each pass keeps the types of what it changes. Whether a candidate terminates and
//! avoids what documents leave open, the predicate must ask the evaluator before it starts an engine.

mod declarations;
mod expressions;
mod forget;
mod lift;
mod method;
mod plain;
mod promote;
mod removal;
mod shapes;
mod soundness;
mod statements;
#[cfg(test)]
mod tests;
mod unwrap;
mod usage;
mod values;
mod weight;

pub use method::{program, program_in_packs};
