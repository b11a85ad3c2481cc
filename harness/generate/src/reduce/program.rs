//! Programs of the model made smaller.
//!
//! Every candidate is well-typed, because each pass keeps the type of what it changes. Whether a candidate is free of what
//! the documents leave open, and whether it ends, the predicate has to ask of the evaluator before it starts an engine.

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

pub use method::program;
