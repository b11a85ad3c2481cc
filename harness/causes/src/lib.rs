//! Finds the causes of failing cases: what one mend in a compiler would put right.
//!
//! | step | done by |
//! |---|---|
//! | while a run goes on, failing cases with the same symptom and programs of the same shape are grouped | [`FailedCases`]; `sign`, `shape` |
//! | after it, the smallest program of each group is reduced on the engine while its symptom stays | `reduction`, `guard`, `question` |
//! | the reducer goes on to its normal form: an operand alone, fewer statements, plainer types and numbers | `normal`, `passes`; `alone`, `forms`, `values` |
//! | groups whose normal forms have the same essence become one [`Cause`](stickler_run::Cause): the symptom, what of a compiler's work it needs, and the class of its values | `essence`, `marked`, `malformed`, `patterns`; `work` with `work.toml`; [`find()`], `growing_cause` |
//! | the claim of a case is shown with a program of which it still speaks; what a plainer program shows, with who promises its construct | `claim`, `promised` |
//! | the title is what the engine does, and the line at fault with what is wrong with it | `title`, `lines`, `suspect`, `origin` |
//!
//! All of them read a program by its tree, in `program`, and by its `words` where nobody can read it.
//!
//! [`CauseKey`] says of one small program which cause it shows, without asking the engine: a fuzz campaign tells its findings
//! apart by it, and from what a run has shown.
//!
//! A *shape* is a program in which names, types and literals of one kind are equal. The reference says of each smaller
//! program what must happen; where values are compared, only those count that the case itself asserts and that stay what
//! its document says.
//!
//! *Architecture invariant:* it knows no report; what it finds depends on the answers of the engine, and on the time only
//! where a limit of time ends the search.
#![forbid(unsafe_code)]

mod alone;
mod claim;
mod essence;
mod failed;
mod find;
mod forms;
mod growing_cause;
mod guard;
mod key;
mod lines;
mod malformed;
mod marked;
mod normal;
mod origin;
mod passes;
mod patterns;
mod program;
mod promised;
mod question;
mod reduction;
mod shape;
mod sign;
mod suspect;
#[cfg(test)]
mod tests;
mod title;
mod values;
mod words;
mod work;

pub use failed::FailedCases;
pub use find::{CauseProgress, Search, SearchLimits, find};
pub use key::CauseKey;
