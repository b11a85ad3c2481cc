//! Integration tests of the engines in one program, since each program of its own would be linked once more.

mod compilers;
mod conversations;
mod fixture;
#[cfg(unix)]
mod process;
#[cfg(unix)]
mod reproduction;
#[cfg(unix)]
mod stand_ins;
