//! Finds the causes of failing cases: what one change in a compiler would put right.
//!
//! | step | done by |
//! |---|---|
//! | while a run goes on, failing cases with the same symptom and programs of the same shape are grouped | [`FailedCases`]; `failure_sign`, `shape` |
//! | a program of several scans becomes one that does the same in one | `scans` |
//! | after it, the smallest program of each group is reduced on the engine while its symptom stays | `reduction`, `guard`, `question`; `reduced_group` |
//! | the reducer goes on to its normal form: an operand alone, fewer statements, plainer types and numbers | `normal_form`, `passes`; `alone`, `forms`, `plainness` |
//! | groups whose normal forms have the same essence become one [`Cause`](stickler_run::Cause): the symptom, what of a compiler's work it needs, and the class of its values | `essence`, `line_features`, `malformed`, `patterns`; `work` with `work.toml`; [`find()`], `growing_cause` |
//! | the claim of a case is shown with a program of which it still speaks; where only a plainer program shows the cause, the document that promises its construct is cited | `claim`, `promised` |
//! | the engine is asked how far the cause goes: with other types, and with other numbers | `neighbours` |
//! | the files and commands of a cause, and what they print, are those of its program | `reproduce` |
//! | the title is what the engine does, and the line at fault with what is wrong with it | `title`, `lines`, `suspect`, `value_lines` |
//!
//! All of them read a program by its tree, in `program`, and by its `words` where nobody can read it.
//!
//! [`CauseKey`] says of one small program which cause it shows, without asking the engine: by it a fuzz campaign tells its
//! findings from each other and from the causes of a run.
//!
//! What each form of a program keeps and forgets:
//!
//! - The *failure sign* keeps the symptom and, where that says too little, the kind of token or the operations at fault; it
//!   forgets the rest of the program.
//! - The *shape* keeps the structure and the functions; it forgets names, the order of declarations, and which of the types
//!   and literals of one kind stand there.
//! - The *forms* of a program are variants of it with fewer statements, or other operands, types and literals.
//! - The *normal form* keeps only what the engine needs to fail in the same way; it forgets all types, numbers and statements
//!   that plainer ones can replace.
//! - The *essence* keeps the features that matter for the defect; it forgets the text, and mostly the place.
//!
//! The reference says of each smaller program what must happen. Of values, only those count that the case itself asserts and
//! whose expected value the reduction did not change.
//!
//! *Architecture invariant:* it knows no report; what it finds depends on the answers of the engine, and on the time only
//! where a limit of time ends the search.

mod alone;
mod claim;
mod compiler_place;
mod declared_first;
mod essence;
mod failed;
mod failure_sign;
mod find;
mod forms;
mod growing_cause;
mod guard;
mod key;
mod line_features;
mod lines;
mod loop_limits;
mod malformed;
mod neighbours;
mod normal_form;
mod passes;
mod patterns;
mod plainness;
mod program;
mod promised;
mod question;
mod reduced_group;
mod reduction;
mod rendered_text;
mod reproduce;
mod scans;
mod shape;
mod smaller_case;
mod smaller_programs;
mod suspect;
#[cfg(test)]
mod tests;
mod title;
mod value_lines;
mod ways;
mod words;
mod work;

pub use failed::FailedCases;
pub use find::{CauseProgress, Search, SearchLimits, find};
pub use key::CauseKey;
