//! The passes over a program in their order, and the one function that runs them.

use super::{declarations, statements, weight};
use crate::model::Program;
use crate::reduce::{Answer, Budget, Method, Minimised, Pass, minimise};

/// How programs are reduced: first what makes many lines go at once, last what makes one literal nicer.
pub const METHOD: Method<Program> = Method {
    passes: &[
        Pass {
            name: "drop statements of main",
            edit: statements::drop_of_main,
        },
        Pass {
            name: "drop what is not used",
            edit: declarations::drop_unused,
        },
        Pass {
            name: "drop statements",
            edit: statements::drop_anywhere,
        },
        Pass {
            name: "replace statements by what they guard",
            edit: statements::splice,
        },
        Pass {
            name: "drop branches",
            edit: statements::drop_branches,
        },
    ],
    weight: weight::of,
    key: weight::key,
};

/// Makes a program as small as it can be while it stays interesting.
///
/// `interesting` is asked about `start` first, and then about each candidate. It should answer [`Answer::Refused`] where the
/// evaluator refuses the program or something opens in it, and ask an engine only about the others. The result is the
/// same for the same answers.
pub fn program(
    start: &Program,
    mut interesting: impl FnMut(&Program) -> Answer,
    budget: &Budget<'_>,
) -> Minimised<Program> {
    minimise(start.clone(), &METHOD, &mut interesting, budget)
}
