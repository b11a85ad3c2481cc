//! Variants of a program: other texts with the same meaning, which must give the same values.
//!
//! The evaluator finds an error that makes every text of a program wrong in the same way. A variant finds an error that
//! depends on the spelling, on what a compiler knows at compile time, or on the control flow.
//!
//! | file | varies |
//! |---|---|
//! | `variant` | the text alone, by the styles of the writer and the case of letters; it names the variants |
//! | `operands` | the order of operands, the variables and constants that hold them, and the types of literals |
//! | `loops` | loops: unrolled, or their first iteration peeled off; the two sides of an IF |
//! | `dead_code` | statements that are never reached, or change nothing |
//! | `walk` | nothing; it finds the parts of a program |

mod dead_code;
mod loops;
mod operands;
#[cfg(test)]
pub(crate) mod tests;
mod variant;
mod walk;

pub use variant::Variant;
