//! The case format from outside: files in, cases and mistakes out.

mod common;
mod folder;
mod matrices;
mod programs;
mod rows;
mod shipped;
