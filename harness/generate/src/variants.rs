//! Variants of a program: other texts that mean the same, so that whoever runs both must get the same values.
//!
//! An error that makes every text of a program wrong in the same way is the evaluator's to find. A variant finds what depends
//! on the spelling, on what a compiler knows when it compiles, or on the way that control takes.
//!
//! | file | varies |
//! |---|---|
//! | `spelling` | the text alone, by the writer's styles |
//! | `capitals` | the case of every letter that has none to keep |
//! | `literals` | literals: into variables and constants, or written with their type |
//! | `operands` | the order of operands, and where their values stand meanwhile |
//! | `loops` | loops: unrolled, or their first turn put in front |
//! | `dead_code` | statements that are never reached, or change nothing |
//! | `branches` | the two sides of an IF |
//! | `walk` | nothing; it finds the parts of a program |

mod branches;
mod capitals;
mod dead_code;
mod literals;
mod loops;
mod operands;
mod spelling;
#[cfg(test)]
pub(crate) mod tests;
mod variant;
mod walk;

pub use variant::Variant;
