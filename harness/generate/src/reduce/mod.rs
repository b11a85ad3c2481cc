//! The reducer: a program that shows a defect made as small as it can be and still show it.
//!
//! | what | reduced by |
//! |---|---|
//! | anything, by passes and a predicate | [`minimise`] |
//! | a [`Program`](crate::model::Program) of the generator: every candidate is well-typed by construction | [`program`] |

mod program;
mod search;

pub use program::{METHOD, program};
pub use search::{Answer, Budget, Ended, Method, Minimised, Pass, Sites, minimise};
