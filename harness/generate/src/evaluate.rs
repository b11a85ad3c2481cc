//! What a program must do, by the documents alone: an evaluator of the model, and what it met that no document settles.
//!
//! It is a third opinion beside the reference and a compiler. It walks the typed tree of [`crate::model`], in which every
//! conversion is a node, computes integers in 128 bits and wraps them, rounds each operation of reals once, and asks
//! [`stickler_exact`] about conversions. Architecture Invariant: nothing here knows the reference, its tree or its machine.
//!
//! | file | holds |
//! |---|---|
//! | `answer` | what comes out: values, open questions, refusals |
//! | `layout` | how many cells a type takes, and where its parts are |
//! | `memory` | cells, and the places of a program in them |
//! | `start` | initial values |
//! | `statements`, `calls`, `expressions` | the walk |
//! | `arithmetic`, `ordering`, `standard`, `conversions` | what operators and functions give |

mod answer;
mod arithmetic;
mod calls;
mod cell;
mod conversions;
mod evaluator;
mod expressions;
mod layout;
mod memory;
mod ordering;
mod standard;
mod start;
mod statements;
#[cfg(test)]
pub(crate) mod tests;

pub use answer::{Evaluation, EvaluationError, OpenPoint, OpenQuestion};
pub use evaluator::{MAX_STEPS, evaluate};
