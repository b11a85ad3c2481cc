//! The conformance suite as the only judge of a mutated reference.
//!
//! A mutant costs a build and a run, so this crate is what little has to be built for each: the reference, the types, and a
//! reader of cases that somebody else has expanded ([`prepared`]). What a case expects was written down as text by an
//! unmutated program, and the mutant's answer is compared as text ([`judge`]): a mutant of the reading and writing of
//! literals cannot bend the expectation along with the answer. [`lookout`] ends a mutant that never ends.
//!
//! Architecture Invariant: it judges as `stickler-run` judges the reference, by code and line, and knows nothing of case
//! files; `stickler-mutants` prepares the cases.

pub mod judge;
pub mod lookout;
pub mod prepared;
