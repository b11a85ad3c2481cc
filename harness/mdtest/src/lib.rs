//! Tests that are Markdown files.
//!
//! A folder of tests holds `*.md` files. A heading names what the blocks below it show, in a sentence; the first word behind the
//! fence of a block says what the block is, and the test program of the crate says which words it knows. Prose is for people.
//!
//! ````markdown
//! ## A bit is counted from the right
//!
//! ```st ironplc-ed2 matiec
//! PROGRAM main
//! VAR b : BYTE; x : BOOL; END_VAR
//!     x := b.7;
//!     x := b.8;                        (*! error P4025 at `b.8` *)
//! END_PROGRAM
//! ```
//!
//! ```calls matiec
//! # The number modulo 2^16.
//! DINT_TO_INT(DINT#100000) = INT#-31072
//! ```
//! ````
//!
//! Two kinds of blocks are alike wherever they are used:
//!
//! - **programs** are ST, with the [marks](marks) of the conformance cases in comments. A block is one program, or a program on
//!   `each line`, which may stand `in` another text: `st each line in PROGRAM p¶x := …;¶END_PROGRAM`.
//! - **rows** are lines `question = answer`, each on its own. A line that begins with a number sign and a space is a comment.
//!
//! A text of a megabyte is written with repetitions, which [`expanded`] writes out.
//!
//! [`check`] reads a folder, hands each block to a function, and reports all differences with file, line and heading.
//!
//! Where what must come is a whole text, [`check_examples`] compares the [examples](examples) of a file with the texts that a function
//! makes of them, and renews them on demand.
//!
//! A [`schema`] is what a JSON document is held against.
//!
//! Architecture Invariant: this crate knows no language, no dialect and no other crate of Stickler; only tests use it.

mod block;
mod differences;
pub mod examples;
mod folder;
mod markdown;
mod marks;
pub mod schema;

pub use block::{Block, Difference, Program, expanded, same};
pub use differences::{Reported, differences};
pub use examples::{Example, assert_fits, check_examples, fits};
pub use folder::check;
pub use markdown::{Fence, Section, sections};
pub use marks::{Marks, Value};
