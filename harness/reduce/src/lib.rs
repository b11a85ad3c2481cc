//! The reducer: makes a program that shows a defect as small as possible.
//!
//! | what | where |
//! |---|---|
//! | a source text made small, by passes and a predicate, or a judge of several texts at a time | [`text`], [`text_in_packs`] |
//! | anything made small, by [`Pass`]es of its own; candidates one by one, or in packs | [`minimise`] |
//! | the passes for texts, alone or beside others in a [`ReductionMethod`] | [`PASSES`], [`text_pass!`] |
//! | a text under reduction, and what a pass asks of it | [`TextDraft`], [`TextView`] |
//!
//! A pass for texts lists changes to a text; the search decides which of them to make. So a pass that somebody adds is a
//! function from a [`TextView`] to a list of [`Edits`](stickler_syntax::Edits), and has no part in the search.
//!
//! Architecture Invariant: this crate knows no engines, cases or causes; a predicate says what is interesting.

mod draft;
mod method;
mod passes;
mod rules;
mod search;
#[cfg(test)]
mod tests;
mod view;

pub use draft::TextDraft;
pub use method::{METHOD, PASSES, text, text_in_packs};
pub use passes::declarations::{drop_units, drop_unused, unit_to_program};
pub use rules::{ReferenceRules, TextRules, TextState};
pub use search::{
    CandidateJudge, Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, Sites, StopReason,
    minimise,
};
pub use view::TextView;

/// Creates a pass over texts from its name and a function that lists the changes, in the order in which they are tried.
#[macro_export]
macro_rules! text_pass {
    ($name:literal, $find:expr) => {
        $crate::Pass {
            name: $name,
            edit: |draft, sites| $crate::TextDraft::change(draft, $name, sites, $find),
        }
    };
}
