//! Fills in the tables of conversion functions of the conformance suite: which calls they have, and what each call gives.
//!
//! A person writes a table's head in its case file: title, basis, summary, dialects, columns, and the probes with their programs.
//! The rows below it are either listed by hand or follow from the file's [`[generate]`](stickler_suite::Generate) table. In both
//! cases the cells that can be computed are computed here.
//!
//! | question | module |
//! |---|---|
//! | What does a case file say? | [`table`] |
//! | Which operands does an entry of `inputs` stand for? | [`inputs`], [`lists`] |
//! | Which calls does a table have? | [`generate`], [`call`] |
//! | May a probe claim that? | [`claim`] |
//! | What stands in which cell? | [`call`] |
//! | Does the folder have the rows that it must have? | [`folder`] |
//! | What do IEC 60559 and two's complement suggest where a table only records? | [`folder`] |
//!
//! The tables of [`blocks`] are of sequences of scans, whose results a model gives.
//!
//! *Architecture Invariant:* every expected value and every basis of a call comes from `stickler_exact`. This crate must not know the
//! reference implementation, which is held to what it writes, and it never reads a computed cell: a wrong one cannot survive.

pub mod blocks;
pub mod call;
pub mod claim;
mod every_dialect;
pub mod folder;
pub mod generate;
pub mod inputs;
pub mod lists;
pub mod table;
