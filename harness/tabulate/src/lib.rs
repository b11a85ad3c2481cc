//! The row tables of the conformance suite whose values are computed, not written down by a person.
//!
//! | step | room |
//! |---|---|
//! | which operands? | [`inputs`] |
//! | which calls, in which table, with which claim? | [`families`] |
//! | what does each call give, and who says so? | `stickler_exact`, through [`call`], [`class`] and [`sheet`] |
//! | what stands in which cell? | [`column`], [`program`] |
//! | what does the design suggest where nothing is asserted? | [`suggestion`] |
//! | what does the file look like? | [`text`] |
//! | does the folder have these files? | [`folder`] |
//!
//! The expected values come from exact arithmetic alone. This crate must not know the reference implementation: what it
//! writes is what the reference is held to.
//!
//! *Architecture Invariant:* a table is a function of this program and of `stickler_exact`; nothing is read from the folder
//! that it writes to, so that a wrong file cannot survive.

pub mod call;
pub mod class;
pub mod column;
pub mod families;
pub mod folder;
pub mod inputs;
pub mod operand;
pub mod program;
pub mod sheet;
pub mod suggestion;
pub mod table;
pub mod text;
