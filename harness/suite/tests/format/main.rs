//! The case format from outside: files in, cases and mistakes out.

mod common;
mod defined;
mod folder;
mod matrices;
mod places;
mod programs;
mod rows;
mod shipped;
