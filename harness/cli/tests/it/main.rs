//! Tests of the command line, in one program, since each further test program would be linked separately.

mod adapter;
mod common;
#[cfg(unix)]
mod interrupts;
mod links;
#[cfg(unix)]
mod pages;
mod run;
#[cfg(unix)]
mod workflows;
