//! An evaluator of the model: the values that a program must have by the documents alone, and the questions that it raises
//! which no document answers.
//!
//! The evaluator is a third opinion beside the reference and a compiler. It walks the typed tree of [`crate::model`], in
//! which every conversion is a node, computes integers in 128 bits and wraps them, rounds each operation on reals once, and
//! asks [`stickler_exact`] about conversions. Architecture Invariant: nothing here knows the reference, its syntax tree or
//! its machine.
//!
//! | file | holds |
//! |---|---|
//! | `answer` | results: values, open questions, errors |
//! | `evaluator` | the state of an evaluation, and its course |
//! | `memory` | cells, and the places of a program in them |
//! | `start` | initial values |
//! | `statements`, `calls`, `expressions` | the walk |
//! | `arithmetic`, `standard`, `conversions` | the results of operators and functions |

mod answer;
pub(crate) mod arithmetic;
mod calls;
mod conversions;
mod evaluator;
mod expressions;
mod memory;
mod standard;
mod start;
mod statements;
#[cfg(test)]
mod tests;

use answer::{Evaluated, ill_formed};
pub use answer::{Evaluation, EvaluationError, OpenPoint, OpenQuestion};
pub use evaluator::{CYCLE, MAX_STEPS, evaluate};
