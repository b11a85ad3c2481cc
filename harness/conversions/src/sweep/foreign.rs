//! The sweep of an engine that only executes programs, by generated ST programs.
//!
//! A source of at most 32 bits is counted through by a loop in the program itself, which adds the results up to a
//! [checksum](Checksum); one program compares thousands or millions of inputs. Where the sum is not that of the exact
//! results, programs over half of the inputs follow, and so on until few are left, whose results are then observed one
//! by one. Other sources, samples, and results that cannot be added up go through in lists of literals, every result
//! observed.
//!
//! A difference is a mismatch only where a document says what must come; elsewhere it is an observation. What the engine
//! does not answer (it rejects the program, faults, crashes, takes too long) is neither: it is counted with its reason.
//!
//! The programs rely on little beside the function under test. All of them need variables with initial values, and literals
//! read as the nearest value. Programs that count through the operands also rely on:
//!
//! | for | they rely on |
//! |---|---|
//! | the loop | `REPEAT`, `IF`, `DINT` comparison and addition |
//! | integer operands | adding 1 in the operand's type, never past its limit |
//! | bit-string operands | adding 1 in the unsigned type of equal width, and `USINT_TO_BYTE`, `UINT_TO_WORD` or `UDINT_TO_DWORD` |
//! | REAL operands | adding the unit in the last place within a binade, which no format or rounding changes |
//! | the sum | `LINT` addition, multiplication and `MOD` of numbers from 0 below 2^62 |
//! | integer results | `<type>_TO_LINT` of what fits; of 64 bits `/` and `MOD` by 2^32 |
//! | bit-string results | `<type>_TO_LINT`, of LWORD `LWORD_TO_ULINT` |
//! | real results | comparing LREALs, products with powers of two, `LREAL_TO_LINT` of whole numbers below 2^53, of REAL also `REAL_TO_LREAL` |
//!
//! Where the engine gets one of these wrong, sums differ though each result is right; such inputs are counted separately
//! ([`ForeignFindings::unexplained`]).

mod checksum;
mod counter;
mod findings;
mod plan;
mod queue;
mod run;
#[cfg(test)]
mod tests;
mod worker;

pub use checksum::Checksum;
pub use findings::{ForeignFindings, Unanswered};
pub use plan::has_digest;
pub use run::{ForeignError, run};
